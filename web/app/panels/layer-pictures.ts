// SPDX-License-Identifier: GPL-3.0-or-later
import { html, svg, type TemplateResult } from 'lit/html.js'

// Icons of layers: two circles and a point, with the layer's lines.
const CIRCLES = svg`<circle class="c" cx="9" cy="15" r="5" /><circle class="c" cx="24" cy="7" r="3" />`
const EDGE = 'M11 1c1 6 5 10 11 15'
const OTHERS = svg`<path class="q" d=${EDGE} />`

const PICTURES = {
  circles: svg`<circle class="f" cx="9" cy="15" r="5" /><circle class="f" cx="24" cy="7" r="3" />`,
  labels: svg`${CIRCLES}<path class="edge" d="M6 18l3-7 3 7m-5-2.500h4" />`,
  grid: svg`<path class="q" d="M1 5h30M1 11h30M22 0v22M28 0v22M10 0v22M4 0v22" /><path class="edge" d="M1 17h30M16 0v22" />`,
  cells: svg`<path class="a" d="M0 0h11c1 6 5 10 11 16v6H0z" /><path class="b" d="M11 0c1 6 5 10 11 16h10V0z" />`,
  fullColor: svg`<path class="f" d="M0 0h11c1 6 5 10 11 16v6H0z" /><path class="g" d="M11 0c1 6 5 10 11 16h10V0z" />`,
  edges: svg`${CIRCLES}<path class="edge" d=${EDGE} />`,
  vertices: svg`<path class="q" d="M1 3l13 8M14 11l2 10M14 11 31 6" /><circle class="vertex" cx="14" cy="11" r="2.6" />`,
  disc: svg`${CIRCLES}${OTHERS}<circle class="touching" cx="15.500" cy="8.300" r="4.300" /><circle class="touching dot" cx="12.200" cy="11.200" r="1.500" /><circle class="touching dot" cx="19.700" cy="7.700" r="1.500" />`,
  hidden: svg`<circle class="c" cx="16" cy="11" r="9" /><circle class="hidden" cx="19" cy="9" r="3.500" /><path class="hidden" d="M19 9l-3 2" />`,
  hull: svg`${CIRCLES}<path class="hull" d="M12 19.200 26 9.200a3 3 0 0 0-3-5L6 11a5 5 0 0 0 6 8.200z" />`,
  dual: svg`${CIRCLES}${OTHERS}<path class="dual" d="M9 15 24 7" />`,
  delaunay: svg`<path class="delaunay" d="M4 18 12 4l15 5zM12 4l17-2-2 7" /><circle class="dot" cx="4" cy="18" r="1.500" /><circle class="dot" cx="12" cy="4" r="1.500" /><circle class="dot" cx="27" cy="9" r="1.500" />`,
  ordinary: svg`${CIRCLES}<path class="ordinary" d="M10 0l11 22" />`,
  power: svg`${CIRCLES}<path class="power" d="M12 0l11 22" />`,
  largestDisc: svg`<circle class="c" cx="5" cy="5" r="3.500" /><circle class="c" cx="27" cy="7" r="3" /><circle class="c" cx="16" cy="22" r="3" /><circle class="touching" cx="16" cy="9.500" r="9" />`,
  path: svg`<circle class="c" cx="9" cy="6" r="4" /><circle class="c" cx="20" cy="17" r="4" /><path class="path" d="M2 18c8 0 12-8 28-14" />`,
  maxDistance: svg`<path class="b" d="M4 15a9 9 0 0 1 12-8.400A16 16 0 0 0 21 17a9 9 0 0 1-17-2z" /><circle class="c" cx="12" cy="14" r="3.500" />`,
  samples: svg`${CIRCLES}<circle class="samples" cx="13" cy="12" r="1.800" /><circle class="samples" cx="5" cy="18" r="1.800" /><circle class="samples" cx="21" cy="6" r="1.800" />`,
  sampleGraph: svg`<path class="sample-graph" d="M3 18 13 12l8-8 8 8-16 0 4 9z" />`,
  antipodalDiscs: svg`${CIRCLES}<circle class="antipodal" cx="17.200" cy="10.700" r="4.300" />`,
  directedEdges: svg`${CIRCLES}<path class="directed" d="M9 15 22 8.500m-5 0 5-.2-2.500 4.300" />`,
  missedEdges: svg`${CIRCLES}${OTHERS}<path class="missed" d="M12.500 6c1.600 3.500 4 6 6.500 8" />`,
} as const

export type Pictured = keyof typeof PICTURES

/** The icon of a layer, in its color. */
export function pictureOf(layer: Pictured): TemplateResult {
  return html`<svg class="picture" viewBox="0 0 32 22" aria-hidden="true">${PICTURES[layer]}</svg>`
}
