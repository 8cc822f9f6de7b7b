// SPDX-License-Identifier: GPL-3.0-or-later
// Writes public/data/cities.region.json: the outline of the land on which the cities of public/data/cities.csv lie, from Natural
// Earth (public domain) in the npm package world-atlas. It is a list of rings on the map of the cities, in kilometers.
import { readFileSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { onMap, REACH } from './cities.mjs'
import { isMain, main, ROOT } from './run.mjs'

/** How far the outline may be from the one that Natural Earth has, in kilometers. */
const TOLERANCE = 3

/** The rings: outer ones only, the largest first. */
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
  // Between two of these countries, an arc belongs to both; what belongs to one is the outline.
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

/** Steps between whole numbers, as TopoJSON has them, as points on the map. */
function pointsOf(arc, { scale, translate }) {
  let [x, y] = [0, 0]
  return arc.map(([dx, dy]) => {
    x += dx
    y += dy
    return onMap([x * scale[0] + translate[0], y * scale[1] + translate[1]]).map((value) => Number(value.toFixed(1)))
  })
}

/** Leaves out points that are nearly on the line of those that stay, by Douglas and Peucker. The ends stay. */
function simplified(points) {
  let [farthest, most] = [0, TOLERANCE]
  for (let k = 1; k < points.length - 1; k++) {
    const d = distance(points[k], points[0], points.at(-1))
    if (d > most) [farthest, most] = [k, d]
  }
  if (farthest === 0) return points.length < 3 ? points : [points[0], points.at(-1)]
  return [...simplified(points.slice(0, farthest + 1)).slice(0, -1), ...simplified(points.slice(farthest))]
}

/** From a point to a segment. */
function distance([x, y], [x0, y0], [x1, y1]) {
  const [dx, dy] = [x1 - x0, y1 - y0]
  const square = dx * dx + dy * dy
  const share = square === 0 ? 0 : Math.min(Math.max(((x - x0) * dx + (y - y0) * dy) / square, 0), 1)
  return Math.hypot(x - x0 - share * dx, y - y0 - share * dy)
}

/** The points of arcs, one after the other, without the last one, which is the first. */
function joined(names, arcs) {
  return names.flatMap((arc) => (arc < 0 ? arcs[~arc].toReversed() : arcs[arc]).slice(0, -1))
}

/** Rings of arcs, each of which goes on where one ends. */
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

function contains(ring, [x, y]) {
  let isInside = false
  ring.forEach(([x1, y1], k) => {
    const [x0, y0] = ring.at(k - 1)
    if (y0 > y !== y1 > y && x < x0 + ((y - y0) / (y1 - y0)) * (x1 - x0)) isInside = !isInside
  })
  return isInside
}

/** Positive for a ring around land, as the arcs of TopoJSON run: clockwise. */
function area(ring) {
  return ring.reduce((sum, [x, y], k) => {
    const [x0, y0] = ring.at(k - 1)
    return sum + (x * y0 - x0 * y) / 2
  }, 0)
}

/** The text of the file: a line for each ring. */
export function textOf(rings) {
  return `[\n${rings.map((ring) => JSON.stringify(ring)).join(',\n')}\n]\n`
}

if (isMain(import.meta.url)) {
  await main(() => writeFileSync(`${ROOT}public/data/cities.region.json`, textOf(borderOfCities())))
}
