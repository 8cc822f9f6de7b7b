// SPDX-License-Identifier: GPL-3.0-or-later
// Writes public/data/cities.region.json: the outline of the land on which the cities of public/data/cities.csv lie, from Natural
// Earth (public domain) in the npm package world-atlas. It is a list of rings on the map of the cities, in kilometers.
import { readFileSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { onMap, REACH } from './cities.mjs'
import { isMain, main, ROOT } from './run.mjs'

/** Largest distance between the simplified outline and that of Natural Earth, in kilometers. */
const TOLERANCE = 3

/** Returns the outer rings, the largest first. */
export function borderOfCities() {
  const world = createRequire(import.meta.url)('world-atlas/countries-50m.json')
  const arcs = world.arcs.map((arc) => simplified(pointsOf(arc, world.transform)))
  const rows = readFileSync(`${ROOT}public/data/cities.csv`, 'utf8').trim().split('\n').slice(1)
  const cities = rows.map((row) => row.split(',').slice(0, 2).map(Number))
  const polygons = world.objects.countries.geometries
    .flatMap(({ type, arcs }) => (type === 'Polygon' ? [arcs] : arcs))
    .map(([outer]) => ({ outer, ring: joined(outer, arcs) }))
    .filter(({ ring }) => ring.every((point) => Math.max(...point.map(Math.abs)) < 1.5 * REACH))
    .filter(({ ring }) => cities.some((city) => contains(ring, city)))
  // An arc between two countries belongs to both. An arc of one country is part of the outline.
  const uses = new Map()
  for (const { outer } of polygons) {
    for (const arc of outer) uses.set(arcOf(arc), (uses.get(arcOf(arc)) ?? 0) + 1)
  }
  const left = polygons.flatMap(({ outer }) => outer).filter((arc) => uses.get(arcOf(arc)) === 1)
  return chained(left, arcs)
    .filter((ring) => area(ring) > 0)
    .sort((one, other) => area(other) - area(one))
}

/** Arcs that run backwards are named by their complement. */
function arcOf(arc) {
  return arc < 0 ? ~arc : arc
}

/** Decodes TopoJSON's delta-encoded arcs into points of the map. */
function pointsOf(arc, { scale, translate }) {
  let [x, y] = [0, 0]
  return arc.map(([dx, dy]) => {
    x += dx
    y += dy
    return onMap([x * scale[0] + translate[0], y * scale[1] + translate[1]]).map((value) => Number(value.toFixed(1)))
  })
}

/** Simplifies a line (Douglas and Peucker). Its ends stay. */
function simplified(points) {
  let [farthest, most] = [0, TOLERANCE]
  for (let k = 1; k < points.length - 1; k++) {
    const d = distance(points[k], points[0], points.at(-1))
    if (d > most) [farthest, most] = [k, d]
  }
  if (farthest === 0) return points.length < 3 ? points : [points[0], points.at(-1)]
  return [...simplified(points.slice(0, farthest + 1)).slice(0, -1), ...simplified(points.slice(farthest))]
}

/** The distance from a point to a segment. */
function distance([x, y], [x0, y0], [x1, y1]) {
  const [dx, dy] = [x1 - x0, y1 - y0]
  const square = dx * dx + dy * dy
  const share = square === 0 ? 0 : Math.min(Math.max(((x - x0) * dx + (y - y0) * dy) / square, 0), 1)
  return Math.hypot(x - x0 - share * dx, y - y0 - share * dy)
}

/** Concatenates arcs. The last point is left out because it equals the first. */
function joined(names, arcs) {
  return names.flatMap((arc) => (arc < 0 ? arcs[~arc].toReversed() : arcs[arc]).slice(0, -1))
}

/** Chains arcs into rings. */
function chained(names, arcs) {
  const endOf = (arc, isStart) => String(arc < 0 === isStart ? arcs[arcOf(arc)].at(-1) : arcs[arcOf(arc)][0])
  const byStart = new Map()
  for (const arc of names) byStart.set(endOf(arc, true), [...(byStart.get(endOf(arc, true)) ?? []), arc])
  const rings = []
  for (const [start, waiting] of byStart) {
    while (waiting.length > 0) {
      const ring = []
      let place = start
      do {
        const arc = byStart.get(place).pop()
        ring.push(arc)
        place = endOf(arc, false)
      } while (place !== start)
      rings.push(joined(ring, arcs))
    }
  }
  return rings
}

/**
 * @param {number[][]} ring
 * @param {number[]} point
 */
function contains(ring, [x, y]) {
  let isInside = false
  ring.forEach(([x1, y1], k) => {
    const [x0, y0] = ring[(k || ring.length) - 1]
    if (y0 > y !== y1 > y && x < x0 + ((y - y0) / (y1 - y0)) * (x1 - x0)) isInside = !isInside
  })
  return isInside
}

/** The signed area. Rings around land are clockwise in TopoJSON, which counts as positive. */
function area(ring) {
  return ring.reduce((sum, [x, y], k) => {
    const [x0, y0] = ring[(k || ring.length) - 1]
    return sum + (x * y0 - x0 * y) / 2
  }, 0)
}

/** The text of the file, with a line for each ring. */
export function textOf(rings) {
  return `[\n${rings.map((ring) => JSON.stringify(ring)).join(',\n')}\n]\n`
}

if (isMain(import.meta.url)) {
  await main(() => writeFileSync(`${ROOT}public/data/cities.region.json`, textOf(borderOfCities())))
}
