// SPDX-License-Identifier: GPL-3.0-or-later
import { hierarchy } from 'd3-hierarchy'
import { voronoiTreemap } from 'd3-voronoi-treemap'
import { secondsOf } from './bench-areas.mjs'
import { ROOT } from './run.mjs'

const SQUARE = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
]

/**
 * Returns a row for each hierarchy: seconds of `treemap` in WebAssembly and of d3-voronoi-treemap with its defaults, the
 * largest relative error of a leaf's area, and how far sites move, as a share of the root of a mean cell's area, when one
 * value changes by a hundredth: `treemap` with `previous`, and d3-voronoi-treemap with the same random numbers. Needs
 * dist/lib.
 */
export async function benchTreemaps() {
  const { loadRegions } = await import(`${ROOT}dist/lib/regions.js`)
  const { region, treemap } = await loadRegions()
  const square = region([SQUARE])
  const ours = (root, previous) => treemap(root, { region: square, previous })
  // Code that has run once is faster.
  for (const run of [ours, mapped]) measured(treeOf(300, 17), run)
  const rows = []
  for (const [leaves, perNode] of [
    [300, 300],
    [300, 17],
    [5000, 17],
    [5000, 71],
  ]) {
    const data = treeOf(leaves, perNode)
    const own = measured(data, ours)
    const d3 = ofTheirs(data)
    rows.push({
      leaves,
      'children of a node': perNode,
      ...named('treemap', own),
      ...named('d3', d3),
      'times faster': Number((d3.seconds / own.seconds).toFixed(1)),
    })
  }
  return rows
}

/** Some trees end in an error of d3-voronoi-treemap. */
function ofTheirs(data) {
  try {
    return measured(data, mapped)
  } catch ({ message }) {
    return { seconds: Number.NaN, error: message, moved: Number.NaN }
  }
}

function named(name, { seconds, error, moved }) {
  return { [`${name}: s`]: seconds, [`${name}: error`]: error, [`${name}: moved`]: moved }
}

/** A tree with values over four decades. */
function treeOf(leaves, perNode) {
  let state = leaves
  const random = () => {
    state = (state * 48_271) % 2_147_483_647
    return state / 2_147_483_647
  }
  let level = Array.from({ length: leaves }, (_, i) => ({ name: `${i}`, value: 10 ** (4 * random()) }))
  while (level.length > perNode) {
    const parents = []
    for (let i = 0; i < level.length; i += perNode)
      parents.push({ name: `${i}`, children: level.slice(i, i + perNode) })
    level = parents
  }
  return { name: 'all', children: level }
}

function measured(data, run) {
  const root = hierarchy(data).sum(({ value }) => value ?? 0)
  const seconds = secondsOf(() => run(root))
  const leaves = root.leaves()
  const errors = leaves.map((leaf) => Math.abs(areaOf(leaf.polygon) / (leaf.value / root.value) - 1))
  const changed = hierarchy(data).sum(({ value, name }) => (value ?? 0) * (name === '7' ? 1.01 : 1))
  run(changed, root)
  const mean = Math.sqrt(1 / leaves.length)
  const moves = changed.leaves().map(({ polygon, site }, i) => {
    const [after, before] = [site ?? polygon.site, leaves[i].site ?? leaves[i].polygon.site]
    return Math.hypot(after.x - before.x, after.y - before.y) / mean
  })
  return { seconds, error: rounded(Math.max(...errors)), moved: rounded(Math.max(...moves)) }
}

/** Runs d3-voronoi-treemap with random numbers that are the same each time: it has no other way to keep its sites. */
function mapped(root) {
  let state = 1
  const prng = () => {
    state = (state * 48_271) % 2_147_483_647
    return state / 2_147_483_647
  }
  voronoiTreemap().clip(SQUARE.toReversed()).prng(prng)(root)
}

function areaOf(polygon) {
  const twice = polygon.reduce((total, [x, y], k) => {
    const [u, v] = polygon[(k + 1) % polygon.length]
    return total + x * v - u * y
  }, 0)
  return Math.abs(twice) / 2
}

function rounded(value) {
  return Number(value.toPrecision(2))
}
