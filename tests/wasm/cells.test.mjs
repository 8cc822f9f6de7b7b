// SPDX-License-Identifier: GPL-3.0-or-later
// Cells in bounds and at distances, with all ties, against brute force with hundreds of bits and against the clip in
// WebAssembly. CIRCLE_VORONOI_CELLS=300000 tries more of them, CIRCLE_VORONOI_SEED others.
import assert from 'node:assert/strict'
import { describe, it } from 'node:test'
import {
  ConvexPolygon,
  largestEmptyDiscCenteredIn,
  largestEmptyDiscInside,
  loadCircleVoronoi,
} from '../../dist/lib/index.js'
import { loadMetrics } from '../../dist/lib/metrics.js'
import { loadRegions } from '../../dist/lib/regions.js'
import { cellByBruteForce } from './cell-oracle.mjs'
import { innerModule } from './inner-module.mjs'
import { FAMILIES, makeCase, randomOf } from './tie-families.mjs'

const SEED = Number(process.env.CIRCLE_VORONOI_SEED ?? 1)
const CELLS = Number(process.env.CIRCLE_VORONOI_CELLS ?? 2000)
/** Pieces shorter than a share of the bounds may be rounding. One of the shares tells them from others. */
const SHORTEST = [1e-9, 1e-7, 1e-11]
/** The largest difference of areas, as a share of the bounds. */
const ACCURACY = 1e-12

const { keptParts } = await innerModule('regions/outline')
const library = await loadCircleVoronoi()
const { compute } = await loadMetrics({ library })
const { region } = await loadRegions()

/** The finite vertices of circles, not very far away. */
function verticesOf(circles) {
  const { vertices } = library.compute(circles)
  const all = Array.from({ length: vertices.length / 3 }, (_, v) => [...vertices.subarray(3 * v, 3 * v + 3)])
  return all.filter((vertex) => vertex.every((number) => Math.abs(number) < 1e4))
}

/** Returns a case with its bounds and diagram. */
function prepared(made) {
  const { circles, corners, isBox, maxDistance, metric, weights = false } = made
  const [[minX, minY], , [maxX, maxY]] = corners
  const bounds = isBox ? { minX, minY, maxX, maxY } : ConvexPolygon.from(corners.map(([x, y]) => ({ x, y })))
  const polygon = ConvexPolygon.of(bounds)
  return { ...made, polygon, options: { bounds, maxDistance }, diagram: compute(circles, { metric, weights }) }
}

/** Returns a case of a family; `undefined` if it is no valid input. */
function preparedCase(family, seed) {
  try {
    return prepared(makeCase(family, randomOf(seed), verticesOf))
  } catch (error) {
    // Corners that are not convex, or an empty box.
    if (error.code === 'badOption') return undefined
    throw error
  }
}

function lengthOf({ bisector, from, to, start, end }) {
  const across = bisector.a === 0 ? 0 : (bisector.b * (to - 1 / to - from + 1 / from)) / 2
  return Math.max(Math.hypot(end.x - start.x, end.y - start.y), across)
}

function labelOf({ neighbor, r }) {
  return neighbor >= 0 ? String(neighbor) : r > 0 ? 'arc' : 'bounds'
}

/** Loops as text: the labels of pieces that are long enough, each loop from the same place. */
function textOf(loops, shortest) {
  return loops
    .map((loop) => loop.filter(({ length }) => length > shortest).map(({ label }) => label))
    .filter(({ length }) => length > 0)
    .map((labels) => labels.map((_, k) => [...labels.slice(k), ...labels.slice(0, k)].join(' ')).sort()[0])
    .sort()
    .join(' | ')
}

function assertSameLoops(ours, theirs, size, message) {
  if (SHORTEST.some((share) => textOf(ours, share * size) === textOf(theirs, share * size))) return
  assert.equal(textOf(ours, SHORTEST[0] * size), textOf(theirs, SHORTEST[0] * size), message)
}

/** The parts of edges in cells are those of edges alone, bit for bit, in both cells. */
function assertSameParts({ diagram, polygon, options }, outlines, message) {
  const parts = diagram.edges.filter((_, k) => k % 4 === 0).map(() => [])
  /** @type {{ left: string[], right: string[] }[]} */
  const found = [...parts].map(() => ({ left: [], right: [] }))
  const textOfPart = ({ start, end, from, to }) => [start.x, start.y, end.x, end.y, from, to].join()
  for (const piece of outlines.flat(2)) {
    if (piece.side < 0) continue
    found[piece.side >> 1][piece.side % 2 === 0 ? 'left' : 'right'].push(textOfPart(piece.forward))
  }
  found.forEach(({ left, right }, edge) => {
    const limits = { bounds: polygon, maxDistance: options.maxDistance }
    const alone = keptParts(diagram, edge, limits).map(({ curve }) => textOfPart(curve))
    assert.deepEqual(left.sort(), alone.sort(), `${message}: the left side of edge ${edge}`)
    assert.deepEqual(right.sort(), alone, `${message}: the right side of edge ${edge}`)
  })
}

/** Compares the cells of a case. Returns their number, without those that brute force cannot tell. */
function compareCells(made, message) {
  const { circles, corners, scale, metric, polygon, options, diagram, weights } = made
  const size = Math.sqrt(polygon.area())
  const areas = diagram.cellAreas(options)
  const outlines = circles.map((_, i) => diagram.cellOutline(i, options))
  assertSameParts(made, outlines, message)
  const exact = { region: region([corners]), maxDistance: options.maxDistance }
  let count = 0
  outlines.forEach((outline, i) => {
    assert.ok(Object.is(diagram.cellArea(i, options), areas[i]), `${message}: the area of cell ${i} among all`)
    const loops = outline.map((loop) =>
      loop.map((piece) => ({ label: labelOf(piece), length: lengthOf(piece.curve) / scale })),
    )
    const clipped = diagram
      .cellOutline(i, exact)
      .map((loop) => loop.map((piece) => ({ label: labelOf(piece), length: lengthOf(piece.curve) / scale })))
    assertSameLoops(loops, clipped, size / scale, `${message}: cell ${i} and that of the exact clip`)
    const right = cellByBruteForce(circles, i, corners, options.maxDistance, metric, scale, weights)
    if (right === undefined) return
    count += 1
    const theirs = right.loops.map((loop) => loop.map((piece) => ({ ...piece, label: piece.label.split(' ')[0] })))
    assertSameLoops(loops, theirs, size / scale, `${message}: cell ${i}`)
    const error = Math.abs(areas[i] / scale / scale - right.area) / (size / scale) ** 2
    assert.ok(error <= ACCURACY, `${message}: the area of cell ${i} is off by ${error} of the bounds`)
  })
  return count
}

/** Whether the sides of a closed ring cross. */
function crossesItself(ring) {
  const side = ([ax, ay], [bx, by], [cx, cy]) => {
    const turn = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    const size = (Math.abs(bx - ax) + Math.abs(by - ay)) * (Math.abs(cx - ax) + Math.abs(cy - ay))
    return Math.abs(turn) <= 1e-9 * size ? 0 : Math.sign(turn)
  }
  const sides = ring.slice(1).map((b, k) => [ring[k], b])
  return sides.some(([a, b], k) =>
    sides.slice(k + 2).some(([c, d]) => side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0),
  )
}

function doubleAreaOf(ring) {
  return ring.slice(1).reduce((sum, [x, y], k) => {
    const [ax, ay] = ring[0]
    const [bx, by] = ring[k]
    return sum + (bx - ax) * (y - ay) - (by - ay) * (x - ax)
  }, 0)
}

const families = Object.keys(FAMILIES)

describe(`cells in bounds, seed ${SEED}`, () => {
  for (const family of families) {
    it(`are right for ${family}`, () => {
      for (let count = 0, k = 0; count < CELLS / families.length; k++) {
        const made = preparedCase(family, SEED * 1_000_003 + k)
        if (made !== undefined) count += compareCells(made, `case ${k}: ${JSON.stringify(made)}`)
      }
    })
  }

  const boxOf = (minX, minY, maxX, maxY) => ({
    corners: [
      [minX, minY],
      [maxX, minY],
      [maxX, maxY],
      [minX, maxY],
    ],
    isBox: true,
  })
  for (const [name, given] of Object.entries({
    'a corner nearly on the line of its neighbors': {
      circles: [
        [0, 0, 20],
        [0, -300, 0],
      ],
      corners: [
        [200, 0],
        [105.61405064662918, 322.19297467668548],
        [-95.385949353370833, -79.807025323314576],
        [-296.38594935337079, -481.80702532331458],
      ],
    },
    'discs exactly through a corner that lies on their bisector': {
      circles: [
        [-32, -126, 12],
        [32, -126, 12],
      ],
      ...boxOf(0, -373, 25, 137),
      maxDistance: 237.06424873915566,
    },
    'a disc that a box cuts next to its corner': {
      circles: [
        [0, 195, 210],
        [117, 156, 210],
      ],
      ...boxOf(-76, -165, -55, -30.5),
      maxDistance: 154.17715469260287,
    },
    'a box of integers on which an edge lies': {
      circles: [
        [48, -16380, 1],
        [52, -16381, 1],
        [51, -16381, 2],
        [50, -16383, 2],
        [50, -16380, 0.99999999999999989],
        [49, -16384, 0],
      ],
      ...boxOf(49, -16381, 50, -16380),
    },
    'a circle whose lowest point is a corner': {
      circles: [
        [6, -1, 0],
        [3, -2, 0],
        [-1, 1, 1],
        [7, 0, 2],
        [6, -2, 0],
      ],
      ...boxOf(-1, -6, 3, -5),
      maxDistance: 5,
    },
  })) {
    it(`are right for ${name}`, () => {
      const made = prepared({ isBox: false, metric: 'circles', scale: 1, ...given })
      assert.equal(compareCells(made, name), made.circles.length)
    })
  }
})

it(`areas far from the origin are right, seed ${SEED}`, () => {
  let count = 0
  for (let k = 0; count < CELLS / 10; k++) {
    const made = preparedCase(families[k % families.length], SEED * 1_000_003 + k)
    if (made === undefined || made.scale !== 1 || made.metric === 'power') continue
    const offset = 2 ** (10 * (1 + (k % 3)))
    const moved = ([x, y, ...radius]) => [x + offset, y - offset, ...radius]
    // Two circles have no vertices, whose coordinates are rounded.
    const circles = made.circles.slice(0, 2).map(moved)
    const corners = made.corners.map(moved)
    let far
    try {
      far = prepared({ ...made, circles, corners })
    } catch {
      continue // Rounding has made corners equal, or not convex.
    }
    circles.forEach((_, i) => {
      const right = cellByBruteForce(circles, i, corners, far.options.maxDistance, far.metric, 1)
      const error = Math.abs(far.diagram.cellArea(i, far.options) - Number(right?.area)) / far.polygon.area()
      assert.ok(error <= ACCURACY, `case ${k}: the area of cell ${i} is off by ${error} of the bounds`)
      count += 1
    })
  }
})

describe('a maximum distance', () => {
  it('below an ulp of a center makes an empty or a tiny part', () => {
    for (const center of [1, 1e6, 7e28]) {
      for (const share of [1e-3, 1e-13, 1e-15, 1e-16, 1e-17, 1e-20]) {
        const diagram = library.compute([
          [center, center, 0],
          [-center, 0, 0],
        ])
        const maxDistance = share * center
        const area = diagram.cellArea(0, { maxDistance })
        const ulp = 2 ** -52 * center
        assert.ok(area >= 0 && area <= Math.PI * (maxDistance + 2 * ulp) ** 2, `${center} ${share}: ${area}`)
        assert.equal(typeof diagram.cellPath(0, { maxDistance }), 'string')
        const ring = diagram.cellPolygon(0, { maxDistance })
        assert.ok(ring === undefined || doubleAreaOf(ring) > 0)
      }
    }
  })

  it('makes no polygon of a cell whose points are rounding', () => {
    const diagram = library.compute([
      [-3.658651128411293, -1.4929765276610851, 5.4113464411348104],
      [-0.808681882917881, -5.161143563687801, 2.466914888471365],
      [-1.6104316636919975, -6.94679244235158, 3.577522210776806],
    ])
    const bounds = [-3.658651128411293, -4.881830581410473, -1.7245422115552924, -0.49297652766108513]
    const options = {
      bounds: /** @type {[number, number, number, number]} */ (bounds),
      maxDistance: -1.5094098578629167,
    }
    assert.equal(diagram.cellPolygon(1, options), undefined)
    assert.equal(diagram.cellPolygon(0, options)?.length, 8)
  })

  it(`makes polygons that do not cross themselves at any tolerance, seed ${SEED}`, () => {
    let rings = 0
    for (let k = 0; rings < CELLS; k++) {
      const made = preparedCase(families[k % families.length], SEED * 1_000_003 + k)
      if (made === undefined) continue
      const { circles, diagram, options, polygon } = made
      for (let i = 0; i < circles.length; i++) {
        // The polygon of several loops goes along the same segments there and back.
        if (diagram.cellOutline(i, options).length !== 1) continue
        for (const share of [1e-3, 1e-2, 0.1, 0.5, 3]) {
          const ring = diagram.cellPolygon(i, { ...options, tolerance: share * Math.sqrt(polygon.area()) })
          if (ring === undefined) continue
          rings += 1
          const message = `case ${k}, cell ${i}, tolerance ${share}: ${JSON.stringify(ring)}`
          assert.ok(ring.length > 3 && doubleAreaOf(ring) > 0, message)
          assert.ok(!crossesItself(ring), message)
        }
      }
    }
  })
})

it(`the largest discs in bounds are as large as those in the same region, seed ${SEED}`, () => {
  for (let k = 0; k < CELLS / 10; k++) {
    const made = preparedCase(families[k % families.length], SEED * 1_000_003 + k)
    if (made === undefined || made.metric !== 'circles') continue
    const { corners, diagram, options, polygon } = made
    const size = Math.sqrt(polygon.area()) + Math.max(...made.circles.flat().map(Math.abs))
    for (const largest of [largestEmptyDiscCenteredIn, largestEmptyDiscInside]) {
      const found = Number(largest(diagram, { bounds: options.bounds })?.disc.r)
      const right = Number(largest(diagram, { region: region([corners]) })?.disc.r)
      assert.ok(Math.abs(found - right) <= 1e-9 * size, `case ${k}: ${found}, not ${right}`)
    }
  }
})
