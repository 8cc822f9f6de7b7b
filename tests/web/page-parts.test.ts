// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the page that need no circles.
// @vitest-environment happy-dom
import { render } from 'lit/html.js'
import { beforeEach, expect, it, vi } from 'vitest'
import { pictureOf } from '../../web/app/generators/sample-picture.ts'
import { listenToPresses } from '../../web/app/input/after-press.ts'
import { restoreInvalidNumbers } from '../../web/app/input/invalid-numbers.ts'
import { make, openPage, send } from './page-document.ts'

beforeEach(() => void openPage())

it.each(['pointerup', 'pointercancel'])(
  'the layout changes at once, or after the click of a press that ends with %s',
  (end) => {
    vi.useFakeTimers()
    const afterPress = listenToPresses(document)
    const done: string[] = []
    afterPress(() => done.push('at once'))
    send(document, 'pointerdown')
    afterPress(() => done.push('after the press'))
    vi.runAllTimers()
    expect(done).toEqual(['at once'])
    send(document, end)
    expect(done).toEqual(['at once'])
    vi.runAllTimers()
    expect(done).toEqual(['at once', 'after the press'])
    vi.useRealTimers()
  },
)

it('a number field that is left with an invalid number gets its own last valid one back', () => {
  restoreInvalidNumbers(document)
  const fields = ['1', '2'].map((value) => make('input', { type: 'number', min: '0', value }))
  document.body.append(...fields)
  for (const field of fields) send(field, 'focusin')
  const [first, second] = fields as [HTMLInputElement, HTMLInputElement]
  first.value = '4'
  send(first, 'change')
  for (const field of fields) field.value = '-1'
  send(first, 'change')
  for (const field of fields) send(field, 'focusout')
  expect([first.value, second.value]).toEqual(['4', '2'])
})

it('a thumbnail has the circles in its middle, small ones large enough to be seen, and none that is huge or outside', () => {
  const pathOf = (...circles: number[]) => {
    const place = document.createElement('div')
    render(pictureOf(Float64Array.from(circles)), place)
    return place.querySelector('path')?.getAttribute('d')
  }
  // The box of 48 x 36 has a margin of 3: the circles are 30 high.
  expect(pathOf(0, 0, 1, 2, 0, 1)).toBe(
    'M3 18a10.5 10.5 0 1 0 21 0a10.5 10.5 0 1 0 -21 0M24 18a10.5 10.5 0 1 0 21 0a10.5 10.5 0 1 0 -21 0',
  )
  expect(pathOf(0, 0, 0, 0, 2, 0)).toBe(
    'M23.3 33a0.7 0.7 0 1 0 1.4 0a0.7 0.7 0 1 0 -1.4 0M23.3 3a0.7 0.7 0 1 0 1.4 0a0.7 0.7 0 1 0 -1.4 0',
  )
  const many = Array.from({ length: 40 }, (_, k) => [k % 6, Math.floor(k / 6), 0.3]).flat()
  const count = (more: number[]) => pathOf(...many, ...more)?.match(/M/g)?.length
  expect([count([]), count([1e6, 0, 1]), count([-1e9, 0, 1e9])]).toEqual([40, 40, 40])
})
