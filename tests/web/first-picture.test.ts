// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it } from 'vitest'
import { firstPicture } from '../../web/app/first-picture.ts'
import { library } from './library.ts'

it('the first picture has the box of the circles, upside down, and a cell in the color of each circle', () => {
  const diagram = library.compute(Float64Array.of(-3, 10, 1, 5, 12, 2, 0, 20, 0.5))
  const drawing = firstPicture(diagram)
  expect(/viewBox="([^"]+)"/.exec(drawing)?.[1]).toBe('-4 -20.5 11 11.5')
  const discs = [...drawing.matchAll(/<circle class="(c\d)" cx="(.+?)" cy="(.+?)" r="(.+?)"/g)]
  expect(discs.map(([, , ...circle]) => circle.map(Number))).toEqual([
    [-3, 10, 1],
    [5, 12, 2],
    [0, 20, 0.5],
  ])
  const cells = [...drawing.matchAll(/<path class="(c\d)" d="M/g)]
  expect(cells.map(([, color]) => color)).toEqual(discs.map(([, color]) => color))
  expect(new Set(cells.map(([, color]) => color)).size).toBe(3)
})
