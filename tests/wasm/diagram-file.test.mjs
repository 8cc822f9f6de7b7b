// SPDX-License-Identifier: GPL-3.0-or-later
// Diagrams as JSON between JavaScript and the native program, both ways.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { readdirSync } from 'node:fs'
import { it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { fromJSON, loadCircleVoronoi } from '../../dist/lib/index.js'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const run = (args, input) => execFileSync(`${ROOT}build/native/circle-voronoi`, args, { input, encoding: 'utf8' })

const library = await loadCircleVoronoi()

for (const fixture of readdirSync(`${ROOT}tests/fixtures`).filter((name) => name.endsWith('.csv'))) {
  it(`${fixture} there and back`, () => {
    const written = run(['compute', `${ROOT}tests/fixtures/${fixture}`])
    const diagram = fromJSON(written)
    assert.equal(library.certify(diagram).certified, true)
    const text = JSON.stringify(diagram)
    const { hidden, vertices, edges } = diagram
    assert.equal(
      run(['certify', '-'], text),
      `certified: ${diagram.circles.length / 3} circles, ${hidden.length / 2} of them hidden; ${vertices.length / 3} vertices, ${edges.length / 4} edges\n`,
    )
    // The program judges the diagram, because it trusts no input.
    const { certificate, ...stats } = JSON.parse(run(['convert', '-', '--format', 'stats'], text))
    assert.equal(certificate.certified, true)
    assert.deepEqual(stats, diagram.stats)
    const withoutSigns = (json) => json.replaceAll(/-0(?=[,}\]])/g, '0')
    const circlesOf = (json) => run(['convert', '-', '--circles', '--format', 'csv'], json)
    assert.equal(circlesOf(text), circlesOf(withoutSigns(written)))
  })
}
