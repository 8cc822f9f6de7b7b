// SPDX-License-Identifier: GPL-3.0-or-later
// Reads SVG drawings. Drawings of the page have a link or a table in their metadata; drawings of the program have circles.
import { CircleVoronoiError } from '../../lib/base/errors.ts'
import { escaped, unescaped } from '../../lib/drawing/escaped.ts'
import type { Read } from './files-protocol.ts'

const LINK = /<metadata id="circle-voronoi">(v\d+\.[\w-]+)<\/metadata>/
const TABLE = /<metadata id="circle-voronoi-circles">([^<]*)<\/metadata>/
// Older drawings of the program also have ids.
const CIRCLES = /<g (?:id="circles" )?class="circles"[^<>]*>([\s\S]*?)<\/g>/
// Periodic drawings are refused, because their lattice is not in them.
const PERIODIC = /<g id="given[^<>]*>/
// The markup of circles, and of points for radius 0.
const CIRCLE = /<circle data-circle="(\d+)"[^<>]* cx="([^"]+)" cy="([^"]+)" r="([^"]+)"\/?>/y

/** Adds a link with the drawing's state. */
export function withLink(svg: string, link: string): string {
  return withMetadata(svg, 'circle-voronoi', link)
}

/** Adds the circles as CSV, if they are too many for a link. */
export function withTable(svg: string, csv: string): string {
  return withMetadata(svg, 'circle-voronoi-circles', `\n${escaped(csv)}`)
}

function withMetadata(svg: string, id: string, text: string): string {
  return svg.replace('>\n', () => `>\n<metadata id="${id}">${text}</metadata>\n`)
}

/** The CSV in a drawing. */
export function tableOfSvg(text: string): string | undefined {
  const table = TABLE.exec(text)?.[1]
  return table && unescaped(table.trimStart())
}

/** @throws CircleVoronoiError `badInput` */
export function circlesOfSvg(text: string, name: string): Read {
  const link = LINK.exec(text)?.[1]
  if (link !== undefined) return { link }
  const group = (!PERIODIC.test(text) && CIRCLES.exec(text)?.[1]) || ''
  const lines = group.split('\n').filter((line) => line !== '')
  const circles = new Float64Array(3 * lines.length)
  for (const [k, line] of lines.entries()) {
    CIRCLE.lastIndex = 0
    const [, i, ...numbers] = CIRCLE.exec(line) ?? []
    // If some circles are missing, for example outside the drawing's box, the rest is not the original set.
    if (Number(i) !== k) refuse(name)
    circles.set(numbers.map(Number), 3 * k)
  }
  if (lines.length === 0 || !circles.every(Number.isFinite)) refuse(name)
  return { circles }
}

function refuse(name: string): never {
  throw new CircleVoronoiError('badInput', `${name}: this SVG is none that was saved here with all of its circles.`)
}
