// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { expect, it } from 'vitest'
import { wholeNumber } from '../../web/view/whole-number.ts'

it('writes a whole number as English does', () => {
  expect([0, 7, 100, 1000, 1_234_567].map(wholeNumber)).toEqual(['0', '7', '100', '1,000', '1,234,567'])
  fc.assert(
    fc.property(fc.nat(), (value) => {
      expect(wholeNumber(value)).toBe(value.toLocaleString('en'))
    }),
  )
})
