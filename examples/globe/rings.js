// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of GeoJSON as polygons of d3-geo GeoJSON cuts polygons at 180 degrees and has straight sides in degrees. On the
// sphere there is no cut, and d3-geo has arcs of great circles as sides, and the inside on the right of a ring.

/**
 * The longest side in degrees. A longer arc of a great circle would leave its parallel visibly, and arcs along a meridian
 * are below 180.
 */
const LONGEST = { longitude: 1, latitude: 45 }

/**
 * Returns a cell for d3-geo.
 * @param {number[][][][]} coordinates of a MultiPolygon
 */
export function shapeOf(coordinates) {
  const rings = ringsOf(coordinates)
  // Cuts only: the cell is the whole sphere.
  if (rings.length === 0) return { type: 'Sphere' }
  return { type: 'Polygon', coordinates: rings.map((ring) => ring.toReversed()) }
}

/** Returns the rings on the sphere, with the inside on the left. */
function ringsOf(coordinates) {
  const sides = coordinates.flat().map((ring) => ring.slice(1).map((to, k) => [ring[k], to]))
  const meridian = new Set(sides.flat().filter(isOnMeridian).map(String))
  const isCut = ([from, to]) =>
    isSamePole(from, to) || (isOnMeridian([from, to]) && meridian.has(String([mirrored(to), mirrored(from)])))
  const rings = []
  const waiting = new Map()
  for (const ring of sides) {
    const first = ring.findIndex(isCut)
    if (first < 0) {
      rings.push(joined([ring]))
      continue
    }
    for (const run of runsOf([...ring.slice(first), ...ring.slice(0, first)], isCut)) {
      const start = placeOf(run[0][0])
      waiting.set(start, [...(waiting.get(start) ?? []), run])
    }
  }
  for (const [start, runs] of waiting) {
    while (runs.length > 0) {
      const chain = []
      let place = start
      do {
        const run = waiting.get(place).pop()
        chain.push(run)
        place = placeOf(run.at(-1)[1])
      } while (place !== start)
      rings.push(joined(chain))
    }
  }
  return rings
}

/** Splits the sides of a ring where sides are cuts, and leaves these out. */
function runsOf(sides, isCut) {
  const runs = []
  let isNew = true
  for (const side of sides) {
    if (isCut(side)) isNew = true
    else if (isNew) {
      runs.push([side])
      isNew = false
    } else runs.at(-1).push(side)
  }
  return runs
}

/** Returns the points of runs of sides, with further points on long sides. The last point is the first. */
function joined(runs) {
  const sides = runs.flat()
  return [
    sides[0][0],
    ...sides.flatMap(([from, to]) => {
      const [across, up] = [Math.abs(to[0] - from[0]), Math.abs(to[1] - from[1])]
      const parts = Math.ceil(Math.max(across / LONGEST.longitude, up / LONGEST.latitude)) || 1
      return Array.from({ length: parts }, (_, k) => (k + 1 === parts ? to : between(from, to, (k + 1) / parts)))
    }),
  ]
}

function between(from, to, share) {
  return from.map((value, k) => value + share * (to[k] - value))
}

function isOnMeridian([from, to]) {
  return Math.abs(from[0]) === 180 && from[0] === to[0]
}

function isSamePole(from, to) {
  return Math.abs(from[1]) === 90 && from[1] === to[1]
}

function mirrored([longitude, latitude]) {
  return [-longitude, latitude]
}

/** Names a place of the sphere, which may have several longitudes. */
function placeOf([longitude, latitude]) {
  if (Math.abs(latitude) === 90) return String(latitude)
  return String([Math.abs(longitude) === 180 ? 180 : longitude, latitude])
}
