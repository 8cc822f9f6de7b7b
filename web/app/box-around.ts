// SPDX-License-Identifier: GPL-3.0-or-later
import type { Box, Lattice, Point } from '../lib/index.ts'

/** The room around circles, as a share of their larger side. */
const MARGIN = 0.05
/** Circles stay where they are if they begin so near to the origin, as a share of their side. */
const NEAR = 0.25

/** An upright box around circles, with some room, and how they move into it: its corner is at the origin. */
export function boxAround(circles: Box, count: number): { readonly lattice: Lattice; readonly move: Point } {
  if (count === 0) return { lattice: { a: [10, 0], b: [0, 10] }, move: { x: 0, y: 0 } }
  const [width, height] = [circles.maxX - circles.minX, circles.maxY - circles.minY]
  const room = MARGIN * Math.max(width, height) || 0.5
  const x = along(circles.minX, circles.maxX, room)
  const y = along(circles.minY, circles.maxY, room)
  return { lattice: { a: [x.period, 0], b: [0, y.period] }, move: { x: x.move, y: y.move } }
}

function along(least: number, most: number, room: number): { readonly period: number; readonly move: number } {
  const size = most - least
  if (least >= 0 && least <= NEAR * size) return { period: roundedUp(most + Math.max(least, room)), move: 0 }
  const period = roundedUp(size + 2 * room)
  return { period, move: (period - size) / 2 - least }
}

/** The least number with two digits that is not smaller. */
function roundedUp(value: number): number {
  const unit = 10 ** (Math.floor(Math.log10(value)) - 1)
  // A power of ten below 1 is not exact.
  return Number((Math.ceil(value / unit) * unit).toPrecision(2))
}
