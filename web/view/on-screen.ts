// SPDX-License-Identifier: GPL-3.0-or-later
// The position of an element on the screen under transforms, zoom and shadow roots.
import type { Point } from '../lib/index.ts'

/** Elements whose sides differ by less than this fraction count as squares. */
const SQUARE = 0.02

/**
 * Returns the position of a pointer or wheel in CSS pixels of the target element. Browsers invert all transforms,
 * including perspective, but count pixels after zoom.
 */
export function pointOf({ offsetX, offsetY, target }: MouseEvent): Point {
  const zoom = zoomOf(target as Zoomed | null)
  return { x: offsetX / zoom, y: offsetY / zoom }
}

/** Returns the length on the screen of one CSS pixel of an element. */
export function scaleOnScreen(element: HTMLElement): number {
  const { offsetWidth: w, offsetHeight: h } = element
  if (w === 0 || h === 0) return 1
  const { width, height } = element.getBoundingClientRect()
  // Engines that lack the property count the sides of boxes before zoom.
  const zoom = 'currentCSSZoom' in element ? 1 : zoomOf(element)
  if (Math.abs(w - h) < SQUARE * w) return zoom * Math.max(width / w, height / h)
  // The box around a rotated rectangle: width = a w + b h and height = b w + a h, where a and b are the scale times
  // |cos| and |sin|.
  const determinant = w * w - h * h
  return (zoom * Math.hypot(width * w - height * h, height * w - width * h)) / Math.abs(determinant)
}

type Zoomed = Element & { readonly currentCSSZoom?: number }

/** Returns the product of the CSS `zoom` of an element and of all elements around it. */
function zoomOf(element: Zoomed | null): number {
  if (element === null) return 1
  if (element.currentCSSZoom !== undefined) return element.currentCSSZoom
  // WebKit has no such property.
  let zoom = 1
  for (let around: Element | undefined = element; around !== undefined; around = outerOf(around)) {
    zoom *= Number(getComputedStyle(around).getPropertyValue('zoom')) || 1
  }
  return zoom
}

/** Returns the element in which another one is drawn, also across shadow roots. */
function outerOf(element: Element): Element | undefined {
  const { parentNode } = element
  return (
    element.assignedSlot ?? element.parentElement ?? (parentNode instanceof ShadowRoot ? parentNode.host : undefined)
  )
}
