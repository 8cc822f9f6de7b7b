// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it } from 'vitest'
import { stippled } from '../../web/app/files/stipple.ts'
import { seededRandom } from './library.ts'
import { tuple } from './tuples.ts'

/** A picture of one color for each of its quarters, by rows from the top. */
function quarters(width: number, height: number, colors: readonly (readonly number[])[]) {
  const data = Array.from({ length: width * height }, (_, k) => {
    const [column, row] = [k % width, Math.floor(k / width)]
    return [...(colors[2 * Number(row >= height / 2) + Number(column >= width / 2)] as number[]), 255]
  }).flat()
  return { width, height, data }
}

it.each([
  [60, 20],
  [20, 60],
])('circles have the colors of their places in the picture, and most are in dark parts: %d x %d', (width, height) => {
  const [dark, white] = [
    [32, 0, 0],
    [255, 255, 255],
  ] as const
  const { circles, colors } = stippled(
    quarters(width, height, [dark, [0, 0, 48], white, [0, 80, 0]]),
    seededRandom(3),
    200,
  )
  const counts = { dark: 0, white: 0 }
  for (const [i, color] of colors.entries()) {
    const [x, y, r] = tuple(circles, 3 * i, 3)
    // The cell of a circle near the middle has pixels of several quarters.
    if (Math.abs(x - width / 2) < 4 || Math.abs(y - height / 2) < 4) continue
    const [isLeft, isUpper] = [x < width / 2, y > height / 2]
    expect(color).toBe(isUpper ? (isLeft ? '#200000' : '#000030') : isLeft ? '#ffffff' : '#005000')
    if (isLeft) counts[isUpper ? 'dark' : 'white'] += 1
    expect(r).toBeGreaterThan(0)
  }
  expect(counts.dark).toBeGreaterThan(5 * counts.white)
  for (let i = 0; i < 200; i++) {
    for (let j = 0; j < i; j++) {
      const [x, y, r] = [0, 1, 2].map(
        (k) => (circles[3 * i + k] as number) - (circles[3 * j + k] as number) * (k === 2 ? -1 : 1),
      )
      expect(Math.hypot(x as number, y as number)).toBeGreaterThan(r as number)
    }
  }
})
