// SPDX-License-Identifier: GPL-3.0-or-later
import { at, NONE } from '../lib/base/diagram-data.ts'
import { shortestPeriods } from '../lib/diagram/lattice.ts'
import type { Box, Change, Circle, Edit, Float64s, Lattice, Point } from '../lib/index.ts'
import { boundingBox } from './camera.ts'
import { CellIndex } from './cell-index.ts'
import { shortestWith } from './domain.ts'
import type { DomainChange } from './protocol.ts'

/** The part of an editor's change that a table applies. */
export type CircleChange = Pick<Change, 'inserted' | 'removed' | 'replaced' | 'circles'>

export const NO_CHANGE: CircleChange = {
  inserted: new Int32Array(),
  removed: new Int32Array(),
  replaced: new Int32Array(),
  circles: new Float64Array(),
}

/** The ids of circles that continue in another editor (`EditorOptions`). */
export interface KeptIds {
  readonly ids: Int32Array
  readonly nextId: number
}

/** The circle at a point, and the part that was hit: its rim, its disc, or only its cell. */
export interface Hit {
  readonly id: number
  readonly part: 'rim' | 'disc' | 'cell'
  /** The number of small circles within a finger's reach, if the finger hit one of them. */
  readonly inReach?: number
}

/** The multiples of a period from a circle to its images, beginning with the circle itself. */
const AROUND = [0, 1, -1]
/** Number of circles from which the core is estimated. */
const CORE_SAMPLE = 1000

/** The circles of a `DiagramEditor`, by the editor's ids. */
export class CircleTable {
  /** Identifies the opening that the ids belong to. Edits carry this number and are ignored after another opening. */
  readonly opening: number
  #numbers: Float64s
  #isThere: Uint8Array
  #size: number
  #count: number
  #box: Box | undefined
  #core: Box | undefined
  /** The index of cells, and the circles that have changed since it was built. */
  #index: { readonly cells: CellIndex; readonly changed: Set<number>; moved: CellIndex | undefined } | undefined

  /** Without `kept`, circle i of `circles` (x, y and r each) gets id i, and the array is not copied. */
  constructor(circles: Float64s, opening = 0, kept?: KeptIds) {
    this.opening = opening
    if (kept !== undefined) {
      this.#numbers = new Float64Array(3 * kept.nextId)
      this.#size = kept.nextId
      this.#count = kept.ids.length
      this.#isThere = new Uint8Array(this.#size)
      kept.ids.forEach((id, k) => {
        this.#isThere[id] = 1
        this.#numbers.set(circles.subarray(3 * k, 3 * k + 3), 3 * id)
      })
      return
    }
    this.#numbers = circles
    this.#size = circles.length / 3
    this.#count = this.#size
    this.#isThere = new Uint8Array(this.#size).fill(1)
  }

  /** The number of ids ever assigned. All ids are below it. */
  get size(): number {
    return this.#size
  }

  /** The number of circles. */
  get count(): number {
    return this.#count
  }

  /** The number of circles with a lower id. */
  countBelow(id: number): number {
    let count = 0
    for (let k = 0; k < Math.min(id, this.#size); k++) count += this.#isThere[k] as number
    return count
  }

  get(id: number): Circle | undefined {
    if (this.#isThere[id] !== 1) return undefined
    return { x: at(this.#numbers, 3 * id), y: at(this.#numbers, 3 * id + 1), r: at(this.#numbers, 3 * id + 2) }
  }

  /** The next existing id, starting at `id`, in steps of 1 or -1; `undefined` if there is none. */
  next(id: number, step: 1 | -1): number | undefined {
    for (let k = id; k >= 0 && k < this.#size; k += step) if (this.#isThere[k] === 1) return k
    return undefined
  }

  /** Applies a change of the editor. Returns the edits that undo it. */
  follow({ inserted, removed, replaced, circles }: CircleChange): Edit[] {
    this.#box = undefined
    this.#core = undefined
    if (this.#index !== undefined) {
      for (const ids of [inserted, removed, replaced]) for (const id of ids) this.#index.changed.add(id)
      this.#index.moved = undefined
    }
    const back: Edit[] = []
    const newCircle = (k: number): Circle => ({
      x: at(circles, 3 * k),
      y: at(circles, 3 * k + 1),
      r: at(circles, 3 * k + 2),
    })
    inserted.forEach((id, k) => {
      this.#put(id, newCircle(k))
      back.push({ kind: 'remove', id })
    })
    replaced.forEach((id, k) => {
      back.push({ kind: 'replace', id, circle: this.get(id) as Circle })
      this.#put(id, newCircle(inserted.length + k))
    })
    for (const id of removed) {
      back.push({ kind: 'insert', circle: this.get(id) as Circle, id })
      this.#isThere[id] = 0
      this.#count -= 1
    }
    return back.reverse()
  }

  /** The ids for another editor of `circles()`; `undefined` if they are 0, 1 and so on, and no circle was removed. */
  get keptIds(): KeptIds | undefined {
    return this.#count === this.#size ? undefined : { ids: this.ids(), nextId: this.#size }
  }

  /** x, y and r of all circles, by ascending id. */
  circles(): Float64s {
    if (this.#count === this.#size) return this.#numbers.slice(0, 3 * this.#size)
    const circles = new Float64Array(3 * this.#count)
    let k = 0
    for (let id = 0; id < this.#size; id++) {
      if (this.#isThere[id] !== 1) continue
      for (let place = 3 * id; place < 3 * id + 3; place++) circles[k++] = at(this.#numbers, place)
    }
    return circles
  }

  /** The ids, ascending. */
  ids(): Int32Array {
    const ids = new Int32Array(this.#count)
    let k = 0
    for (let id = 0; id < this.#size; id++) if (this.#isThere[id] === 1) ids[k++] = id
    return ids
  }

  /** The ids of the circles with their centers in a box. */
  within({ minX, minY, maxX, maxY }: Box): number[] {
    const ids: number[] = []
    for (let id = 0; id < this.#size; id++) {
      const [x, y] = [at(this.#numbers, 3 * id), at(this.#numbers, 3 * id + 1)]
      if (this.#isThere[id] === 1 && x >= minX && x <= maxX && y >= minY && y <= maxY) ids.push(id)
    }
    return ids
  }

  /**
   * The circle at a point of the plane. For a pointer (`reach` 0), rims take precedence over discs; the nearest rim and
   * the smallest disc win. A finger has the circles with smaller radii than its `reach` first, if their centers are
   * within it; the nearest one wins. Elsewhere it is the circle whose cell contains the point.
   */
  hitAt(
    { x, y }: Point,
    slack: number,
    reach = 0,
    { lattice, areSites = false }: Pick<DomainChange, 'lattice' | 'areSites'> = {},
  ): Hit | undefined {
    const nearestImage = lattice ? shortestWith(lattice) : undefined
    const width = Math.max(slack, reach)
    let cell = -1
    let cellDistance = Number.POSITIVE_INFINITY
    let rim = -1
    let rimDistance = slack
    let disc = -1
    let discSize = Number.POSITIVE_INFINITY
    let small = -1
    let smallDistance = Number.POSITIVE_INFINITY
    let inReach = 0
    const numbers = this.#numbers
    for (let id = 0; id < this.#size; id++) {
      let dx = at(numbers, 3 * id) - x
      let dy = at(numbers, 3 * id + 1) - y
      const weight = at(numbers, 3 * id + 2)
      let isImage = false
      if (nearestImage !== undefined) {
        const image = nearestImage(dx, dy)
        isImage = image.x !== dx || image.y !== dy
        dx = image.x
        dy = image.y
      }
      // One coordinate is enough to rule most circles out.
      const far = Math.max(cellDistance, width) + Math.max(weight, 0)
      if (Math.abs(dx) > far || Math.abs(dy) > far || this.#isThere[id] !== 1) continue
      const toCenter = Math.hypot(dx, dy)
      if (toCenter - weight < cellDistance) {
        cell = id
        cellDistance = toCenter - weight
      }
      const r = areSites ? 0 : weight
      const distance = toCenter - r
      if (r < reach && toCenter <= reach) {
        inReach += 1
        if (distance < smallDistance) {
          small = id
          smallDistance = distance
        }
      }
      // A small circle has no separate rim; it can be resized at a larger scale. An image has none either, because
      // sizes are measured from the circle itself.
      const hasRim = r > 3 * slack && !isImage
      if (hasRim && Math.abs(distance) < rimDistance) {
        rim = id
        rimDistance = Math.abs(distance)
      }
      if (distance <= (hasRim ? 0 : slack) && r < discSize) {
        disc = id
        discSize = r
      }
    }
    if (small >= 0) return { id: small, part: 'disc', inReach }
    if (rim >= 0) return { id: rim, part: 'rim' }
    if (disc >= 0) return { id: disc, part: 'disc' }
    return cell < 0 ? undefined : { id: cell, part: 'cell' }
  }

  /**
   * Returns a circle that is closer to a point than circle `id`; `undefined` if the point is in the cell of that circle.
   * `images` are the translations of circles that repeat (`imagesOf`). The cell does not repeat, so `id` itself may be
   * returned.
   */
  closerThan(id: number, point: Point, images: readonly Point[]): number | undefined {
    const distance = this.distanceTo(id, point)
    for (const [k, { x, y }] of images.entries()) {
      const closer = this.#closerTo({ x: point.x - x, y: point.y - y }, distance, k === 0 ? id : undefined)
      if (closer !== undefined) return closer
    }
    return undefined
  }

  /** The distance of a point to a circle, negative inside; infinite if there is no such circle. */
  distanceTo(id: number, { x, y }: Point): number {
    if (this.#isThere[id] !== 1) return Infinity
    const [dx, dy] = [at(this.#numbers, 3 * id) - x, at(this.#numbers, 3 * id + 1) - y]
    return Math.sqrt(dx * dx + dy * dy) - at(this.#numbers, 3 * id + 2)
  }

  #closerTo(point: Point, distance: number, except: number | undefined): number | undefined {
    if (this.#index === undefined || 2 * this.#index.changed.size > this.#count) {
      this.#index = { cells: new CellIndex(this.#numbers, this.ids()), changed: new Set(), moved: undefined }
    }
    const index = this.#index
    const { cells, changed } = index
    const isThere = (id: number) => this.#isThere[id] === 1
    index.moved ??= new CellIndex(this.#numbers, Int32Array.from([...changed].filter(isThere)))
    const moved = index.moved.closerTo(point, distance, (id) => id === except)
    if (moved !== NONE) return moved
    const closer = cells.closerTo(point, distance, (id) => id === except || changed.has(id))
    return closer === NONE ? undefined : closer
  }

  /** The bounding box of all circles, cached until the next edit. */
  box(): Box {
    this.#box ??= boundingBox(this.circles())
    return this.#box
  }

  /**
   * A bounding box that a few outliers do not widen: around the middle nine tenths of the centers in each direction.
   */
  core(): Box {
    this.#core ??= coreOf(this.circles())
    return this.#core
  }

  #put(id: number, { x, y, r }: Circle): void {
    if (id >= this.#isThere.length) {
      const room = Math.max(2 * this.#isThere.length, id + 1)
      const [numbers, isThere] = [this.#numbers, this.#isThere]
      this.#numbers = new Float64Array(3 * room)
      this.#numbers.set(numbers)
      this.#isThere = new Uint8Array(room)
      this.#isThere.set(isThere)
    }
    if (this.#isThere[id] !== 1) this.#count += 1
    this.#isThere[id] = 1
    this.#size = Math.max(this.#size, id + 1)
    this.#numbers.set([x, y, r], 3 * id)
  }
}

/** The translations of circles that repeat with a lattice, beginning with that to their own places. */
export function imagesOf(lattice: Lattice | null | undefined): Point[] {
  if (!lattice) return [{ x: 0, y: 0 }]
  const [u, v] = shortestPeriods(lattice).vectors
  return AROUND.flatMap((k) => AROUND.map((l) => ({ x: k * u.x + l * v.x, y: k * u.y + l * v.y })))
}

function coreOf(circles: Float64Array): Box {
  const n = circles.length / 3
  const step = Math.max(Math.floor(n / CORE_SAMPLE), 1)
  const middleOf = (offset: number): [number, number] => {
    const values = Float64Array.from({ length: Math.ceil(n / step) }, (_, k) =>
      at(circles, 3 * k * step + offset),
    ).sort()
    const last = values.length - 1
    return [at(values, Math.ceil(0.05 * last)), at(values, Math.floor(0.95 * last))]
  }
  if (n === 0) return boundingBox(circles)
  const [minX, maxX] = middleOf(0)
  const [minY, maxY] = middleOf(1)
  return minX < maxX || minY < maxY ? { minX, minY, maxX, maxY } : boundingBox(circles)
}
