// SPDX-License-Identifier: GPL-3.0-or-later
// Declares the element in JSX and in templates. Declarations for frameworks that are not installed have no effect.

import type { Check } from '../lib/check-types.ts'
import type { Circles, Lattice, Method } from '../lib/index.ts'
import type { LinkView } from '../lib/link.ts'
import type { RegionShape } from '../lib/regions/region-shape.ts'
import type { Areas } from '../view/domain.ts'
import type { Layers } from '../view/layers.ts'
import type { CircleVoronoiEventMap } from './circle-voronoi-element.ts'

/**
 * The properties of `<circle-voronoi>` in JSX and in templates. `undefined` and `null` mean "not set", and a string is
 * read like the attribute.
 *
 * @category Element
 */
export interface CircleVoronoiProps {
  alt?: string | null | undefined
  areas?: Areas | string | null | undefined
  check?: Check | string | null | undefined
  circles?: Circles | string | null | undefined
  controls?: string | boolean | null | undefined
  dissolve?: boolean | null | undefined
  lang?: string | undefined
  lattice?: Lattice | string | null | undefined
  layers?: Partial<Layers> | string | null | undefined
  method?: Method | null | undefined
  name?: string | null | undefined
  readonly?: boolean | null | undefined
  region?: RegionShape | string | null | undefined
  samples?: number | string | null | undefined
  selection?: readonly number[] | null | undefined
  src?: string | null | undefined
  step?: number | string | null | undefined
  value?: Circles | string | null | undefined
  view?: LinkView | string | null | undefined
}

/** The listener properties of the events. */
type Listeners = {
  [Name in keyof CircleVoronoiEventMap as `on${Name}`]?: ((event: CircleVoronoiEventMap[Name]) => void) | undefined
}
type VueListeners = {
  [Name in keyof CircleVoronoiEventMap as `on${Capitalize<Name>}`]?: Listeners[`on${Name}`]
}
/** The common properties of elements in a framework. */
interface Common {
  [name: `${'aria-' | 'data-' | 'on'}${string}`]: unknown
  children?: unknown
  class?: unknown
  className?: string | undefined
  dir?: string | undefined
  hidden?: boolean | undefined
  id?: string | undefined
  key?: string | number | bigint | null | undefined
  ref?: unknown
  slot?: string | undefined
  style?: unknown
  tabIndex?: number | undefined
  title?: string | undefined
}
type Props = Common & CircleVoronoiProps & Listeners

/** @ts-ignore Only where it is installed: React from 19 on */
declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'circle-voronoi': Props
    }
  }
}
/** @ts-ignore Only where it is installed */
declare module 'preact' {
  namespace JSX {
    interface IntrinsicElements {
      'circle-voronoi': Props
    }
  }
}
/** @ts-ignore Only where it is installed */
declare module 'vue' {
  interface GlobalComponents {
    'circle-voronoi': new () => { $props: Common & CircleVoronoiProps & VueListeners }
  }
}
/** @ts-ignore Only where it is installed */
declare module 'svelte/elements' {
  interface SvelteHTMLElements {
    'circle-voronoi': Props
  }
}
