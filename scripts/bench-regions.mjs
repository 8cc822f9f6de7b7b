// SPDX-License-Identifier: GPL-3.0-or-later
import { ROOT } from './run.mjs'

const POLYGONS = 10_000
const LIVE = { circles: 100_000, sides: 1000, edits: 300 }

/**
 * Returns a row for polygons in a region against those in bounds, and one for edits after which the changed cells are clipped
 * again: milliseconds. Needs dist/lib.
 */
export async function benchRegions() {
  const { loadCircleVoronoi } = await import(`${ROOT}dist/lib/index.js`)
  const { loadRegions } = await import(`${ROOT}dist/lib/regions.js`)
  const library = await loadCircleVoronoi()
  const { region } = await loadRegions()
  return [polygons(library, region), edits(library, region)]
}

function polygons(library, region) {
  const inBounds = () => [...fresh().cellPolygons({ bounds: [0, 0, 1, 1] })].length
  const square = region([unitSquare()])
  const inRegion = () => [...fresh().cellPolygons({ region: square })].length
  const circles = randomCircles(POLYGONS)
  const diagram = library.compute(circles)
  // A copy without cached results of earlier queries.
  const fresh = () => new diagram.constructor(diagram)
  const times = [inBounds, inRegion].map((run) => median(Array.from({ length: 7 }, () => millisecondsOf(run))))
  return { what: `cellPolygons of ${POLYGONS}`, bounds: times[0], region: times[1], ratio: times[1] / times[0] }
}

/** Circles jump to places near the boundary, one by one. */
function edits(library, region) {
  const { circles, sides, edits } = LIVE
  const random = randomUnits(sides)
  const ring = Array.from({ length: sides }, (_, k) => {
    const angle = (2 * Math.PI * k) / sides
    const radius = 0.35 + 0.1 * random()
    return [0.5 + radius * Math.cos(angle), 0.5 + radius * Math.sin(angle)]
  })
  const coast = region([ring])
  const editor = library.edit(randomCircles(circles))
  const diagram = editor.snapshot()
  const r = 0.2 / Math.sqrt(circles)
  const times = Array.from({ length: edits }, () => {
    const [x, y] = ring[Math.floor(sides * random())]
    const id = Math.floor(circles * random())
    return millisecondsOf(() => {
      const change = editor.replace(id, { x, y, r })
      diagram.apply(change)
      for (const cell of change.cells) diagram.cellArea(diagram.indexOf(cell), { region: coast })
    })
  })
  return { what: `edits of ${circles} in ${sides} sides`, median: median(times), worst: Math.max(...times) }
}

function randomCircles(count) {
  const random = randomUnits(count)
  return Float64Array.from({ length: 3 * count }, (_, k) =>
    k % 3 === 2 ? (0.3 * random()) / Math.sqrt(count) : random(),
  )
}

function unitSquare() {
  return [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ]
}

/** Park and Miller's generator. */
function randomUnits(seed) {
  let state = seed
  return () => {
    state = (state * 48_271) % 2_147_483_647
    return state / 2_147_483_647
  }
}

function median(times) {
  return times.toSorted((one, other) => one - other)[times.length >> 1]
}

function millisecondsOf(run) {
  const start = performance.now()
  run()
  return Number((performance.now() - start).toPrecision(3))
}
