// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * `<circle-voronoi>` as a component of React 18 and 19, also for pages rendered on a server. React itself sets object
 * properties and adds listeners only on elements that it creates in the browser.
 *
 * @module circle-voronoi/react
 */
'use client'

import {
  createElement,
  type ForwardRefExoticComponent,
  forwardRef,
  type ReactNode,
  type RefAttributes,
  useEffect,
  useImperativeHandle,
  useLayoutEffect,
  useRef,
} from 'react'
import type { CircleVoronoiElement, CircleVoronoiEventMap } from './circle-voronoi-element.ts'
import type { CircleVoronoiProps } from './frameworks.ts'
import './index.ts'

/** The events, by the names that React gives to listeners. */
const LISTENERS = {
  onCirclesChange: 'circleschange',
  onDiagramChange: 'diagramchange',
  onCheckChange: 'checkchange',
  onGoalsChange: 'goalschange',
  onSelectionChange: 'selectionchange',
  onStepChange: 'stepchange',
  onError: 'error',
} as const satisfies Record<string, keyof CircleVoronoiEventMap>

type Listener<Name extends keyof CircleVoronoiEventMap> =
  | ((event: CircleVoronoiEventMap[Name] & { readonly target: CircleVoronoiElement }) => void)
  | undefined

type Listeners = { [Name in keyof typeof LISTENERS]?: Listener<(typeof LISTENERS)[Name]> }

/**
 * The properties of `CircleVoronoi`: the element's properties, a listener for each of its events, and the common
 * attributes of HTML elements.
 *
 * @category Element
 */
export interface CircleVoronoiComponentProps extends CircleVoronoiProps, Listeners {
  /** Called with `circleschange`. */
  onCirclesChange?: Listener<'circleschange'>
  /** Called with `diagramchange`. */
  onDiagramChange?: Listener<'diagramchange'>
  /** Called with `checkchange`. */
  onCheckChange?: Listener<'checkchange'>
  /** Called with `goalschange`. */
  onGoalsChange?: Listener<'goalschange'>
  /** Called with `selectionchange`. */
  onSelectionChange?: Listener<'selectionchange'>
  /** Called with `stepchange`. */
  onStepChange?: Listener<'stepchange'>
  /** Called with `error`. */
  onError?: Listener<'error'>
  /** The content that is visible where there is no figure, a `poster`, or a `caption`. */
  children?: ReactNode
  className?: string | undefined
  dir?: string | undefined
  hidden?: boolean | undefined
  id?: string | undefined
  slot?: string | undefined
  style?: Readonly<Record<string, string | number | undefined>> | undefined
  title?: string | undefined
  [name: `${'aria-' | 'data-'}${string}`]: unknown
}

// Servers have no layout, and React 18 warns about layout effects there.
const useEffectOfLayout = typeof document === 'undefined' ? useEffect : useLayoutEffect

/**
 * A figure of circles and their Voronoi diagram. Its `ref` is the element.
 *
 * @category Element
 * @example
 * <CircleVoronoi circles={circles} controls onCirclesChange={({ detail }) => setCircles(detail.circles)} />
 */
export const CircleVoronoi: ForwardRefExoticComponent<
  CircleVoronoiComponentProps & RefAttributes<CircleVoronoiElement>
> = forwardRef<CircleVoronoiElement, CircleVoronoiComponentProps>((props, forwarded) => {
  const element = useRef<CircleVoronoiElement>(null)
  const listeners = useRef<CircleVoronoiComponentProps>(props)
  const objects = useRef<Record<string, object>>({})
  useImperativeHandle(forwarded, () => element.current as CircleVoronoiElement, [])

  useEffectOfLayout(() => {
    listeners.current = props
    const figure = element.current as unknown as Record<string, unknown>
    const next = objectsOf(props)
    for (const name of Object.keys(objects.current)) {
      // If the new value is text, React has already set the attribute.
      if (!Object.hasOwn(next, name)) figure[name] = (props as Record<string, unknown>)[name]
    }
    for (const [name, value] of Object.entries(next)) if (objects.current[name] !== value) figure[name] = value
    objects.current = next
  })

  useEffectOfLayout(() => {
    const figure = element.current as CircleVoronoiElement
    const controller = new AbortController()
    for (const [name, event] of Object.entries(LISTENERS) as [keyof Listeners, keyof CircleVoronoiEventMap][]) {
      const tell = (told: Event) => (listeners.current[name] as ((event: Event) => void) | undefined)?.(told)
      figure.addEventListener(event, tell, { signal: controller.signal })
    }
    return () => controller.abort()
  }, [])

  return createElement('circle-voronoi', { ...attributesOf(props), ref: element }, props.children)
})
CircleVoronoi.displayName = 'CircleVoronoi'

/** The properties whose values are objects, which attributes cannot hold. */
function objectsOf(props: CircleVoronoiComponentProps): Record<string, object> {
  const entries = Object.entries(props).filter(([name, value]) => isOfElement(name) && isObject(value))
  return Object.fromEntries(entries)
}

/** The attributes, which work before any script runs. */
function attributesOf(props: CircleVoronoiComponentProps): Record<string, unknown> {
  const attributes: Record<string, unknown> = {}
  for (const [name, value] of Object.entries(props)) {
    if (name === 'className') attributes.class = value
    else if (name === 'style') attributes.style = value
    else if (isOfElement(name) && !isObject(value)) {
      // React 18 writes `true` and `false` as text, and React 19 writes `true` as an empty text.
      const isText = typeof value === 'boolean' && /^(aria|data)-/.test(name)
      const said = isText ? String(value) : value === true ? '' : value
      if (said !== false && said !== null && said !== undefined) attributes[name] = said
    }
  }
  return attributes
}

function isOfElement(name: string): boolean {
  return !['children', 'className', 'style'].includes(name) && !Object.hasOwn(LISTENERS, name)
}

function isObject(value: unknown): value is object {
  return typeof value === 'object' && value !== null
}
