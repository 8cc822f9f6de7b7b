// SPDX-License-Identifier: GPL-3.0-or-later
import { circleRadius, circleX, circleY } from '../../lib/base/coordinates.ts'
import { at } from '../../lib/base/diagram-data.ts'
import { cross } from '../../lib/base/point.ts'
import type { Box, Edit, Lattice, PeriodicDiagram, Point } from '../../lib/index.ts'
import { DiagramSnapshot } from '../../lib/index.ts'
import type { Region } from '../../lib/regions/region.ts'
import type { CircleVoronoi } from '../../lib/wasm/library.ts'
import { emptyBoxes } from './boxes.ts'
import { addCell, addStar, idOf } from './cell-boxes.ts'

/** The parts of a region that a picture draws. */
export type Border = Pick<Region, 'points' | 'ringOffsets' | 'contains'>

/** Copies are drawn up to this many periods away, in each direction. */
const MOST_PERIODS = 3

/** The box of a scene whose circles repeat. */
export class Torus {
  readonly lattice: Lattice
  /** The outline of the box, with a corner at the origin. */
  readonly border: Border
  readonly area: number
  readonly #library: CircleVoronoi
  readonly #a: Point
  readonly #b: Point

  /** @throws CircleVoronoiError as `computePeriodic`, for periods that span no box */
  constructor(library: CircleVoronoi, lattice: Lattice) {
    library.computePeriodic([], lattice)
    this.#library = library
    this.lattice = lattice
    const [a, b] = [lattice.a, lattice.b].map(([x, y]) => ({ x, y })) as [Point, Point]
    this.#a = a
    this.#b = b
    this.area = Math.abs(cross(a, b))
    this.border = {
      points: Float64Array.of(0, 0, a.x, a.y, a.x + b.x, a.y + b.y, b.x, b.y),
      ringOffsets: Int32Array.of(0, 4),
      contains: (x, y) => {
        const { u, v } = this.#placeOf(x, y)
        return u >= 0 && u < 1 && v >= 0 && v < 1
      },
    }
  }

  /**
   * The diagram of the circles of a snapshot and of their images.
   *
   * @throws CircleVoronoiError as `computePeriodic`
   */
  diagramOf(snapshot: DiagramSnapshot): RepeatedDiagram {
    const { circles, weights } = snapshot
    return new RepeatedDiagram(snapshot, this.#library.computePeriodic(circles, this.lattice, { weights }))
  }

  /** Moves circles into the box; the same array if all lie in it. */
  wrappedCircles(circles: Float64Array): Float64Array {
    const wrapped = circles.map((value, k) =>
      k % 3 === 2 ? value : at(this.#wrapped(at(circles, k - (k % 3)), at(circles, k - (k % 3) + 1)), k % 3),
    )
    return wrapped.every((value, k) => value === circles[k]) ? circles : wrapped
  }

  /** Moves the circle of an edit into the box. */
  wrappedEdit(edit: Edit): Edit {
    if (edit.kind === 'remove') return edit
    const [x, y] = this.#wrapped(circleX(edit.circle), circleY(edit.circle)) as unknown as [number, number]
    return { ...edit, circle: { x, y, r: circleRadius(edit.circle) } }
  }

  #wrapped(x: number, y: number): Float64Array {
    const { u, v } = this.#placeOf(x, y)
    const [k, l] = [Math.floor(u), Math.floor(v)]
    if (!Number.isFinite(k) || !Number.isFinite(l) || (k === 0 && l === 0)) return Float64Array.of(x, y)
    return Float64Array.of(x - k * this.#a.x - l * this.#b.x, y - k * this.#a.y - l * this.#b.y)
  }

  /** The offsets at which copies of the box `own` meet the box `seen`. */
  copiesIn(own: Box, seen: Box): Point[] {
    const moves: Point[] = []
    for (let k = -MOST_PERIODS; k <= MOST_PERIODS; k++) {
      for (let l = -MOST_PERIODS; l <= MOST_PERIODS; l++) {
        const [x, y] = [k * this.#a.x + l * this.#b.x, k * this.#a.y + l * this.#b.y]
        const isSeen =
          own.minX + x <= seen.maxX &&
          own.maxX + x >= seen.minX &&
          own.minY + y <= seen.maxY &&
          own.maxY + y >= seen.minY
        if (isSeen) moves.push({ x, y })
      }
    }
    return moves
  }

  /** A point's coordinates as multiples of the periods. */
  #placeOf(x: number, y: number): { readonly u: number; readonly v: number } {
    const area = cross(this.#a, this.#b)
    return { u: cross({ x, y }, this.#b) / area, v: cross(this.#a, { x, y }) / area }
  }
}

/** The circles of a snapshot by their ids, and their images, which have the ids of their circles. */
export class RepeatedDiagram extends DiagramSnapshot {
  readonly periodic: PeriodicDiagram
  readonly #snapshot: DiagramSnapshot

  constructor(snapshot: DiagramSnapshot, periodic: PeriodicDiagram) {
    const ids = periodic.circleOf.map((i) => idOf(snapshot, i))
    const none = new Int32Array()
    super({ ...periodic.diagram, numbers: { revision: 0, circles: ids, vertices: none, edges: none } })
    this.periodic = periodic
    this.#snapshot = snapshot
  }

  override indexOf(id: number): number {
    return this.#snapshot.indexOf(id)
  }

  /** The point in the box that is equivalent to a point of the plane. */
  home(x: number, y: number): Point {
    const { lattice, shiftOf } = this.periodic
    const image = this.periodic.find(x, y)
    if (image === undefined) return { x, y }
    const { circle, shift } = image
    const [k, l] = [0, 1].map((n) => (shift[n] as number) - at(shiftOf, 2 * circle + n)) as [number, number]
    return { x: x - k * lattice.a[0] - l * lattice.b[0], y: y - k * lattice.a[1] - l * lattice.b[1] }
  }

  /**
   * Whether a side of a given cell is drawn. An edge across the border of the box has two twins, of which one is drawn.
   */
  draws(side: number): boolean {
    const { circleCount } = this.periodic
    const neighbor = this.cells.neighborOf(side)
    if (neighbor < circleCount) return (side & 1) === 0
    const i = this.cells.neighborOf(side ^ 1)
    const { circle, shift } = this.periodic.imageFrom(i, neighbor)
    return i < circle || (i === circle && (shift[0] > 0 || (shift[0] === 0 && shift[1] > 0)))
  }

  /** Boxes around the given circles and their cells, by ids. */
  cellBoxes(reach: number): Float64Array {
    return this.#boxes((boxes, id, i) => addCell(boxes, id, this, i, reach))
  }

  /** Boxes around the centers of the given circles and of their neighbors, by ids. */
  starBoxes(): Float64Array {
    return this.#boxes((boxes, id, i) => addStar(boxes, id, this, i))
  }

  #boxes(add: (boxes: Float64Array, id: number, i: number) => void): Float64Array {
    const { circleCount } = this.periodic
    const ids = Array.from({ length: circleCount }, (_, i) => idOf(this, i))
    const boxes = emptyBoxes(ids.reduce((most, id) => Math.max(most, id + 1), 0))
    ids.forEach((id, i) => {
      add(boxes, id, i)
    })
    return boxes
  }
}
