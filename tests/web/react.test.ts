// SPDX-License-Identifier: GPL-3.0-or-later
// The component for React on an element that only keeps what it is given.
// @vitest-environment happy-dom
import { act, createElement, createRef, type ReactNode } from 'react'
// @ts-expect-error: it has no types
import { createRoot } from 'react-dom/client'
import { afterEach, beforeEach, expect, it } from 'vitest'
import type { CircleVoronoiElement } from '../../web/element/circle-voronoi-element.ts'
import type { CircleVoronoiComponentProps } from '../../web/element/react.ts'

/** The properties that were set since the last look. */
const set: [name: string, value: unknown][] = []
customElements.define(
  'circle-voronoi',
  class extends HTMLElement {
    set circles(value: unknown) {
      set.push(['circles', value])
    }
    set layers(value: unknown) {
      set.push(['layers', value])
    }
  },
)
const { CircleVoronoi } = await import('../../web/element/react.ts')

const place = document.createElement('div')
let root: { render(node: ReactNode): void; unmount(): void }
Object.assign(globalThis, { IS_REACT_ACT_ENVIRONMENT: true })
beforeEach(() => {
  root = createRoot(place)
})
afterEach(() => act(() => root.unmount()))

/** Renders with properties, and returns those of the element that were set. */
function render(props: CircleVoronoiComponentProps, ref = createRef<CircleVoronoiElement>()) {
  act(() => root.render(createElement(CircleVoronoi, { ...props, ref })))
  return set.splice(0)
}
const figure = () => place.firstElementChild as HTMLElement

it('has attributes for all that is no object, as React 18 and servers write them', () => {
  const ref = createRef<CircleVoronoiElement>()
  const props = {
    ...{ alt: 'Trees', className: 'wide', style: { width: 3 }, controls: true, readonly: false, step: 0 },
    ...{
      title: undefined,
      view: undefined,
      'aria-hidden': true,
      'data-a': false,
      onError: () => {},
      children: 'inside',
    },
  }
  expect(render(props, ref)).toEqual([])
  const attributes = Object.fromEntries([...figure().attributes].map(({ name, value }) => [name, value]))
  expect(attributes).toEqual({
    ...{ alt: 'Trees', class: 'wide', style: expect.stringContaining('3px'), controls: '', step: '0' },
    ...{ 'aria-hidden': 'true', 'data-a': 'false' },
  })
  expect([figure().textContent, ref.current]).toEqual(['inside', figure()])
})

it('sets objects as properties, once for each, and unsets those that are gone', () => {
  const circles = Float64Array.of(0, 0, 1)
  const [layers, other] = [{ hull: true }, { hull: false }]
  expect(render({ circles, layers })).toEqual([
    ['circles', circles],
    ['layers', layers],
  ])
  expect(render({ circles, layers })).toEqual([])
  expect(render({ circles, layers: other })).toEqual([['layers', other]])
  expect(render({ circles: '[]', layers: other }).at(-1)).toEqual(['circles', '[]'])
  expect(render({ circles: '[]' })).toEqual([['layers', undefined]])
})

it.each([
  ['onCirclesChange', 'circleschange'],
  ['onDiagramChange', 'diagramchange'],
  ['onCheckChange', 'checkchange'],
  ['onSelectionChange', 'selectionchange'],
  ['onStepChange', 'stepchange'],
  ['onError', 'error'],
] as const)('the newest %s hears of %s until the end', (name, event) => {
  const told: string[] = []
  render({ [name]: () => told.push('first') })
  render({ [name]: () => told.push('second') })
  const element = figure()
  element.dispatchEvent(new Event(event))
  expect(told).toEqual(['second'])
  render({})
  element.dispatchEvent(new Event(event))
  render({ [name]: () => told.push('third') })
  act(() => root.unmount())
  element.dispatchEvent(new Event(event))
  expect(told).toEqual(['second'])
})
