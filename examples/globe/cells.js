// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes of a diagram for drawing.
import { EARTH_RADIUS } from 'circle-voronoi/sphere'
import { shapeOf } from './rings.js'
import { vectorOf } from './view.js'

/** The zoom of shapes changes by this factor, so that a wheel does not make new ones at each step. */
const STEP = 4
/** The largest distance between drawn and true borders, in pixels of a globe with a radius of 1000 pixels. */
const ACCURACY = 0.5

/**
 * @typedef {object} Cell
 * @property {number} circle
 * @property {object} shape for d3-geo
 * @property {object} border lines for d3-geo: the part of the border that no other cell has
 * @property {readonly number[]} center unit vector
 * @property {number} reach the cosine of the largest angle between the center and the cell
 */

/** Makes the shapes of a diagram, and keeps them until the zoom differs much. */
export class Cells {
  #diagram
  #level
  #cells = []
  #byCircle = new Map()

  constructor(diagram) {
    this.#diagram = diagram
  }

  /** @returns {readonly Cell[]} */
  at(zoom) {
    const level = Math.max(Math.ceil(Math.log(zoom) / Math.log(STEP)), 0)
    if (level === this.#level) return this.#cells
    this.#level = level
    const tolerance = ((ACCURACY / 1000) * EARTH_RADIUS) / STEP ** level
    this.#cells = Array.from({ length: this.#diagram.caps.length / 3 }, (_, circle) => circle).flatMap((circle) => {
      const coordinates = this.#diagram.cellPolygon(circle, { tolerance })
      return coordinates === undefined ? [] : [cellOf(circle, coordinates, this.#diagram.caps)]
    })
    this.#byCircle = new Map(this.#cells.map((cell) => [cell.circle, cell]))
    return this.#cells
  }

  /** Returns the shape of a circle's cell; `undefined` for a hidden circle. */
  shapeOf(circle, zoom) {
    this.at(zoom)
    return this.#byCircle.get(circle)?.shape
  }
}

function cellOf(circle, coordinates, caps) {
  const shape = shapeOf(coordinates)
  const center = vectorOf([caps[3 * circle], caps[3 * circle + 1]])
  const rings = shape.coordinates ?? []
  // A cell is star-shaped around its center, so its farthest point is on its border, unless it is the whole sphere.
  const reach = rings.flat().reduce((least, point) => Math.min(least, dot(vectorOf(point), center)), 1)
  return {
    circle,
    shape,
    border: { type: 'MultiLineString', coordinates: rings.flatMap(forwardLines) },
    center,
    reach: shape.type === 'Sphere' ? -1 : reach,
  }
}

/** Returns the lines of a ring in one direction, as both cells at a border have it in opposite ones. */
function forwardLines(ring) {
  const lines = []
  let isOpen = false
  for (let k = 1; k < ring.length; k++) {
    const [from, to] = [ring[k - 1], ring[k]]
    const isForward = from[0] === to[0] ? from[1] < to[1] : from[0] < to[0]
    if (isForward && isOpen) lines.at(-1).push(to)
    else if (isForward) lines.push([from, to])
    isOpen = isForward
  }
  return lines
}

export function dot(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
