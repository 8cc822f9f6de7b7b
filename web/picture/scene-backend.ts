// SPDX-License-Identifier: GPL-3.0-or-later
import type { DiagramBackend } from '../editing/editing.ts'
import type { Edit } from '../lib/index.ts'
import { loadRegions } from '../lib/regions.ts'
import type { CircleVoronoi } from '../lib/wasm/library.ts'
import { CircleTable, type KeptIds, NO_CHANGE } from '../view/circle-table.ts'
import { PaintedScene } from '../view/painter/painted-scene.ts'
import type { DomainChange, Fitted } from '../view/protocol.ts'
import type { Edited } from '../view/scene-client.ts'

/** A backend that computes the diagram of a view in the calling thread, in place of a page's worker. */
export class SceneBackend implements DiagramBackend {
  readonly scene: PaintedScene
  circles = new CircleTable(new Float64Array())
  /** One module for all edits, because regions of another one are refused. */
  #regions: ReturnType<typeof loadRegions> | undefined

  constructor(library: CircleVoronoi) {
    this.scene = new PaintedScene(library)
  }

  async open(circles: Float64Array, change?: DomainChange, kept?: KeptIds): Promise<Edited> {
    const opened = this.scene.open(circles, change, await this.#regionsFor(change), kept)
    this.circles = new CircleTable(Float64Array.from(opened.circles ?? circles), 0, kept)
    return this.#edited(NO_CHANGE, opened.fitted, opened.colors)
  }

  async edit(edits: readonly Edit[], domain?: DomainChange): Promise<Edited> {
    const { change, fitted, colors } = this.scene.edit(edits, domain, await this.#regionsFor(domain))
    return this.#edited(change, fitted, colors)
  }

  #edited(change: typeof NO_CHANGE, fitted: Fitted | undefined, colors: string | undefined): Edited {
    const back = this.circles.follow(change)
    return { counts: this.scene.counts(), inserted: change.inserted, back, fitted, colors, seconds: 0 }
  }

  async #regionsFor({ region, fit }: DomainChange = {}) {
    if ((region ?? undefined) === undefined && fit === undefined) return undefined
    this.#regions ??= loadRegions()
    return this.#regions
  }
}
