// SPDX-License-Identifier: GPL-3.0-or-later
import type { Diagram, PathSink } from '../../lib/index.ts'
import { fewCircles } from '../../lib/regions/few-circles.ts'
import type { Region } from '../../lib/regions/region.ts'
import type { CircleVoronoi } from '../../lib/wasm/library.ts'

/** The region of a scene, and the parts of cells inside it. */
export class Clip {
  readonly region: Region
  readonly #library: CircleVoronoi

  constructor(library: CircleVoronoi, region: Region) {
    this.#library = library
    this.region = region
  }

  /** The area of a cell inside the region, in time independent of the size of the diagram. */
  areaOf(diagram: Diagram, i: number, maxDistance: number | undefined): number {
    const { region } = this
    return this.#ofEach(diagram, [i], (few, k) => few.cellArea(k, { region, maxDistance }))[0] ?? 0
  }

  /** The perimeter of a cell inside the region. */
  perimeterOf(diagram: Diagram, i: number, maxDistance: number | undefined): number {
    const { region } = this
    return this.#ofEach(diagram, [i], (few, k) => few.cellPerimeter(k, { region, maxDistance }))[0] ?? 0
  }

  /** Draws the cells of circles inside the region. */
  drawCells(
    diagram: Diagram,
    circles: readonly number[],
    options: { readonly context: PathSink; readonly tolerance: number; readonly maxDistance: number | undefined },
  ): void {
    const { region } = this
    this.#ofEach(diagram, circles, (few, k) => few.cellPath(k, { region, ...options }))
  }

  /** Calls `use` for each existing cell, with a small diagram that contains the same cell. */
  #ofEach<Value>(diagram: Diagram, circles: readonly number[], use: (few: Diagram, k: number) => Value): Value[] {
    const { circles: some, chosen } = fewCircles(
      diagram,
      circles.filter((i) => diagram.cells.exists(i)),
    )
    if (chosen.length === 0) return []
    const few = this.#library.compute(some)
    return Array.from(chosen, (k) => use(few, k))
  }
}
