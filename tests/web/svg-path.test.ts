// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it } from 'vitest'
import { SvgPath } from '../../web/lib/index.ts'

it('has the commands that are drawn', () => {
  const path = new SvgPath(1)
  path.moveTo(0, 0.04)
  path.lineTo(1.25, -2)
  path.bezierCurveTo(1, 2, 3, 4, 5, 6)
  path.closePath()
  expect(`${path}`).toBe('M0,0L1.3,-2C1,2 3,4 5,6Z')
  path.lineTo(7, 8)
  expect(`${path}`).toBe('M0,0L1.3,-2C1,2 3,4 5,6ZL7,8')
  expect(`${new SvgPath()}`).toBe('')
})

it('moves to the start of an arc that it begins with, whatever other paths draw', () => {
  const path = new SvgPath(2)
  path.arc(0, 0, 2, 0, Math.PI)
  expect(`${path}`).toBe('M2,0A2,2 0 0 1 0,2A2,2 0 0 1 -2,0')
  const clockwise = new SvgPath(2)
  clockwise.arc(0, 0, 2, 0, -Math.PI, true)
  expect(`${clockwise}`).toBe('M2,0A2,2 0 0 0 0,-2A2,2 0 0 0 -2,0')
})

it.each([
  ['another x', 1, 0, 'M1,0L2,0A'],
  ['another y', 2, 1, 'M2,1L2,0A'],
  ['none of the two', 2, 0, 'M2,0A'],
])('leads a line to the start of an arc that has %s', (_, x, y, text) => {
  const path = new SvgPath()
  const other = new SvgPath()
  path.moveTo(x, y)
  other.moveTo(9, 9)
  path.arc(0, 0, 2, 0, 1)
  expect(`${path}`.startsWith(text)).toBe(true)
  expect(`${other}`).toBe('M9,9')
})

it('joins an arc that starts where the text already is, whatever the last bit of its cosine', () => {
  const path = new SvgPath(2)
  path.moveTo(1 + 1e-12, 0)
  path.arc(0, 0, 1, 0, Math.PI)
  expect(String(path)).not.toContain('L')
  const exact = new SvgPath()
  exact.moveTo(1 + 1e-12, 0)
  exact.arc(0, 0, 1, 0, Math.PI)
  expect(String(exact)).toContain('L')
})
