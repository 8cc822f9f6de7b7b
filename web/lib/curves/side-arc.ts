// SPDX-License-Identifier: GPL-3.0-or-later
// Most curves of a drawing need one line or one cubic curve. They are drawn here to the bit as `addArc` draws them, but
// without making an object. Numbers pass between functions in one array, as engines make an object for each that is
// passed to a function that they do not inline.
import { at } from '../base/diagram-data.ts'
import { hypotenuse, unitFor } from '../base/scale.ts'
import type { Box, DiagramData, PathSink } from '../base/types.ts'
import { chordError, cubicError, excessOf, FINEST_CURVE, isNearlyStraight, shareOfControl } from './bezier.ts'
import { halfConjugateAxis, leastUnit, parameterFrom } from './bisector.ts'

const START = 0
const END = 2
const FROM = 4
const TO = 5
const A = 6
const B = 7
const APEX = 8
const ORIGIN = 9
const ALONG = 11
const ACROSS = 13
const CONTROL = 15

const numbers = new Float64Array(17)

/**
 * Draws a side with two ends, between circles of different radii. With a box, the path moves to the start first. Returns
 * false and draws nothing if the side needs several curves or another unit, or if its control point is not in the box.
 */
export function addSide(sink: PathSink, diagram: DiagramData, side: number, tolerance: number, box?: Box): boolean {
  if (!measure(diagram, side >> 1)) return false
  if (side & 1) reverse()
  findControl()
  if (box !== undefined && !isControlWithin(box)) return false
  const count = curvesWithin(tolerance)
  if (count > 1) return false
  if (box !== undefined) sink.moveTo(at(numbers, START), at(numbers, START + 1))
  if (count === 0) sink.lineTo(at(numbers, END), at(numbers, END + 1))
  else addCubic(sink)
  return true
}

/** Does what `curveOf` does; false if that would take another unit than 1. */
function measure({ circles, vertices, edges }: DiagramData, edge: number): boolean {
  const left = 3 * at(edges, 4 * edge)
  const right = 3 * at(edges, 4 * edge + 1)
  const difference = at(circles, left + 2) - at(circles, right + 2)
  const isLeft = difference <= 0
  const origin = isLeft ? left : right
  const other = isLeft ? right : left
  const originX = at(circles, origin)
  const originY = at(circles, origin + 1)
  const x = at(circles, other) - originX
  const y = at(circles, other + 1) - originY
  if (unitFor(Math.max(Math.abs(x), Math.abs(y))) !== 1) return false
  const d = Math.sqrt(x * x + y * y)
  const size = Math.abs(difference)
  numbers[A] = difference / 2
  numbers[B] = halfConjugateAxis(d, size)
  numbers[APEX] = (d - size) / 2
  numbers[ORIGIN] = originX
  numbers[ORIGIN + 1] = originY
  numbers[ALONG] = x / d
  numbers[ALONG + 1] = y / d
  numbers[ACROSS] = isLeft ? -(y / d) : y / d
  numbers[ACROSS + 1] = isLeft ? x / d : -(x / d)
  let reach = 0
  for (let end = 0; end < 2; end++) {
    const vertex = 3 * at(edges, 4 * edge + 2 + end)
    const endX = at(vertices, vertex)
    const endY = at(vertices, vertex + 1)
    numbers[2 * end] = endX
    numbers[2 * end + 1] = endY
    reach = Math.max(reach, Math.abs(endX - originX), Math.abs(endY - originY))
    findParameter(end)
  }
  if (at(numbers, FROM) > at(numbers, TO)) {
    numbers[FROM] = numbers[TO] = Math.sqrt(at(numbers, FROM)) * Math.sqrt(at(numbers, TO))
  }
  return !(leastUnit(at(numbers, A), at(numbers, B), reach) > 1)
}

function findParameter(end: number): void {
  numbers[FROM + end] = parameterFrom(
    at(numbers, A),
    at(numbers, B),
    at(numbers, APEX),
    at(numbers, ACROSS),
    at(numbers, ACROSS + 1),
    at(numbers, 2 * end) - at(numbers, ORIGIN),
    at(numbers, 2 * end + 1) - at(numbers, ORIGIN + 1),
  )
}

/** Does what `reversed` does, but for the sign of a. */
function reverse(): void {
  const from = at(numbers, FROM)
  numbers[FROM] = 1 / at(numbers, TO)
  numbers[TO] = 1 / from
  for (let k = 0; k < 2; k++) {
    const start = at(numbers, START + k)
    numbers[START + k] = at(numbers, END + k)
    numbers[END + k] = start
    numbers[ACROSS + k] = -at(numbers, ACROSS + k)
  }
}

/** Does what `controlPoint` does. */
function findControl(): void {
  const from = at(numbers, FROM)
  const to = at(numbers, TO)
  const u = at(numbers, APEX) - Math.abs(at(numbers, A)) * (((from - 1) / (from + to)) * (to - 1))
  const v = at(numbers, B) * ((from / (from + to)) * to - 1 / (from + to))
  for (let k = 0; k < 2; k++) {
    numbers[CONTROL + k] = at(numbers, ORIGIN + k) + (u * at(numbers, ALONG + k) + v * at(numbers, ACROSS + k))
  }
}

function isControlWithin({ minX, minY, maxX, maxY }: Box): boolean {
  const x = at(numbers, CONTROL)
  const y = at(numbers, CONTROL + 1)
  return minX < x && x < maxX && minY < y && y < maxY
}

/** How many cubic curves `addArc` needs: 0 for a line, 2 for several. */
function curvesWithin(tolerance: number): number {
  const a = at(numbers, A)
  const from = at(numbers, FROM)
  const to = at(numbers, TO)
  if (isNearlyStraight(a, from, to, tolerance)) return 0
  const b = at(numbers, B)
  const excess = excessOf(from, to)
  const error = chordError(a, b, from, to, excess)
  const x = at(numbers, END) - at(numbers, START)
  const y = at(numbers, END + 1) - at(numbers, START + 1)
  const limit = Math.max(tolerance, FINEST_CURVE * (hypotenuse(x, y) + error))
  if (!(error > limit)) return 0
  return cubicError(a, b, from, to, excess) <= limit ? 1 : 2
}

function addCubic(sink: PathSink): void {
  const share = shareOfControl(excessOf(at(numbers, FROM), at(numbers, TO)))
  const controlX = at(numbers, CONTROL)
  const controlY = at(numbers, CONTROL + 1)
  const startX = at(numbers, START)
  const startY = at(numbers, START + 1)
  const endX = at(numbers, END)
  const endY = at(numbers, END + 1)
  sink.bezierCurveTo(
    startX + share * (controlX - startX),
    startY + share * (controlY - startY),
    endX + share * (controlX - endX),
    endY + share * (controlY - endY),
    endX,
    endY,
  )
}
