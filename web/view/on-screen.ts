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
  const { currentCSSZoom: zoom = 1 } = (target ?? {}) as { readonly currentCSSZoom?: number }
  return { x: offsetX / zoom, y: offsetY / zoom }
}

/** Returns the length on the screen of one CSS pixel of an element. */
export function scaleOnScreen(element: HTMLElement): number {
  const { offsetWidth: w, offsetHeight: h } = element
  if (w === 0 || h === 0) return 1
  const { width, height } = element.getBoundingClientRect()
  if (Math.abs(w - h) < SQUARE * w) return Math.max(width / w, height / h)
  // The box around a rotated rectangle: width = a w + b h and height = b w + a h, where a and b are the scale times
  // |cos| and |sin|.
  const determinant = w * w - h * h
  return Math.hypot(width * w - height * h, height * w - width * h) / Math.abs(determinant)
}
