// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it } from 'vitest'
import { fitPower, median, studentQuantile } from '../../scripts/results/fit.mjs'

it('finds the exponent of a power law, and no doubt where there is none', () => {
  const fit = fitPower([1, 10, 100, 1000].map((x) => ({ x, y: 3 * x ** 1.5 })))
  expect(fit.slope).toBeCloseTo(1.5, 12)
  expect(fit.halfWidth).toBeLessThan(1e-10)
  expect(fit.at(10)).toBeCloseTo(3 * 10 ** 1.5, 9)
})

it('gives the confidence of a slope as tables of regression do', () => {
  // y = 2, 3, 5, 4, 6 at x = 1 to 5: slope 0.9, standard error 0.2517, three degrees of freedom.
  const fit = fitPower([2, 3, 5, 4, 6].map((y, k) => ({ x: Math.exp(k + 1), y: Math.exp(y) })))
  expect(fit.slope).toBeCloseTo(0.9, 12)
  expect(fit.halfWidth).toBeCloseTo(3.1824 * 0.251661, 2)
})

it("knows Student's distribution", () => {
  for (const [degrees, quantile] of [
    [1, 12.706],
    [2, 4.303],
    [3, 3.182],
    [5, 2.571],
    [10, 2.228],
    [30, 2.042],
  ]) {
    expect(Math.abs(studentQuantile(degrees) - quantile)).toBeLessThan(0.01)
  }
})

it('takes the middle value', () => {
  expect(median([3, 1, 2])).toBe(2)
  expect(median([10, 9])).toBe(10)
})
