// SPDX-License-Identifier: GPL-3.0-or-later
// The coastlines of Natural Earth in the package world-atlas
import { arcs, transform } from 'world-atlas/land-110m.json'

const { scale, translate } = transform

/**
 * All coastlines: the arcs of the TopoJSON, whose points are differences of whole numbers. Arcs along 180 degrees are no
 * coasts.
 */
export const COAST = {
  type: 'MultiLineString',
  coordinates: arcs.map(pointsOf).filter((points) => points.some(([longitude]) => Math.abs(longitude) < 180)),
}

function pointsOf(arc) {
  let [x, y] = [0, 0]
  return arc.map(([right, up]) => {
    x += right
    y += up
    return [x * scale[0] + translate[0], y * scale[1] + translate[1]]
  })
}
