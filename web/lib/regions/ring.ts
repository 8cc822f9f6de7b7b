// SPDX-License-Identifier: GPL-3.0-or-later

import { at } from '../base/diagram-data.ts'
import { between, cross, dot } from '../base/point.ts'
import { lengthOf, measuredIn, ROUNDING, turn, unitFor } from '../base/scale.ts'
import type { Circle, Point, Vector } from '../base/types.ts'
import type { ConvexPolygon } from './convex-polygon.ts'

/** In place of a side of a region: the circle that limits it. */
export const CIRCLE_OF_RING = -2

/** A ring of that share of its radius is made of points alone that are one but for rounding. */
const NOTHING = 2 ** -30

const AXES: readonly Vector[] = [
  { x: 1, y: 0 },
  { x: 0, y: 1 },
  { x: -1, y: 0 },
  { x: 0, y: -1 },
]

/** A segment, or an arc of a quarter turn at most. */
export interface RingElement {
  readonly start: Point
  readonly end: Point
  /** Of an arc; 0: a segment. */
  readonly r: number
  /** Of the region, or `CIRCLE_OF_RING`. */
  readonly side: number
}

/**
 * The boundary of a convex region, or of what it has in common with a disc, as one closed line, counter-clockwise. A place
 * is how far along the chords of the elements a point is from the start of the first.
 */
export class Ring {
  /** None if region and disc have nothing in common. */
  readonly elements: readonly RingElement[]
  readonly #center: Point
  /** How far the start of each element is along the line, and the whole length. */
  readonly #reach: Float64Array

  /** The disc has a radius above 0. */
  constructor(region: ConvexPolygon, disc?: Circle) {
    this.elements = disc === undefined ? sidesOf(region) : commonOf(region, disc)
    this.#center = disc ?? { x: 0, y: 0 }
    this.#reach = new Float64Array(this.elements.length + 1)
    this.elements.forEach(({ start, end }, k) => {
      this.#reach[k + 1] = at(this.#reach, k) + lengthOf(between(start, end))
    })
  }

  get total(): number {
    return at(this.#reach, this.elements.length)
  }

  /** Whether it is a circle as a whole. */
  get isCircle(): boolean {
    return this.elements.every(({ r }) => r > 0)
  }

  /** A point inside. */
  middle(): Point {
    const { length } = this.elements
    return {
      x: this.elements.reduce((sum, { start }) => sum + start.x / length, 0),
      y: this.elements.reduce((sum, { start }) => sum + start.y / length, 0),
    }
  }

  /** The place next to a point, of those on a side or on the circle if one is given. */
  placeNear(p: Point, side?: number): number {
    let nearest = Number.POSITIVE_INFINITY
    let place = 0
    this.elements.forEach((element, k) => {
      if (side !== undefined && element.side !== side) return
      const share = this.#shareOn(element, p)
      const gap = lengthOf(between(p, this.#pointOn(element, share)))
      if (gap >= nearest) return
      nearest = gap
      place = at(this.#reach, k) + share * (at(this.#reach, k + 1) - at(this.#reach, k))
    })
    // The side may have nothing but a point in common with the disc.
    return side !== undefined && nearest === Number.POSITIVE_INFINITY ? this.placeNear(p) : place
  }

  at(place: number): Point {
    const k = this.#elementAt(place)
    const reach = at(this.#reach, k)
    return this.#pointOn(this.elements[k] as RingElement, (place - reach) / (at(this.#reach, k + 1) - reach))
  }

  /**
   * The parts of elements from one place to another, which may be up to two rounds ahead, with the given ends for these
   * places. None has length zero.
   */
  between(from: number, to: number, start: Point, end: Point): RingElement[] {
    const parts: RingElement[] = []
    let current = this.elements[this.#elementAt(from < this.total ? from : from - this.total)] as RingElement
    let last = start
    const add = (p: Point) => {
      if (last.x !== p.x || last.y !== p.y) parts.push({ ...current, start: last, end: p })
      last = p
    }
    for (const round of [0, 1, 2]) {
      this.elements.forEach((element, k) => {
        const place = at(this.#reach, k) + round * this.total
        if (!(from < place && place < to)) return
        add(element.start)
        current = element
      })
    }
    add(end)
    return parts
  }

  #elementAt(place: number): number {
    let k = this.elements.length - 1
    while (k > 0 && place < at(this.#reach, k)) k -= 1
    return k
  }

  /** Of an arc: where the ray from the center through the point of the chord meets it. */
  #pointOn({ start, end, r }: RingElement, share: number): Point {
    const chord = between(start, end)
    const p = { x: start.x + share * chord.x, y: start.y + share * chord.y }
    if (r === 0) return p
    const v = between(this.#center, p)
    const factor = r / lengthOf(v)
    return { x: this.#center.x + factor * v.x, y: this.#center.y + factor * v.y }
  }

  #shareOn({ start, end, r }: RingElement, p: Point): number {
    if (r === 0) {
      const size = lengthOf(between(start, end))
      return clamped(dot(measuredIn(size, between(start, end)), between(start, p)) / size)
    }
    const unit = unitFor(r)
    const seen = (q: Point) => measuredIn(unit, between(this.#center, q))
    const before = cross(seen(start), seen(p))
    const whole = before + cross(seen(p), seen(end))
    return whole > 0 ? clamped(before / whole) : before > 0 ? 1 : 0
  }
}

function clamped(share: number): number {
  return Math.min(Math.max(share, 0), 1)
}

function isSame(p: Point, q: Point): boolean {
  return p.x === q.x && p.y === q.y
}

function sidesOf(region: ConvexPolygon): RingElement[] {
  return region.corners.map((start, side) => ({ start, end: region.cornerAfter(side), r: 0, side }))
}

function onAxis({ x, y, r }: Circle, k: number): Point {
  const axis = AXES[k % AXES.length] as Vector
  return { x: x + r * axis.x, y: y + r * axis.y }
}

function circleOf(disc: Circle): RingElement[] {
  return AXES.map((_, k) => ({
    start: onAxis(disc, k),
    end: onAxis(disc, k + 1),
    r: disc.r,
    side: CIRCLE_OF_RING,
  }))
}

function commonOf(region: ConvexPolygon, disc: Circle): RingElement[] {
  const isInside = region.corners.map((corner) => lengthOf(between(disc, corner)) <= disc.r)
  const parts = region.corners.flatMap((from, side) => {
    const to = region.cornerAfter(side)
    const chord = chordOf(from, to, isInside[side] as boolean, isInside[(side + 1) % isInside.length] as boolean, disc)
    if (chord === undefined) return []
    const along = between(from, to)
    const pointAt = (share: number) =>
      share === 0 ? from : share === 1 ? to : { x: from.x + share * along.x, y: from.y + share * along.y }
    return [{ start: pointAt(chord[0]), end: pointAt(chord[1]), r: 0, side }]
  })
  const elements = parts.flatMap((part, i) => {
    const next = (parts[(i + 1) % parts.length] as RingElement).start
    const arcs = isSame(part.end, next) ? [] : arcsBetween(disc, part.end, next)
    return isSame(part.start, part.end) ? arcs : [part, ...arcs]
  })
  const size = elements.reduce((sum, { start, end }) => sum + lengthOf(between(start, end)), 0)
  if (size > NOTHING * disc.r) return elements
  // Nothing is cut off then, or nothing left, but for rounding.
  return region.contains(disc) ? circleOf(disc) : []
}

/** The part of a segment inside a disc by the shares of its ends, whether these are inside having been decided. */
function chordOf(from: Point, to: Point, hasFrom: boolean, hasTo: boolean, disc: Circle): [number, number] | undefined {
  if (hasFrom && hasTo) return [0, 1]
  const unit = unitFor(disc.r)
  const size = lengthOf(between(from, to)) / unit
  const along = measuredIn(size, measuredIn(unit, between(from, to)))
  const toCenter = measuredIn(unit, between(from, disc))
  const foot = dot(along, toCenter)
  const height = Math.abs(cross(along, toCenter))
  const r = disc.r / unit
  const half = Math.sqrt(Math.max((r - height) * (r + height), 0))
  const first = hasFrom ? 0 : clamped((foot - half) / size)
  const second = hasTo ? 1 : clamped((foot + half) / size)
  // With no end inside it may pass the disc by.
  return hasFrom || hasTo || (height < r && first < second) ? [first, second] : undefined
}

/** The arc counter-clockwise from one point of the circle to another, in quarters. */
function arcsBetween(disc: Circle, from: Point, to: Point): RingElement[] {
  const u = between(disc, from)
  const v = between(disc, to)
  const last = quarterOf(v)
  let quarter = quarterOf(u)
  const isOneQuarter = quarter === last && turn(u, v) >= 0
  const isNothing = lengthOf(between(from, to)) <= ROUNDING * disc.r
  const ends: Point[] = []
  if (!isOneQuarter && !isNothing) {
    do {
      quarter = (quarter + 1) % AXES.length
      ends.push(onAxis(disc, quarter))
    } while (quarter !== last)
  }
  return [...ends, to].flatMap((end, k) => {
    const start = ends[k - 1] ?? from
    return isSame(start, end) ? [] : [{ start, end, r: disc.r, side: CIRCLE_OF_RING }]
  })
}

/** The quarter of the circle in which a direction lies: from an axis to before the next. */
function quarterOf({ x, y }: Vector): number {
  if (y >= 0) return x > 0 ? 0 : y > 0 ? 1 : 2
  return x < 0 ? 2 : 3
}
