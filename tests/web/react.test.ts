// SPDX-License-Identifier: GPL-3.0-or-later
// The component for React, with hooks that run at once.
import { beforeEach, expect, it, vi } from 'vitest'
import { CircleVoronoi, type CircleVoronoiComponentProps } from '../../web/element/react.ts'

const hooks = vi.hoisted(() => ({
  refs: [] as { current: unknown }[],
  next: 0,
  effects: [] as { run: () => unknown; once: boolean }[],
  handle: undefined as (() => unknown) | undefined,
}))
vi.mock('react', () => ({
  createElement: (...args: unknown[]) => args,
  forwardRef: (render: unknown) => ({ render }),
  useRef: (first: unknown) => {
    hooks.refs[hooks.next] ??= { current: first }
    return hooks.refs[hooks.next++]
  },
  useEffect: (run: () => unknown, on?: readonly unknown[]) => hooks.effects.push({ run, once: on?.length === 0 }),
  useLayoutEffect: () => {
    throw new Error('There is no layout on a server.')
  },
  useImperativeHandle: (_: unknown, handle: () => unknown) => {
    hooks.handle = handle
  },
}))
vi.mock('../../web/element/index.ts', () => ({}))

class Figure extends EventTarget {
  readonly set: [string, unknown][] = []
  constructor() {
    super()
    // biome-ignore lint/correctness/noConstructorReturn: every property is recorded.
    return new Proxy(this, {
      get: (target, name) => {
        const value = Reflect.get(target, name)
        return typeof value === 'function' ? value.bind(target) : value
      },
      set: (target, name, value) => Boolean(target.set.push([name as string, value])),
    })
  }
}

let figure: Figure
let isMounted: boolean
let unmount: () => void
beforeEach(() => {
  figure = new Figure()
  isMounted = false
  Object.assign(hooks, { refs: [], next: 0, effects: [], handle: undefined })
})

/** Renders with properties. Returns the tag, the attributes, the children, and the properties that were set. */
function render(props: CircleVoronoiComponentProps) {
  hooks.next = 0
  hooks.effects = []
  const { render } = CircleVoronoi as unknown as { render: (props: unknown, ref: unknown) => unknown[] }
  const [tag, { ref, ...attributes }, children] = render(props, null) as [
    string,
    { ref: { current: unknown } },
    unknown,
  ]
  ref.current = figure
  for (const { run, once } of hooks.effects) {
    if (once && isMounted) continue
    const end = run()
    if (once) unmount = end as () => void
  }
  isMounted = true
  return { tag, attributes, children, set: figure.set.splice(0) }
}

it('has attributes for all that is no object, as React 18 and servers write them', () => {
  expect(
    render({
      alt: 'Trees',
      className: 'wide',
      style: { width: 3 },
      controls: true,
      readonly: false,
      step: 0,
      title: undefined,
      view: null as never,
      'aria-hidden': true,
      'data-a': true,
      onError: () => {},
      children: 'inside',
    }),
  ).toEqual({
    tag: 'circle-voronoi',
    attributes: {
      alt: 'Trees',
      class: 'wide',
      style: { width: 3 },
      controls: '',
      step: 0,
      'aria-hidden': true,
      'data-a': true,
    },
    children: 'inside',
    set: [],
  })
  expect(hooks.handle?.()).toBe(figure)
})

it('sets objects as properties, once for each, and unsets those that are gone', () => {
  const circles = Float64Array.of(0, 0, 1)
  const layers = { hull: true }
  expect(render({ circles, layers }).set).toEqual([
    ['circles', circles],
    ['layers', layers],
  ])
  expect(render({ circles, layers }).set).toEqual([])
  const other = { hull: false }
  expect(render({ circles, layers: other }).set).toEqual([['layers', other]])
  expect(render({ circles: '[]', layers: other })).toMatchObject({
    set: [['circles', '[]']],
    attributes: { circles: '[]' },
  })
  expect(render({ circles: '[]' }).set).toEqual([['layers', undefined]])
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
  figure.dispatchEvent(new Event(event))
  expect(told).toEqual(['second'])
  render({})
  figure.dispatchEvent(new Event(event))
  render({ [name]: () => told.push('third') })
  unmount()
  figure.dispatchEvent(new Event(event))
  expect(told).toEqual(['second'])
})
