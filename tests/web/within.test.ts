// SPDX-License-Identifier: GPL-3.0-or-later
// The circles between the tags of an element.
// @vitest-environment happy-dom
import { expect, it } from 'vitest'
import { circlesWithin } from '../../web/element/data-of.ts'
import { make } from './page-document.ts'

const node = (tag: string, ...children: (Node | string)[]) => make(tag as 'div', {}, ...children)
const table = () =>
  node(
    'table',
    ...[
      ['x', 'y', 'r'],
      ['1', '2', '3'],
    ].map((cells) => node('tr', ...cells.map((cell) => node('td', cell)))),
  )
const numbers = (element: Element) => {
  const found = circlesWithin(element)
  return found && [...found.circles]
}
const script = (text: string) => make('script', { type: 'application/json' }, text)

it('circles are a script, else a table, else a table in Markdown', () => {
  expect(numbers(node('circle-voronoi', script('[[7, 8, 9]]'), table()))).toEqual([7, 8, 9])
  expect(numbers(node('circle-voronoi', '|4|5|6|', node('div', table())))).toEqual([1, 2, 3])
  expect(numbers(node('circle-voronoi', '\n |4|5|6|', node('b', '|7|8|9|'), '\n|1|1|1|\n'))).toEqual([4, 5, 6, 1, 1, 1])
  for (const others of [[], ['4|5|6'], [node('b', '|7|8|9|')]])
    expect(numbers(node('circle-voronoi', ...others))).toBeUndefined()
})

it('a table that Markdown has moved behind the element belongs to it, if an empty paragraph closes it', () => {
  /** The element in a paragraph, with the nodes after that. */
  const moved = (paragraph: Element, ...after: Element[]) => {
    node('div', paragraph, ...after)
    return numbers(paragraph.children[0] as Element)
  }
  const element = () => node('circle-voronoi')
  expect(moved(node('p', element()), table(), node('p'))).toEqual([1, 2, 3])
  expect(moved(node('p', element()), node('div', table()), node('p'))).toEqual([1, 2, 3])
  expect(moved(node('p', element(), '\n'), table(), node('p'))).toEqual([1, 2, 3])
  // Tables elsewhere belong to the page.
  expect(moved(node('div', element()), table(), node('p'))).toBeUndefined()
  expect(moved(node('p', element(), 'text'), table(), node('p'))).toBeUndefined()
  expect(moved(node('p', element(), node('b')), table(), node('p'))).toBeUndefined()
  expect(moved(node('p', element()), table(), node('p', 'text'))).toBeUndefined()
  expect(moved(node('p', element()), table(), node('div'))).toBeUndefined()
  expect(moved(node('p', element()), table())).toBeUndefined()
  expect(moved(node('p', element()), node('div'), node('p'))).toBeUndefined()
})
