// SPDX-License-Identifier: GPL-3.0-or-later
import type { DiagramBackend } from '../editing/editing.ts'
import { loadedOnce } from '../lib/base/loaded-once.ts'
import type { Edit } from '../lib/index.ts'
import { loadRegions } from '../lib/regions.ts'
import type { CircleVoronoi } from '../lib/wasm/library.ts'
import { CircleTable, type KeptIds, NO_CHANGE } from '../view/circle-table.ts'
import { fitted } from '../view/painter/fitted.ts'
import { PaintedScene } from '../view/painter/painted-scene.ts'
import type { Computations, DomainChange } from '../view/protocol.ts'
import type { Edited } from '../view/scene-client.ts'

/** A backend that computes the diagram of a view in the calling thread, in place of a page's worker. */
export class SceneBackend implements DiagramBackend {
  readonly scene: PaintedScene
  circles = new CircleTable(new Float64Array())
  readonly #regions = loadedOnce(() => loadRegions())

  constructor(library: CircleVoronoi) {
    this.scene = new PaintedScene(library)
  }

  async open(circles: Float64Array, change?: DomainChange, kept?: KeptIds): Promise<Edited> {
    const opened = this.scene.open(circles, change, await this.#regionsFor(change), kept)
    this.circles = new CircleTable(Float64Array.from(opened.circles ?? circles), 0, kept)
    return this.#edited(NO_CHANGE, opened.colors)
  }

  async edit(edits: readonly Edit[], domain?: DomainChange): Promise<Edited> {
    const { change, colors } = this.scene.edit(edits, domain, await this.#regionsFor(domain))
    return this.#edited(change, colors)
  }

  async ask(_: 'fit', args: Parameters<Computations['fit']>) {
    return fitted(await this.#regions(), ...args)
  }

  #edited(change: typeof NO_CHANGE, colors: string | undefined): Edited {
    const back = this.circles.follow(change)
    return { counts: this.scene.counts(), inserted: change.inserted, back, colors, seconds: 0 }
  }

  async #regionsFor({ region }: DomainChange = {}) {
    return (region ?? undefined) && this.#regions()
  }
}
