// SPDX-License-Identifier: GPL-3.0-or-later
// Where an element is on the screen, whatever transforms, zoom or shadow roots are around it.
import type { Point } from '../lib/index.ts'

/** Elements whose sides differ by less than this share are squares. */
const SQUARE = 0.02

/**
 * Returns where a mouse, pen, finger or wheel is, in CSS pixels of the element that hears it. Browsers map the position through all
 * transforms, also in perspective, but count pixels as they are after zoom.
 */
export function pointOf({ offsetX, offsetY, target }: MouseEvent): Point {
  const { currentCSSZoom: zoom = 1 } = (target ?? {}) as { readonly currentCSSZoom?: number }
  return { x: offsetX / zoom, y: offsetY / zoom }
}

/** Returns how many CSS pixels of the screen a CSS pixel of an element is long. */
export function scaleOnScreen(element: HTMLElement): number {
  const { offsetWidth: w, offsetHeight: h } = element
  if (w === 0 || h === 0) return 1
  const { width, height } = element.getBoundingClientRect()
  if (Math.abs(w - h) < SQUARE * w) return Math.max(width / w, height / h)
  // The box around a turned rectangle: width = a w + b h and height = b w + a h, for the scale times |cos| and |sin|.
  const determinant = w * w - h * h
  return Math.hypot(width * w - height * h, height * w - width * h) / Math.abs(determinant)
}
