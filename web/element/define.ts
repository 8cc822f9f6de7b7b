// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * `<circle-voronoi>` for who has the WebAssembly already, or wants another name.
 *
 * @module circle-voronoi/element/define
 */
import type { LoadOptions } from '../lib/wasm/load-options.ts'
import { CircleVoronoiElement } from './circle-voronoi-element.ts'

export * from './exports.ts'

/**
 * How the element is defined.
 *
 * @category Element
 */
export interface DefineOptions extends LoadOptions {
  /** The name of its tag, with a hyphen in it. Default: `circle-voronoi`. */
  readonly name?: string | undefined
}

/**
 * Defines the element in a page, once; nothing happens where there is no page, or something has that name.
 *
 * @category Element
 */
export function defineCircleVoronoi({ name = 'circle-voronoi', ...load }: DefineOptions = {}): void {
  if (globalThis.customElements === undefined || customElements.get(name) !== undefined) return
  // A class has one name.
  const Element = class extends CircleVoronoiElement {}
  Element.load = load
  customElements.define(name, Element)
}
