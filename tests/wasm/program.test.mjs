// SPDX-License-Identifier: GPL-3.0-or-later
// The program in WebAssembly: it passes the tests of the native program, and prints the same bytes.
import assert from 'node:assert/strict'
import { execFile, execFileSync, spawn } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { availableParallelism } from 'node:os'
import { text } from 'node:stream/consumers'
import { describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const NATIVE = `${ROOT}build/native/circle-voronoi`
const WASM = `${ROOT}dist/cli/circle-voronoi.js`
const NATIVE_TESTS = `${ROOT}build/native/tests/cpp/circle_voronoi_tests`
const FORMATS = ['csv', 'svg', 'geojson', 'geojsonl', 'wkt', 'obj', 'json', 'stats']
const AT_ONCE = { concurrency: availableParallelism() }

/** What a program prints, but for the times that it took. */
async function outcomeOf(program, args, input) {
  const child = spawn(program, args)
  child.stdin.on('error', () => {}).end(input)
  const ended = new Promise((resolve) => child.once('close', resolve))
  const [stdout, stderr] = await Promise.all([text(child.stdout), text(child.stderr)])
  return { status: await ended, stdout: stdout.replace(/"seconds": \{[^}]*\}/g, ''), stderr }
}

/** What both print, which is the same. */
async function both(args, input = '') {
  const [native, wasm] = await Promise.all([NATIVE, WASM].map((program) => outcomeOf(program, args, input)))
  assert.deepEqual(wasm, native, args.join(' '))
  return native
}

/**
 * The tests of the program by their full names; those of its documents ask nothing of it but what --help prints, and what
 * only reads the command line, or converts, is the same code (`what is wrong` and `what is converted` below show it).
 */
function namesOfTests() {
  const without = [
    'CliDocumentation.*',
    'CliConvert.*',
    'Cli.AnOptionThatIsNotUsedIsAnError',
    'Cli.BadUsage',
    '*.Refuses*',
  ]
  const list = execFileSync(NATIVE_TESTS, ['--gtest_list_tests', `--gtest_filter=Cli*-${without.join(':')}`], {
    encoding: 'utf8',
  })
  return [...list.matchAll(/^(\w+\.)\n((?: {2}.*\n)+)/gm)].flatMap(([, suite, tests]) =>
    tests
      .trim()
      .split(/\n\s*/)
      .map((test) => suite + test),
  )
}

describe('passes the tests of the native program', AT_ONCE, () => {
  for (const name of namesOfTests()) {
    it(name, (_, done) => {
      const env = { ...process.env, CIRCLE_VORONOI_PROGRAM: WASM }
      execFile(NATIVE_TESTS, [`--gtest_filter=${name}`], { env }, (error, stdout) => {
        done(error === null && stdout.includes('[  PASSED  ] 1 test.') ? undefined : new Error(stdout))
      })
    })
  }
})

describe('prints the same as the native program', AT_ONCE, () => {
  for (const family of execFileSync(NATIVE, ['generate', '--list'], { encoding: 'utf8' }).trim().split('\n')) {
    const [name] = family.split(' ')
    it(`circles of the family ${name}`, async () => {
      assert.equal((await both(['generate', name, '60', '--seed', '5'])).status, 0)
    })
  }

  for (const family of ['log-uniform', 'chaos']) {
    const circles = execFileSync(NATIVE, ['generate', family, '200', '--seed', '3'])
    for (const format of FORMATS) {
      it(`${family} circles as ${format}`, async () => {
        assert.equal((await both(['compute', '-', '--format', format], circles)).status, 0)
      })
    }
  }

  it('what is cut at a box and drawn as closely as it is told', async () => {
    const options = ['--bounds=-3,1e-3,7.25,1e1', '--tolerance', '3e-7', '--max-distance', '0.75']
    const circles = readFileSync(`${ROOT}tests/fixtures/waka.csv`)
    for (const format of ['svg', 'geojson', 'wkt'])
      await both(['compute', '-', '--format', format, ...options], circles)
  })

  it('what is converted', async () => {
    const diagram = execFileSync(NATIVE, ['compute', `${ROOT}tests/fixtures/waka.csv`])
    for (const format of FORMATS.filter((name) => name !== 'stats'))
      assert.equal((await both(['convert', '-', '--format', format], diagram)).status, 0)
    await both(['convert', '-', '--format', 'csv'], diagram.subarray(0, 5000))
  })

  for (const command of ['compute', 'convert', 'generate', 'tile', 'certify']) {
    it(`the help of ${command}`, async () => assert.equal((await both([command, '--help'])).status, 0))
  }

  it('what is wrong', async () => {
    await both(['certify', `${ROOT}tests/fixtures`])
    await both(['compute', `${ROOT}none`])
    await both(['compute', '-', '--tolerance', 'nan'], '0,0,1\n')
    await both(['compute', '-', '--format', 'csv', '--bounds=0,0,1,1', '--weights=no'], '0,0,1\n')
    await both(['compute', '-', '--samples', '-1'], '0,0,1\n')
    await both(['paint'])
    await both(['tile', '-', '--size', '1', '--halo', '0', '-o', 'none'], '0,0,1\n')
  })
})
