// SPDX-License-Identifier: GPL-3.0-or-later
// Fits in a periodic box in WebAssembly against the native program: each weight and each circle to the last bit.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { it } from 'node:test'
import { loadRegions } from '../../dist/lib/regions.js'
import { NATIVE } from './native-program.mjs'

const { fitAreas } = await loadRegions()

for (const [count, lattice, metric] of /** @type {const} */ ([
  [3, [4, 0, 1, 3], 'circles'],
  [60, [4, 0, 1, 3], 'circles'],
  [40, [30, 1, 29, 2], 'circles'],
  [60, [4, 0, 1, 3], 'power'],
])) {
  it(`fitted: ${count} areas in the box ${lattice}, ${metric}`, () => {
    let state = Number(count)
    const random = () => {
      state = (state * 48_271) % 2_147_483_647
      return state / 2_147_483_647
    }
    const [ax, ay, bx, by] = lattice
    const sites = Array.from({ length: count }, () => {
      const [u, v] = [random(), random()]
      return [u * ax + v * bx, u * ay + v * by]
    })
    const shares = sites.map(() => 1 + 9 * random())
    const rows = sites.map(([x, y], i) => `${x},${y},${shares[i]}\n`)
    const options = [
      '--areas',
      'share',
      '--shares',
      '--lattice',
      lattice.join(),
      '--format',
      'json',
      '--metric',
      metric,
    ]
    const text = execFileSync(NATIVE, ['fit', '-', ...options], {
      input: `x,y,share\n${rows.join('')}`,
      encoding: 'utf8',
    })
    const native = JSON.parse(text).circles.flatMap(({ x, y, r }) => [x, y, r])
    const { periodic } = fitAreas(sites, shares, { lattice: { a: [ax, ay], b: [bx, by] }, shares: true, metric })
    assert.equal(periodic.diagram.metric, metric)
    assert.deepEqual([...periodic.diagram.circles], native)
  })
}
