// SPDX-License-Identifier: GPL-3.0-or-later
// examples/packing, on the built package.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { loadCircleVoronoi } from '../../dist/lib/index.js'
import { pack } from '../../examples/packing/packing.js'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))

it('packs discs of two sizes that do not overlap', async () => {
  let state = 4
  const random = () => {
    state = (state * 1664525 + 1013904223) % 2 ** 32
    return state / 2 ** 32
  }
  const periodic = pack(await loadCircleVoronoi(), { a: [2, 0], b: [0.5, 1] }, 30, 1.4, random)
  const { gaps, areas, packingFractions } = periodic.contacts()
  const sum = (values) => values.reduce((total, value) => total + value, 0)
  assert.equal(periodic.circleCount, 30)
  assert.ok(Math.min(...gaps) > -1e-12)
  assert.ok(Math.abs(sum(areas) / 2 - 1) < 1e-12)
  // A square lattice of equal discs has 0.785.
  assert.ok(sum(areas.map((area, i) => area * packingFractions[i])) / 2 > 0.78)
})

it('draws cells, discs and contacts', () => {
  const folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-'))
  try {
    const file = join(folder, 'packing.svg')
    const said = execFileSync(process.execPath, [join(ROOT, 'examples/packing/write-svg.mjs'), file], {
      encoding: 'utf8',
    })
    assert.match(said, /^60 discs cover 8\d\.\d % of the box\.\nEach touches [34]\.\d others on average\.\n$/)
    // The picture of the documentation is this one.
    assert.equal(readFileSync(file, 'utf8'), readFileSync(join(ROOT, 'docs/examples/packing.svg'), 'utf8'))
  } finally {
    rmSync(folder, { recursive: true })
  }
})
