// SPDX-License-Identifier: GPL-3.0-or-later
// The first scene as a drawing in the page itself: it is seen before any script or WebAssembly has come. scripts/site.mjs has it
// made when the site is built.
import type { Diagram } from '../lib/index.ts'
import { boundingBox } from '../view/camera.ts'
import { Coloring } from '../view/painter/coloring.ts'

/** Extent of cells and edges, relative to that of the circles. It exceeds the aspect ratio of every window. */
const REACH = 12
/** Digits after the decimal point, of circles that are a few units large. */
const DIGITS = 3

/** Returns an SVG whose box is that of the circles; cells overflow it. The style sheet sets the colors. */
export function firstPicture(diagram: Diagram): string {
  const { circles } = diagram
  const box = boundingBox(circles)
  const size = Math.max(box.maxX - box.minX, box.maxY - box.minY)
  const far = REACH * size
  const options = { bounds: { minX: -far, minY: -far, maxX: far, maxY: far }, tolerance: size / 1e4, digits: DIGITS }
  const coloring = new Coloring(diagram)
  const color = (i: number) => `class="c${coloring.colorOf(i)}"`
  const indices = Array.from({ length: circles.length / 3 }, (_, i) => i)
  const cells = indices.map((i) => `<path ${color(i)} d="${diagram.cellPath(i, options)}"/>`)
  const discs = indices.map((i) => {
    const [x, y, r] = circles.subarray(3 * i, 3 * i + 3)
    return `<circle ${color(i)} cx="${x}" cy="${y}" r="${r}"/>`
  })
  // y is upwards in the plane, and downwards in a drawing.
  const viewBox = [box.minX, -box.maxY, box.maxX - box.minX, box.maxY - box.minY].join(' ')
  return `<svg id="first-picture" viewBox="${viewBox}" aria-hidden="true"><g transform="scale(1 -1)"><g class="cells">${cells.join('')}</g>${discs.join('')}<path class="edges" d="${diagram.render(options)}"/></g></svg>`
}
