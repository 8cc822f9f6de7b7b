// SPDX-License-Identifier: GPL-3.0-or-later
import type { CircleVoronoi, Diagram, PathSink } from '../../lib/index.ts'
import type { Region } from '../../lib/regions/region.ts'
import { localDiagram } from './local-diagram.ts'

/** The region of a scene, and what cells are inside it. */
export class Clip {
  readonly region: Region
  readonly #library: CircleVoronoi

  constructor(library: CircleVoronoi, region: Region) {
    this.#library = library
    this.region = region
  }

  /** The area of a cell inside. It takes no longer in a large diagram. */
  areaOf(diagram: Diagram, i: number): number {
    return this.#alone(diagram, [i])?.cellArea(0, { region: this.region }) ?? 0
  }

  /** The perimeter of a cell inside. */
  perimeterOf(diagram: Diagram, i: number): number {
    return this.#alone(diagram, [i])?.cellPerimeter(0, { region: this.region }) ?? 0
  }

  /** Draws the cells of circles inside. */
  drawCells(context: PathSink, diagram: Diagram, circles: readonly number[], tolerance: number): void {
    const there = circles.filter((i) => diagram.cells.exists(i))
    const local = this.#alone(diagram, there)
    const { region } = this
    there.forEach((_, k) => {
      local?.cellPath(k, { context, region, tolerance })
    })
  }

  #alone(diagram: Diagram, circles: readonly number[]): Diagram | undefined {
    const isThere = circles.length > 0 && circles.every((i) => diagram.cells.exists(i))
    return isThere ? localDiagram(this.#library, diagram, circles) : undefined
  }
}
