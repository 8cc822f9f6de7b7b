// SPDX-License-Identifier: GPL-3.0-or-later
// The Python package is installed from a clone as docs/python.md says, without a network, and computes.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { test } from 'node:test'
import { ROOT } from '../../scripts/run.mjs'
import { blocksRunBy } from '../readme/blocks.mjs'

const COMPUTE = 'import circle_voronoi as cv; print(cv.compute([[0, 0, 1], [5, 0, 1]]).certified)'

test('pip installs the package from a clone', (t) => {
  const clone = join(mkdtempSync(join(tmpdir(), 'circle-voronoi-python-')), 'clone')
  t.after(() => rmSync(join(clone, '..'), { recursive: true }))
  execFileSync('git', ['clone', '--quiet', ROOT, clone])
  const [{ code }] = blocksRunBy('tests/long/python.test.mjs')
  const env = { ...process.env, PATH: `/usr/bin:${process.env.PATH}`, PIP_NO_INDEX: '1' }
  execFileSync('bash', ['-euc', code], { cwd: clone, env, stdio: 'inherit' })
  const printed = execFileSync(join(clone, '.venv/bin/python'), ['-c', COMPUTE], { cwd: tmpdir(), encoding: 'utf8' })
  assert.equal(printed, 'True\n')
})
