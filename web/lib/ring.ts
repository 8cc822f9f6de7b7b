// SPDX-License-Identifier: GPL-3.0-or-later
import type { ConvexPolygon } from './convex-polygon.ts'
import { at } from './diagram-data.ts'
import { between, dot, type Point } from './point.ts'
import { lengthOf } from './scale.ts'

/** The boundary of a region as one closed line, measured counter-clockwise from its first corner. */
export class Ring {
  readonly #region: ConvexPolygon
  /** How far each corner is along the line, and the whole length. */
  readonly #reach: Float64Array

  constructor(region: ConvexPolygon) {
    this.#region = region
    this.#reach = new Float64Array(region.corners.length + 1)
    region.corners.forEach((corner, k) => {
      this.#reach[k + 1] = at(this.#reach, k) + lengthOf(between(corner, region.cornerAfter(k)))
    })
  }

  get total(): number {
    return at(this.#reach, this.#region.corners.length)
  }

  /** The place on side `k` next to a point. */
  placeOn(k: number, p: Point): number {
    const corner = this.#region.corner(k)
    const size = at(this.#reach, k + 1) - at(this.#reach, k)
    const side = between(corner, this.#region.cornerAfter(k))
    const along = dot(between(corner, p), { x: side.x / size, y: side.y / size })
    return at(this.#reach, k) + Math.min(Math.max(along, 0), size)
  }

  /** The place next to a point. */
  placeNear(p: Point): number {
    let nearest = Number.POSITIVE_INFINITY
    let place = 0
    this.#region.corners.forEach((_, k) => {
      const candidate = this.placeOn(k, p)
      const gap = lengthOf(between(this.at(candidate), p))
      if (gap >= nearest) return
      nearest = gap
      place = candidate
    })
    return place
  }

  at(place: number): Point {
    let k = this.#region.corners.length - 1
    while (k > 0 && place < at(this.#reach, k)) k -= 1
    const corner = this.#region.corner(k)
    const side = between(corner, this.#region.cornerAfter(k))
    const share = (place - at(this.#reach, k)) / (at(this.#reach, k + 1) - at(this.#reach, k))
    return { x: corner.x + share * side.x, y: corner.y + share * side.y }
  }

  /** The corners strictly between two places; `to` may be up to two rounds ahead. */
  cornersBetween(from: number, to: number): Point[] {
    return [0, 1, 2].flatMap((round) =>
      this.#region.corners.filter((_, k) => {
        const place = at(this.#reach, k) + round * this.total
        return from < place && place < to
      }),
    )
  }
}
