// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the globe on two canvases: cells below, and the marked cell above, so that hovering is cheap.
import { geoCircle, geoDistance, geoPath } from 'd3-geo'
import { dot } from './cells.js'
import { COAST } from './coast.js'
import { colorOf } from './colors.js'
import { projectionOf, scaleOf, vectorOf } from './view.js'

const DEGREE = Math.PI / 180
/** The radius of the dot in the middle of each circle, in pixels. */
const DOT = 1.6
/** A draft has at most so many circles. */
const MOST_IN_DRAFT = 3000
/** Coastlines fade where they are too coarse: at this zoom they are gone. */
const COARSE = 60

/**
 * @typedef {object} Scene
 * @property {import('circle-voronoi/sphere').SphereDiagram} diagram
 * @property {import('./cells.js').Cells} cells
 * @property {readonly string[]} colors names of colors, one for each circle
 * @property {object} view
 * @property {number | undefined} marked the circle of the marked cell
 * @property {string} name of this circle
 * @property {boolean} hasCursor whether the keyboard's cursor is in the middle
 */

/** Draws cells, borders, coastlines and circles. A draft has no cells, and not all circles. */
export function paintGlobe(context, size, { diagram, cells, colors, view }, palette, isDraft) {
  const projection = projectionOf(view, size)
  const path = geoPath(projection, context)
  const isSeen = seenFrom(view, size)
  const all = isDraft ? [] : cells.at(view.zoom)
  const seen = all.filter(({ center, reach }) => isSeen(center, Math.acos(Math.max(reach, -1))))
  clear(context, size)

  context.beginPath()
  path({ type: 'Sphere' })
  context.fillStyle = palette.water
  context.fill()

  context.lineWidth = 1
  for (const { circle, shape } of seen) {
    context.beginPath()
    path(shape)
    // The stroke covers the gaps that smoothing leaves between cells.
    context.fillStyle = context.strokeStyle = colorOf(palette, colors[circle])
    context.fill()
    context.stroke()
  }
  if (view.zoom < COARSE) {
    context.globalAlpha = Math.min(1, (COARSE - view.zoom) / COARSE)
    stroke(context, () => path(COAST), palette.coast, 1)
    context.globalAlpha = 1
  }
  const borders = { type: 'GeometryCollection', geometries: seen.map(({ border }) => border) }
  stroke(context, () => path(borders), palette.border, 1)
  const step = isDraft ? Math.ceil(diagram.caps.length / 3 / MOST_IN_DRAFT) : 1
  paintCircles(context, projection, diagram, step, isSeen, palette)
  stroke(context, () => path({ type: 'Sphere' }), palette.border, 1)
}

/** Draws the marked cell, the name of its circle, and the cursor of the keyboard in the middle. */
export function paintMarks(context, size, { diagram, cells, view, marked, name, hasCursor }, palette) {
  clear(context, size)
  const projection = projectionOf(view, size)
  const path = geoPath(projection, context)
  if (marked !== undefined) {
    const shape = cells.shapeOf(marked, view.zoom)
    if (shape !== undefined) stroke(context, () => path(shape), palette.accent, 2.5)
    const center = [diagram.caps[3 * marked], diagram.caps[3 * marked + 1]]
    if (geoDistance(center, [view.longitude, view.latitude]) < Math.PI / 2)
      label(context, projection(center), name, palette)
  }
  if (hasCursor) {
    const [x, y] = [size.width / 2, size.height / 2]
    const cross = () => {
      for (const [right, down] of [
        [1, 0],
        [0, 1],
      ]) {
        context.moveTo(x - 9 * right, y - 9 * down)
        context.lineTo(x + 9 * right, y + 9 * down)
      }
    }
    stroke(context, cross, palette.water, 4)
    stroke(context, cross, palette.accent, 2)
  }
}

/** Circles on the globe are ellipses in the picture, except across the horizon. */
function paintCircles(context, projection, { caps, radius }, step, isSeen, palette) {
  const path = geoPath(projection, context)
  const scale = projection.scale()
  const middlePoint = projection.translate()
  const [longitude, latitude] = projection.rotate()
  const middle = vectorOf([-longitude, -latitude])
  context.beginPath()
  const rims = []
  for (let k = 0; k < caps.length; k += 3 * step) {
    const place = [caps[k], caps[k + 1]]
    const vector = vectorOf(place)
    const angle = caps[k + 2] / radius
    const depth = dot(vector, middle)
    if (!isSeen(vector, angle)) continue
    if (depth > 0) {
      const [x, y] = projection(place)
      context.moveTo(x + DOT, y)
      context.arc(x, y, DOT, 0, 2 * Math.PI)
    }
    if (angle * scale < DOT) continue
    const isEllipse = angle < Math.PI / 2 && depth > Math.sin(angle)
    if (isEllipse) rims.push(ellipseOf(projection(place), middlePoint, angle, depth, scale))
    else
      rims.push(
        geoCircle()
          .center(place)
          .radius(angle / DEGREE)
          .precision(3)(),
      )
  }
  context.fillStyle = palette.disc
  context.fill()
  context.beginPath()
  for (const rim of rims) {
    if (rim.type === 'Polygon') path(rim)
    else {
      const { x, y, long, wide, turn } = rim
      context.moveTo(x + long * Math.cos(turn), y + long * Math.sin(turn))
      context.ellipse(x, y, long, wide, turn, 0, 2 * Math.PI)
    }
  }
  context.globalAlpha = 0.35
  context.fill()
  context.globalAlpha = 1
}

/** The picture of a circle around a place: its center is below the surface, and it is narrower toward the horizon. */
function ellipseOf([x, y], [middleX, middleY], angle, depth, scale) {
  const below = Math.cos(angle)
  return {
    x: middleX + (x - middleX) * below,
    y: middleY + (y - middleY) * below,
    long: scale * Math.sin(angle),
    wide: scale * Math.sin(angle) * depth,
    turn: Math.atan2(y - middleY, x - middleX) + Math.PI / 2,
  }
}

/** Returns a test whether a place, with so many radians around it, may be in the picture. */
function seenFrom(view, size) {
  const middle = vectorOf([view.longitude, view.latitude])
  const corner = Math.hypot(size.width, size.height) / 2 / scaleOf(view, size)
  const seen = corner < 1 ? Math.asin(corner) : Math.PI / 2
  return (vector, around) => Math.acos(Math.min(Math.max(dot(vector, middle), -1), 1)) <= seen + around + 1e-3
}

function label(context, [x, y], name, palette) {
  context.font = '600 14px system-ui, sans-serif'
  context.textAlign = 'center'
  context.lineJoin = 'round'
  context.lineWidth = 4
  context.strokeStyle = palette.water
  context.strokeText(name, x, y - 8)
  context.fillStyle = palette.ink
  context.fillText(name, x, y - 8)
}

function stroke(context, draw, color, width) {
  context.beginPath()
  draw()
  context.strokeStyle = color
  context.lineWidth = width
  context.stroke()
}

function clear(context, { width, height }) {
  context.clearRect(0, 0, width, height)
}
