// SPDX-License-Identifier: GPL-3.0-or-later
import type { DiagramBackend } from '../editing/editing.ts'
import { loadRegions } from '../lib/regions.ts'
import type { CircleVoronoi } from '../lib/wasm/library.ts'
import { CircleTable, NO_CHANGE, type UndoEdit } from '../view/circle-table.ts'
import { PaintedScene } from '../view/painter/painted-scene.ts'
import type { DomainChange, Fitted } from '../view/protocol.ts'
import type { Edited } from '../view/scene-client.ts'

/** A backend that computes the diagram of a view in the calling thread, in place of a page's worker. */
export class SceneBackend implements DiagramBackend {
  readonly scene: PaintedScene
  circles = new CircleTable(new Float64Array())

  constructor(library: CircleVoronoi) {
    this.scene = new PaintedScene(library)
  }

  async setCircles(circles: Float64Array, change?: DomainChange): Promise<Edited> {
    const { circles: fittedCircles, fitted, colors } = this.scene.open(circles, change, await regionsFor(change))
    this.circles = new CircleTable(Float64Array.from(fittedCircles ?? circles))
    return this.#edited(NO_CHANGE, fitted, colors)
  }

  async apply(edits: readonly UndoEdit[], domain?: DomainChange): Promise<Edited> {
    const { change, fitted, colors } = this.scene.edit(edits, domain, await regionsFor(domain))
    return this.#edited(change, fitted, colors)
  }

  #edited(change: typeof NO_CHANGE, fitted: Fitted | undefined, colors: string | undefined): Edited {
    const back = this.circles.follow(change)
    return { counts: this.scene.counts(), inserted: change.inserted, back, fitted, colors, seconds: 0 }
  }
}

async function regionsFor({ region, fit }: DomainChange = {}) {
  return (region ?? undefined) === undefined && fit === undefined ? undefined : loadRegions()
}
