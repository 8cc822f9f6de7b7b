// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../lib/base/diagram-data.ts'
import type { PathSink } from '../../lib/index.ts'
import type { Frame } from './frame.ts'
import { FrameSink } from './frame-sink.ts'
import { addPolygon, addRectangle } from './polygon-path.ts'
import { addSegment } from './segment-path.ts'
import type { Border } from './torus.ts'

/** Rings are cut off this far outside the frame, in pixels, to keep coordinates small without a visible effect. */
const MARGIN = 16

/** The part of a region that a frame shows: its border, or only its inside, or only its outside. */
export function partShown(frame: Frame, region: Border): 'border' | 'inside' | 'outside' {
  let isBorderSeen = false
  const moveTo = () => {
    isBorderSeen = true
  }
  addBorder({ ...NO_PATH, moveTo }, frame, region)
  if (isBorderSeen) return 'border'
  return region.contains(frame.x, frame.y) ? 'inside' : 'outside'
}

/** Adds the visible part of a region's inside. */
export function addInside(path: PathSink, frame: Frame, region: Border): void {
  const sides = sidesOf(frame)
  for (const ring of ringsOf(frame, region)) addPolygon(path, sides.reduce(cut, ring))
}

/** Adds the visible part of a region's outside: a rectangle opposite in orientation to the outer rings. */
export function addOutside(path: PathSink, frame: Frame, region: Border): void {
  const [right, bottom] = [frame.width + MARGIN, frame.height + MARGIN]
  addRectangle(path, -MARGIN, -MARGIN, right, bottom)
  addInside(path, frame, region)
}

/** Adds the visible part of a region's border. */
export function addBorder(path: PathSink, frame: Frame, region: Border): void {
  for (const ring of ringsOf(frame, region)) {
    let [x, y] = [at(ring, ring.length - 2), at(ring, ring.length - 1)]
    for (let k = 0; k < ring.length; k += 2) {
      const [nextX, nextY] = [at(ring, k), at(ring, k + 1)]
      addSegment(path, frame, x, y, nextX, nextY)
      ;[x, y] = [nextX, nextY]
    }
  }
}

/** The rings in pixels. */
function* ringsOf(frame: Frame, { points, ringOffsets }: Border): Generator<Float64Array> {
  const to = new FrameSink(frame, NO_PATH)
  for (let ring = 0; ring + 1 < ringOffsets.length; ring++) {
    const numbers = points.slice(2 * at(ringOffsets, ring), 2 * at(ringOffsets, ring + 1))
    yield numbers.map((value, k) => (k % 2 === 0 ? to.x(value) : to.y(value)))
  }
}

/** A half-plane: points with sign * coordinate at most `most` are inside. */
interface Side {
  /** 0 for x, 1 for y. */
  readonly axis: 0 | 1
  readonly sign: 1 | -1
  readonly most: number
}

function sidesOf({ width, height }: Frame): Side[] {
  return [
    { axis: 0, sign: -1, most: MARGIN },
    { axis: 0, sign: 1, most: width + MARGIN },
    { axis: 1, sign: -1, most: MARGIN },
    { axis: 1, sign: 1, most: height + MARGIN },
  ]
}

/** Clips a ring to a half-plane (Sutherland and Hodgman). Outside parts are moved onto the line. */
function cut(ring: Float64Array, { axis, sign, most }: Side): Float64Array {
  const outside = (k: number) => sign * at(ring, k + axis) - most
  let isCut = false
  for (let k = 0; k < ring.length && !isCut; k += 2) isCut = outside(k) > 0
  if (!isCut) return ring
  const kept: number[] = []
  let last = ring.length - 2
  for (let k = 0; k < ring.length; k += 2) {
    const [before, now] = [outside(last), outside(k)]
    if (before > 0 !== now > 0) {
      const share = before / (before - now)
      const point = [0, 1].map((a) => at(ring, last + a) + share * (at(ring, k + a) - at(ring, last + a)))
      // Sets the coordinate exactly, because interpolation between large numbers is inexact.
      point[axis] = sign * most
      kept.push(...point)
    }
    if (now <= 0) kept.push(at(ring, k), at(ring, k + 1))
    last = k
  }
  return Float64Array.from(kept)
}

const NO_PATH: PathSink = { moveTo() {}, lineTo() {}, bezierCurveTo() {}, arc() {}, closePath() {} }
