// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run reproduce -- --quick` gives the paper's Table 1 exactly, and the known outcome of each claim.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { readdirSync, readFileSync } from 'node:fs'
import { before, test } from 'node:test'
import { claimsOf, TABLE_1 } from '../../scripts/results/claims.mjs'
import { ROOT } from '../../scripts/run.mjs'

const FOLDER = `${ROOT}build/results`
let run
let data

before(() => {
  run = spawnSync(process.execPath, [`${ROOT}scripts/reproduce.mjs`, '--quick'], {
    encoding: 'utf8',
    maxBuffer: 2 ** 26,
  })
  assert.ok(run.status !== null, String(run.error))
  data = JSON.parse(readFileSync(`${FOLDER}/data.json`, 'utf8'))
})

test('the command succeeds', () => {
  assert.equal(run.status, 0, `${run.stdout}\n${run.stderr}`)
})

test('Table 1 is exactly that of the paper', () => {
  const rows = data.table1.map(({ n, onLargest, fewestOnOthers, mostOnOthers, average }) => ({
    n,
    onLargest,
    onOthers: [fewestOnOthers, mostOnOthers],
    average: average.toFixed(3),
  }))
  assert.deepEqual(rows, [
    { n: 49, onLargest: 192, onOthers: [9, 9], average: '12.735' },
    { n: 199, onLargest: 792, onOthers: [9, 9], average: '12.935' },
  ])
  assert.equal(TABLE_1.length, rows.length)
})

test('every claim of the paper comes out as it is known to', () => {
  const claims = Object.entries(claimsOf(data))
  assert.ok(claims.length > 15)
  for (const [name, { outcome, expected, measured, why }] of claims) {
    assert.equal(outcome, expected, `${name}: ${measured}`)
    assert.ok(outcome === 'yes' || why.length > 0, `${name} says why it does not hold`)
    assert.doesNotMatch(measured, /NaN|undefined|Infinity/)
  }
})

test('no right diagram is refused and no wrong one accepted, and auto is never wrong', () => {
  for (const { family, misjudged, wrong } of data.correctness) {
    assert.equal(misjudged, '', family)
    assert.equal(wrong.auto, 0, family)
  }
})

test('the page shows every picture there is, in light and in dark', () => {
  const page = readFileSync(`${FOLDER}/results.md`, 'utf8')
  assert.doesNotMatch(page, /NaN|undefined|Infinity/)
  const shown = [...page.matchAll(/<img src="results\/([\w-]+\.svg)"/g)].map(([, name]) => name)
  assert.deepEqual([...new Set(shown)].sort(), readdirSync(`${FOLDER}/results`).sort())
  for (const name of shown) {
    const svg = readFileSync(`${FOLDER}/results/${name}`, 'utf8')
    assert.match(svg, /prefers-color-scheme: dark/, name)
    assert.doesNotMatch(svg, /NaN|undefined|Infinity/, name)
    assert.ok((svg.match(/<(path|circle)\b/g) ?? []).length > 2, `${name} has something in it`)
  }
})
