// SPDX-License-Identifier: GPL-3.0-or-later
// Small scenes as drawings whose colors the style sheet sets. The first scene is one in the page itself: it is seen before any
// script or WebAssembly has come. scripts/site.mjs has it made when the site is built.
import type { Diagram } from '../lib/index.ts'
import { boundingBox } from '../view/camera.ts'
import { Coloring } from '../view/painter/coloring.ts'

/** Extent of cells and edges, relative to that of the circles. It exceeds the aspect ratio of every window. */
const REACH = 12
/** Digits after the decimal point, of circles that are a few units large. */
const DIGITS = 3
/** Extent of cells and edges in a thumbnail, and its number of pixels along the longest side. */
const REACH_OF_THUMBNAIL = 2
const PIXELS = 200

/** Returns an SVG whose box is that of the circles; cells overflow it. The style sheet sets the colors. */
export function firstPicture(diagram: Diagram): string {
  return drawn(diagram, 'id="first-picture"', REACH, 1e-4, DIGITS)
}

/** A thumbnail of a diagram. `rings`: a region that clips the cells; `name` names its clip path. */
export function thumbnail(diagram: Diagram, name: string, rings: readonly (readonly (readonly number[])[])[]): string {
  const { minX, minY, maxX, maxY } = boundingBox(diagram.circles)
  const digits = Math.max(Math.ceil(Math.log10(PIXELS / Math.max(maxX - minX, maxY - minY))), 0)
  const number = (value: number) => value.toFixed(digits)
  const outline = rings.map((ring) => `M${ring.map(([x = 0, y = 0]) => `${number(x)} ${number(y)}`).join('L')}Z`)
  return drawn(diagram, 'class="thumbnail"', REACH_OF_THUMBNAIL, 1 / PIXELS, digits, {
    name: `thumbnail-${name}`,
    outline: outline.join(''),
  })
}

function drawn(
  diagram: Diagram,
  attribute: string,
  reach: number,
  tolerance: number,
  digits: number,
  { name, outline } = { name: '', outline: '' },
): string {
  const { circles } = diagram
  const box = boundingBox(circles)
  const size = Math.max(box.maxX - box.minX, box.maxY - box.minY)
  const far = reach * size
  const [x, y] = [(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2]
  const bounds = { minX: x - far, minY: y - far, maxX: x + far, maxY: y + far }
  const options = { bounds, tolerance: tolerance * size, digits }
  const coloring = new Coloring(diagram)
  const color = (i: number) => `class="c${coloring.colorOf(i)}"`
  const indices = Array.from({ length: circles.length / 3 }, (_, i) => i)
  const cells = indices.map((i) => `<path ${color(i)} d="${diagram.cellPath(i, options)}"/>`)
  const discs = indices.map((i) => {
    const [x, y, r] = circles.subarray(3 * i, 3 * i + 3)
    return `<circle ${color(i)} cx="${x}" cy="${y}" r="${r}"/>`
  })
  const edges = `<path class="edges" d="${diagram.render(options)}"/>`
  const isClipped = outline !== ''
  const clip = isClipped ? `<clipPath id="${name}"><path clip-rule="evenodd" d="${outline}"/></clipPath>` : ''
  const clipped = isClipped ? ` clip-path="url(#${name})"` : ''
  // y is upwards in the plane, and downwards in a drawing.
  const viewBox = [box.minX, -box.maxY, box.maxX - box.minX, box.maxY - box.minY].join(' ')
  return `<svg ${attribute} viewBox="${viewBox}" aria-hidden="true"><g transform="scale(1 -1)">${clip}<g class="cells"${clipped}>${cells.join('')}</g>${discs.join('')}<g${clipped}>${edges}</g></g></svg>`
}
