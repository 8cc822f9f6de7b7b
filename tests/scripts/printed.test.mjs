// SPDX-License-Identifier: GPL-3.0-or-later
// The initial pictures of the printed rules' results, which are shown without scripts.
import { expect, it } from 'vitest'
import { loadFigureCircles } from '../../scripts/texts/figure-circles.mjs'
import { loadPrinted } from '../../scripts/texts/printed.mjs'
import { readBook } from '../../scripts/texts/tutorial.mjs'
import { library } from '../web/library.ts'

const circlesOf = await loadFigureCircles()
const printedOf = await loadPrinted(library)
const figures = readBook()
  .flatMap(({ blocks }) => blocks)
  .filter(({ kind }) => kind === 'printed')
  .map(({ spec }) => [spec.name, spec])

it.each(figures)('%s shows what the figure beside it shows', (_, spec) => {
  const { svg } = printedOf(circlesOf(spec), spec)
  const [left, top, width, height] = /viewBox="([^"]*)"/.exec(svg)[1].split(' ').map(Number)
  expect(width).toBeCloseTo(height)
  if (spec.view !== undefined) {
    const [x, y, span] = spec.view
    expect([left + width / 2, -(top + height / 2), height]).toEqual([x, y, span].map((value) => expect.closeTo(value)))
    return
  }
  for (const [x, y, r] of circlesOf(spec)) {
    expect(Math.min(x - r - left, left + width - x - r, -top - y - r, y - r + top + height)).toBeGreaterThan(0)
  }
})
