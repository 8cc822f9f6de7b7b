// SPDX-License-Identifier: GPL-3.0-or-later
// The library without extensions of the compiler passes the tests of its proofs, and the program prints the same bits as
// the usual one.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { before, describe, it } from 'node:test'
import { ROOT } from '../../scripts/run.mjs'

const SEED = process.env.CIRCLE_VORONOI_SEED ?? '1'
const FOLDERS = [`${ROOT}build/native`, `${ROOT}build/portable`]
const run = (program, args, input) =>
  execFileSync(program, args, { cwd: ROOT, input, encoding: 'utf8', maxBuffer: 2 ** 30 })

before(() => {
  run('cmake', ['--preset', 'portable'])
  run('cmake', ['--build', '--preset', 'portable'])
})

it('passes the tests of proofs', () => {
  assert.match(run(`${FOLDERS[1]}/tests/cpp/circle_voronoi_proof_tests`, []), /\[ {2}PASSED {2}\]/)
})

describe(`computes the same, with the seed ${SEED}`, () => {
  /** Expects the same output of both programs, but for the measured times. */
  const computesTheSame = (circles, ...options) => {
    const [usual, portable] = FOLDERS.map((folder) =>
      run(`${folder}/circle-voronoi`, ['compute', '-', ...options], circles).replace(/"seconds": \{[^}]*\}/g, ''),
    )
    assert.ok(usual.length > 100)
    assert.equal(portable, usual)
  }

  const native = `${FOLDERS[0]}/circle-voronoi`
  for (const line of run(native, ['generate', '--list']).trim().split('\n')) {
    const [family] = line.split(' ')
    it(family, () => computesTheSame(run(native, ['generate', family, '300', '--seed', SEED])))
  }

  for (const family of ['uniform', 'hexagonal']) {
    it(`${family}, repeated with periods`, () => {
      const circles = run(native, ['generate', family, '300', '--seed', SEED])
      computesTheSame(circles, '--lattice', '3,0,1,7')
    })
  }
})
