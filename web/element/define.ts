// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * `<circle-voronoi>` if you already have the WebAssembly, or want another tag name.
 *
 * @module circle-voronoi/element/define
 */
import type { FigureLoadOptions } from '../view/load.ts'
import { CircleVoronoiElement } from './circle-voronoi-element.ts'

export * from './exports.ts'

/**
 * Options of `defineCircleVoronoi`.
 *
 * @category Element
 */
export interface DefineOptions extends FigureLoadOptions {
  /** The tag name, which must contain a hyphen. Default: `circle-voronoi`. */
  readonly name?: string | undefined
}

/**
 * Defines the element in a page. Does nothing outside of a page, or if the tag name is already defined.
 *
 * @category Element
 */
export function defineCircleVoronoi({ name = 'circle-voronoi', ...load }: DefineOptions = {}): void {
  if (globalThis.customElements === undefined || customElements.get(name) !== undefined) return
  // A class can have only one tag name.
  const Element = class extends CircleVoronoiElement {}
  Element.load = load
  customElements.define(name, Element)
}
