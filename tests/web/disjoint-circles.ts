// SPDX-License-Identifier: GPL-3.0-or-later
import type { Float64s } from '../../web/lib/index.ts'
import { tuple } from './tuples.ts'

const LARGEST = 0.9
const SPREAD = 8
const TRIES = 40

/**
 * Disjoint circles of very different sizes, spread over a rectangle in which each has about one unit of area. `random`: gives numbers from 0 to 1.
 */
export function disjointCircles(count: number, random: () => number): Float64s {
  const width = Math.sqrt(count * 1.5)
  const height = count / width
  // Largest circles first, because small ones find room later.
  const radii = Array.from({ length: count }, () => radiusOf(random())).sort((r, other) => other - r)
  const grid = new Map<string, number[]>()
  const circles = new Float64Array(3 * count)
  const key = (column: number, row: number) => `${column},${row}`

  const overlaps = (x: number, y: number, r: number) => {
    const column = Math.floor(x / (2 * LARGEST))
    const row = Math.floor(y / (2 * LARGEST))
    for (let c = column - 1; c <= column + 1; c++) {
      for (let w = row - 1; w <= row + 1; w++) {
        for (const i of grid.get(key(c, w)) ?? []) {
          const [otherX, otherY, otherR] = tuple(circles, 3 * i, 3)
          if ((x - otherX) * (x - otherX) + (y - otherY) * (y - otherY) < (r + otherR) * (r + otherR)) return true
        }
      }
    }
    return false
  }

  radii.forEach((radius, i) => {
    let x = 0
    let y = 0
    let r = radius
    for (let attempt = 0; attempt < TRIES; attempt++) {
      x = random() * width
      y = random() * height
      if (!overlaps(x, y, r)) break
      r *= 0.95
    }
    circles.set([x, y, r], 3 * i)
    const home = key(Math.floor(x / (2 * LARGEST)), Math.floor(y / (2 * LARGEST)))
    grid.set(home, [...(grid.get(home) ?? []), i])
  })
  return circles
}

function radiusOf(share: number): number {
  return LARGEST / (1 + (SPREAD - 1) * share * share)
}
