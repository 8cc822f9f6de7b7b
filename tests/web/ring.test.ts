// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it } from 'vitest'
import { leastFirst } from '../../web/view/painter/ring.ts'

it('a ring begins with its least number, wherever it began, and however long it is', () => {
  expect(leastFirst([])).toEqual([])
  expect([leastFirst([5, 9, 2, 7]), leastFirst([2, 7, 5, 9])]).toEqual([
    [2, 7, 5, 9],
    [2, 7, 5, 9],
  ])
  // More numbers than a call may have arguments. The cell of a circle can have that many neighbors.
  const long = Array.from({ length: 300_000 }, (_, k) => (k + 1000) % 300_000)
  const turned = leastFirst(long)
  expect([turned.length, turned[0], turned.at(-1)]).toEqual([300_000, 0, 299_999])
})
