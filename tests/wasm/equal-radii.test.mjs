// SPDX-License-Identifier: GPL-3.0-or-later
// With equal radii the diagram is the ordinary Voronoi diagram of the centers: d3-delaunay, which knows nothing of circles,
// must find the same triangles, hull and neighbors.
import assert from 'node:assert/strict'
import { describe, it } from 'node:test'
import { Delaunay } from 'd3-delaunay'
import { loadCircleVoronoi } from '../../dist/lib/index.js'

const SEED = Number(process.env.CIRCLE_VORONOI_SEED ?? 1)
const library = await loadCircleVoronoi()

describe(`equal radii against d3-delaunay, seed ${SEED}`, () => {
  for (const [count, radius] of [
    [3, 0],
    [10, 0],
    [100, 0.001],
    [1000, 0.02],
    [10_000, 1],
  ]) {
    it(`${count} circles of radius ${radius}`, () => {
      const points = randomPoints(count, SEED + count)
      const circles = points.map(([x, y]) => ({ x, y, r: radius }))
      const { vertexCircles, hull, edges } = library.compute(circles)
      const delaunay = Delaunay.from(points)
      assert.deepEqual(triangles(vertexCircles), triangles(delaunay.triangles, true))
      assert.deepEqual(fromSmallest([...hull]), fromSmallest([...delaunay.hull].reverse()))
      const neighbors = points.map(() => new Set())
      for (let e = 0; e < edges.length; e += 4) {
        neighbors[edges[e]].add(edges[e + 1])
        neighbors[edges[e + 1]].add(edges[e])
      }
      for (let i = 0; i < count; i++) {
        assert.deepEqual([...neighbors[i]].sort(), [...delaunay.neighbors(i)].sort(), `neighbors of ${i}`)
      }
    })
  }
})

/** Triangles as sorted text, each from its smallest corner. d3's triangles are clockwise if y points up. */
function triangles(corners, clockwise = false) {
  const result = []
  for (let t = 0; t < corners.length; t += 3) {
    const triangle = [corners[t], corners[t + 1], corners[t + 2]]
    result.push(fromSmallest(clockwise ? triangle.reverse() : triangle).join(' '))
  }
  return result.sort()
}

function fromSmallest(cycle) {
  const start = cycle.indexOf(Math.min(...cycle))
  return [...cycle.slice(start), ...cycle.slice(0, start)]
}

/** Mulberry32: small, seeded, good enough for general position. */
function randomPoints(count, seed) {
  let state = seed
  const random = () => {
    state = (state + 0x6d2b79f5) | 0
    let t = Math.imul(state ^ (state >>> 15), 1 | state)
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32
  }
  return Array.from({ length: count }, () => [random(), random()])
}
