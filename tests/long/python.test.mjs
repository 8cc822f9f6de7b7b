// SPDX-License-Identifier: GPL-3.0-or-later
// The Python package is installed from a clone as docs/python.md says, and from a source distribution in a fresh
// environment, both without a network, and computes.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdirSync, mkdtempSync, readdirSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { test } from 'node:test'
import { ROOT } from '../../scripts/run.mjs'
import { blocksRunBy } from '../readme/blocks.mjs'

const COMPUTE = 'import circle_voronoi as cv; print(cv.compute([[0, 0, 1], [5, 0, 1]]).certified, cv.__version__)'
const VERSION = 'from importlib.metadata import version; print(True, version("circle-voronoi"))'
const PYTHON = process.env.PYTHON_PATH ?? '/usr/bin/python3'
const ENV = { ...process.env, PATH: `/usr/bin:${process.env.PATH}`, PIP_NO_INDEX: '1' }

// The requirements that pyproject.toml declares, with theirs, and Debian's packages of them.
const WHEELS = [
  'setuptools=python3-setuptools,python3-pkg-resources',
  'wheel=python3-wheel',
  'packaging=python3-packaging',
  'distro=python3-distro',
  'scikit-build=python3-skbuild',
  'pybind11=python3-pybind11',
  'numpy=python3-numpy',
]

/** A clone in a new folder, which is removed after the test. */
function clone(t) {
  const folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-python-'))
  t.after(() => rmSync(folder, { recursive: true }))
  execFileSync('git', ['clone', '--quiet', ROOT, join(folder, 'clone')])
  return join(folder, 'clone')
}

function run(python, ...args) {
  return execFileSync(python, args, { cwd: tmpdir(), encoding: 'utf8', env: ENV })
}

function assertComputes(python) {
  const printed = run(python, '-c', COMPUTE)
  assert.match(printed, /^True \d/)
  assert.equal(printed, run(python, '-c', VERSION))
}

test('pip installs the package from a clone', (t) => {
  const folder = clone(t)
  const [{ code }] = blocksRunBy('tests/long/python.test.mjs')
  execFileSync('bash', ['-euc', code], { cwd: folder, env: ENV, stdio: 'inherit' })
  assertComputes(join(folder, '.venv/bin/python'))
})

test('pip installs a source distribution in isolation, with no more than the declared requirements', (t) => {
  const folder = clone(t)
  const makeSdist = 'import setuptools.build_meta as backend; backend.build_sdist("sdist")'
  execFileSync(PYTHON, ['-c', makeSdist], { cwd: folder, env: ENV })
  const [sdist] = readdirSync(join(folder, 'sdist'))
  mkdirSync(join(folder, 'wheels'))
  run(PYTHON, join(ROOT, 'tests/long/wheelhouse.py'), join(folder, 'wheels'), ...WHEELS)
  run(PYTHON, '-m', 'venv', join(folder, 'fresh'))
  const python = join(folder, 'fresh/bin/python')
  run(python, '-m', 'pip', 'install', '--find-links', join(folder, 'wheels'), join(folder, 'sdist', sdist))
  assertComputes(python)
})
