// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it } from 'vitest'
import { lookAt, pictureOf } from '../../web/tutorial/printed-picture.ts'

it('has each circle begin on its rim, in a box that has all of them', () => {
  const circles = Float64Array.of(0, 0, 2, 10, 1, 3)
  const size = { width: 400, height: 300 }
  const comparison = { found: [], wrong: [], missing: [], leftover: [], borders: 0 }
  const { viewBox, content } = pictureOf(circles, comparison, lookAt(circles, undefined, size), size)
  const [d = ''] = /d="(M[^"]+)"/.exec(content)?.slice(1) ?? []
  const starts = [...d.matchAll(/M(-?[\d.]+)[ ,](-?[\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)] as const)
  expect(starts).toEqual([
    [2, 0],
    [13, 1],
  ])
  const [left, top, width, height] = viewBox.split(' ').map(Number) as [number, number, number, number]
  expect(left <= -2 && left + width >= 13 && top <= -4 && top + height >= 2).toBe(true)
})
