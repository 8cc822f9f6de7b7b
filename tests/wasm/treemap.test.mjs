// SPDX-License-Identifier: GPL-3.0-or-later
// Treemaps of the built package, of trees as d3-hierarchy and plain programs have them.
import assert from 'node:assert/strict'
import { describe, it } from 'node:test'
import { hierarchy } from 'd3-hierarchy'
import { loadRegions } from '../../dist/lib/regions.js'
import { createWorker } from '../../dist/lib/worker.js'

const { region, treemap } = await loadRegions()
const square = region([
  [
    [0, 0],
    [9, 0],
    [9, 9],
    [0, 9],
  ],
])

function randomFrom(seed) {
  let state = seed
  return () => {
    state = (state * 48_271) % 2_147_483_647
    return state / 2_147_483_647
  }
}

/** A tree with values over decades, some of them zero. */
function randomTree(seed, decades = 3) {
  const random = randomFrom(seed)
  const below = (depth, name) =>
    depth === 0
      ? { name, value: random() < 0.1 ? 0 : 10 ** (decades * random()) }
      : {
          name,
          children: Array.from({ length: 2 + Math.floor(7 * random()) }, (_, k) => below(depth - 1, `${name}.${k}`)),
        }
  return below(3, 'r')
}

function* nodesOf(node) {
  yield node
  for (const child of node.children ?? []) yield* nodesOf(child)
}

function areaOf(ring) {
  return ring.reduce((sum, [x, y], k) => {
    const [u, v] = ring[(k + 1) % ring.length]
    return sum + (x * v - u * y) / 2
  }, 0)
}

function expectCells(root, sumOf) {
  for (const node of nodesOf(root)) {
    const target = (81 * sumOf(node)) / sumOf(root)
    assert.ok(Math.abs(node.area - target) <= 1e-9 * target)
    assert.ok(Math.abs(areaOf(node.polygon) - target) <= 1e-9 * target + 1e-12)
    assert.equal(node.site === undefined, target === 0)
    for (const child of node.children ?? []) {
      for (const [x, y] of child.polygon) {
        const sides = node.polygon.map(([a, b], k) => {
          const [c, d] = node.polygon[(k + 1) % node.polygon.length]
          return ((c - a) * (y - b) - (d - b) * (x - a)) / Math.hypot(c - a, d - b)
        })
        assert.ok(Math.min(...sides) > -1e-12)
      }
    }
  }
}

const sumOf = ({ children, value }) => children?.reduce((sum, child) => sum + sumOf(child), 0) ?? value

describe('treemap', () => {
  it('gives each node of a plain tree its area inside its parent', () => {
    const tree = randomTree(5)
    assert.equal(treemap(tree, { region: square }), tree)
    expectCells(tree, sumOf)
  })

  it('takes what d3.hierarchy returns', () => {
    const root = treemap(
      hierarchy(randomTree(6)).sum(({ value }) => value ?? 0),
      { region: square },
    )
    expectCells(root, ({ value }) => value)
  })

  it('gives the same in a worker, to the bit, with its progress, and cancels there', async () => {
    const worker = createWorker()
    try {
      /** @type {number[][][]} */
      const [here, there] = [[], []]
      const first = treemap(randomTree(7), { region: square, progress: (...told) => here.push(told) })
      const tree = randomTree(7)
      const second = await worker.treemap(tree, { region: square, progress: (...told) => there.push(told) })
      assert.equal(second, tree)
      assert.deepEqual(second, first)
      assert.deepEqual(there, here)
      const controller = new AbortController()
      const later = worker.treemap(randomTree(7), {
        region: square,
        signal: controller.signal,
        progress: () => controller.abort(),
      })
      await assert.rejects(later, { name: 'AbortError' })
      const wrong = {
        children: [
          { name: 'a', value: 1 },
          { name: 'b', value: -1 },
        ],
      }
      await assert.rejects(worker.treemap(wrong, { region: square }), { code: 'badInput', message: /node b/ })
    } finally {
      worker.dispose()
    }
  })

  it('keeps the sites of an earlier treemap, wherever a node is in its list', () => {
    const before = treemap(randomTree(8), { region: square })
    const after = randomTree(8)
    for (const node of nodesOf(after)) {
      if (node.value > 0) node.value *= 1.001
      node.children?.reverse()
    }
    treemap(after, { region: square, previous: before })
    const sites = new Map([...nodesOf(before)].map(({ name, site }) => [name, site]))
    const known = [...nodesOf(after)].filter(({ site }) => site !== undefined)
    const still = known.filter(({ name, site }) => site.x === sites.get(name).x && site.y === sites.get(name).y)
    assert.ok(still.length > 0.8 * known.length)
    expectCells(after, sumOf)
  })

  it('names the node in errors', () => {
    /** @type {{ name: string, value: any }} */
    const japan = { name: 'Japan', value: -1 }
    const tree = { children: [{ name: 'Asia', children: [japan] }] }
    assert.throws(() => treemap(tree, { region: square }), /Asia, Japan.*-1/)
    japan.value = 'many'
    assert.throws(() => treemap(tree, { region: square }), { code: 'badInput', message: /Asia, Japan.*many/ })
    assert.throws(() => treemap({ children: [{ value: 0 }] }, { region: square }), { code: 'badInput' })
    const twice = { name: 'twice', value: 1 }
    assert.throws(() => treemap({ children: [twice, twice] }, { region: square }), { code: 'badInput' })
  })

  it('tells its progress, and stops where the listener throws or the signal is aborted', () => {
    const told = []
    treemap(randomTree(9), { region: square, progress: (...all) => told.push(all) })
    assert.deepEqual(told[0][0], 0)
    assert.deepEqual(told.at(-1)[0], told.at(-1)[1])
    const enough = new Error('enough')
    const stop = () => {
      throw enough
    }
    assert.throws(() => treemap(randomTree(9), { region: square, progress: stop }), enough)
    const controller = new AbortController()
    const { signal } = controller
    const abort = () => controller.abort(enough)
    assert.throws(() => treemap(randomTree(9), { region: square, signal, progress: abort }), enough)
  })
})
