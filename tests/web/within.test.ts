// SPDX-License-Identifier: GPL-3.0-or-later
// The circles between the tags of an element, on stub nodes.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { circlesWithin } from '../../web/element/data-of.ts'
import { FakeNode, FakePage } from './fake-nodes.ts'

class Table extends FakeNode {
  readonly rows: unknown[]
  constructor(...rows: string[][]) {
    super('table')
    this.rows = rows.map((cells) => ({ cells: cells.map((textContent) => ({ textContent })) }))
  }
}

let page: FakePage
beforeEach(() => {
  page = new FakePage()
  vi.stubGlobal('HTMLTableElement', Table)
  vi.stubGlobal(
    'Node',
    class {
      static readonly TEXT_NODE = 3
      readonly nodeType = 0
    },
  )
})
afterEach(() => vi.unstubAllGlobals())

const table = () => new Table(['x', 'y', 'r'], ['1', '2', '3'])
const numbers = (element: unknown) => {
  const found = circlesWithin(element as Element)
  return found && [...found.circles]
}
/** A node whose children are nodes and texts. */
function node(tag: string, ...children: (FakeNode | string)[]): FakeNode {
  const made = page.make(tag)
  made.append(...children)
  const childNodes = children.map((child) =>
    typeof child === 'string' ? { nodeType: 3, textContent: child } : Object.assign(child, { nodeType: 1 }),
  )
  Object.defineProperty(made, 'textContent', { value: made.textContent })
  const elements = children.filter((child) => typeof child !== 'string')
  return Object.assign(made, { childNodes, children: elements, localName: tag })
}
const script = (text: string) => {
  const made = node('script', text)
  made.setAttribute('type="application/json"', '')
  return made
}

it('circles are a script, else a table, else a table in Markdown', () => {
  expect(numbers(node('circle-voronoi', script('[[7, 8, 9]]'), table()))).toEqual([7, 8, 9])
  expect(numbers(node('circle-voronoi', '|4|5|6|', node('div', table())))).toEqual([1, 2, 3])
  expect(numbers(node('circle-voronoi', '\n |4|5|6|', node('b', '|7|8|9|'), '\n|1|1|1|\n'))).toEqual([4, 5, 6, 1, 1, 1])
  for (const others of [[], ['4|5|6'], [node('b', '|7|8|9|')]])
    expect(numbers(node('circle-voronoi', ...others))).toBeUndefined()
})

it('a table that Markdown has moved behind the element belongs to it, if an empty paragraph closes it', () => {
  /** The element in a paragraph, with the nodes after that. */
  const moved = (paragraph: FakeNode, ...after: FakeNode[]) => {
    const [element] = paragraph.children as [FakeNode]
    const all = [paragraph, ...after]
    all.forEach((one, k) => {
      Object.assign(one, { nextElementSibling: all[k + 1] ?? null })
    })
    return numbers(element)
  }
  const element = () => node('circle-voronoi')
  expect(moved(node('p', element()), table(), node('p'))).toEqual([1, 2, 3])
  expect(moved(node('p', element()), node('div', table()), node('p'))).toEqual([1, 2, 3])
  expect(moved(node('p', element(), '\n'), table(), node('p'))).toEqual([1, 2, 3])
  // Others are tables of the page.
  expect(moved(node('div', element()), table(), node('p'))).toBeUndefined()
  expect(moved(node('p', element(), 'text'), table(), node('p'))).toBeUndefined()
  expect(moved(node('p', element(), node('b')), table(), node('p'))).toBeUndefined()
  expect(moved(node('p', element()), table(), node('p', 'text'))).toBeUndefined()
  expect(moved(node('p', element()), table(), node('div'))).toBeUndefined()
  expect(moved(node('p', element()), table())).toBeUndefined()
  expect(moved(node('p', element()), node('div'), node('p'))).toBeUndefined()
})
