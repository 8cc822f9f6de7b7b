// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../base/diagram-data.ts'
import { hypotenuse, unitFor } from '../base/scale.ts'
import type { Box, DiagramData, PathSink } from '../base/types.ts'
import {
  atLeast,
  chordError,
  controlAcross,
  controlAlong,
  cubicError,
  FINEST_CURVE,
  isNearlyStraight,
  shareOfControl,
} from './bezier.ts'
import { halfConjugateAxis, leastUnit, parameterFrom } from './bisector.ts'

/**
 * Draws a side with two ends, between circles of different radii, to the bit as `addArc` draws its `curveOf`, but without
 * making an object: most curves of a drawing need one line or one cubic curve. With a box, the path moves to the start
 * first. Returns false and draws nothing if the side needs more, or if its control point is not inside the box.
 */
export function addSide(
  sink: PathSink,
  { circles, vertices, edges }: DiagramData,
  side: number,
  tolerance: number,
  box?: Box,
): boolean {
  const edge = 4 * (side >> 1)
  const left = 3 * at(edges, edge)
  const right = 3 * at(edges, edge + 1)
  const first = 3 * at(edges, edge + 2)
  const last = 3 * at(edges, edge + 3)
  const difference = at(circles, left + 2) - at(circles, right + 2)
  const size = Math.abs(difference)
  const origin = difference <= 0 ? left : right
  const other = difference <= 0 ? right : left
  const originX = at(circles, origin)
  const originY = at(circles, origin + 1)
  const x = at(circles, other) - originX
  const y = at(circles, other + 1) - originY
  if (unitFor(Math.max(Math.abs(x), Math.abs(y))) !== 1) return false
  const d = Math.sqrt(x * x + y * y)
  const a = difference / 2
  const b = halfConjugateAxis(d, size)
  const apex = (d - size) / 2
  const alongX = x / d
  const alongY = y / d
  let acrossX = difference <= 0 ? -alongY : alongY
  let acrossY = difference <= 0 ? alongX : -alongX
  let startX = at(vertices, first)
  let startY = at(vertices, first + 1)
  let endX = at(vertices, last)
  let endY = at(vertices, last + 1)
  const reach = Math.max(
    Math.abs(startX - originX),
    Math.abs(startY - originY),
    Math.abs(endX - originX),
    Math.abs(endY - originY),
  )
  if (leastUnit(a, b, reach) > 1) return false
  let from = parameterFrom(a, b, apex, acrossX, acrossY, startX - originX, startY - originY)
  let to = parameterFrom(a, b, apex, acrossX, acrossY, endX - originX, endY - originY)
  if (from > to) from = to = Math.sqrt(from) * Math.sqrt(to)
  let u = controlAlong(apex, a, from, to)
  let v = controlAcross(b, from, to)
  let controlX = originX + (u * alongX + v * acrossX)
  let controlY = originY + (u * alongY + v * acrossY)
  if (box !== undefined) {
    const { minX, minY, maxX, maxY } = box
    if (!(minX < controlX && controlX < maxX && minY < controlY && controlY < maxY)) return false
  }
  if (side & 1) {
    ;[from, to] = [1 / to, 1 / from]
    ;[startX, startY, endX, endY] = [endX, endY, startX, startY]
    acrossX = -acrossX
    acrossY = -acrossY
    u = controlAlong(apex, a, from, to)
    v = controlAcross(b, from, to)
    controlX = originX + (u * alongX + v * acrossX)
    controlY = originY + (u * alongY + v * acrossY)
  }
  let isLine = isNearlyStraight(a, from, to, tolerance)
  if (!isLine) {
    const error = chordError(a, b, from, to)
    const limit = atLeast(FINEST_CURVE, hypotenuse(endX - startX, endY - startY), error, tolerance)
    isLine = !(error > limit)
    if (!isLine && !(cubicError(a, b, from, to) <= limit)) return false
  }
  if (box !== undefined) sink.moveTo(startX, startY)
  if (isLine) {
    sink.lineTo(endX, endY)
    return true
  }
  const share = shareOfControl(from, to)
  sink.bezierCurveTo(
    startX + share * (controlX - startX),
    startY + share * (controlY - startY),
    endX + share * (controlX - endX),
    endY + share * (controlY - endY),
    endX,
    endY,
  )
  return true
}
