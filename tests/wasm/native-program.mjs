// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program in WebAssembly next to the native one, and the native program's tests.
import assert from 'node:assert/strict'
import { execFile, execFileSync, spawn } from 'node:child_process'
import { availableParallelism } from 'node:os'
import { text } from 'node:stream/consumers'
import { describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'

export const ROOT = fileURLToPath(new URL('../..', import.meta.url))
export const NATIVE = `${ROOT}build/native/circle-voronoi`
const WASM = `${ROOT}dist/cli/circle-voronoi.js`
const NATIVE_TESTS = `${ROOT}build/native/tests/cpp/circle_voronoi_tests`
export const AT_ONCE = { concurrency: availableParallelism() }

/** The output of a program, without the measured times. */
async function outcomeOf(program, args, input) {
  const child = spawn(program, args)
  child.stdin.on('error', () => {}).end(input)
  const ended = new Promise((resolve) => child.once('close', resolve))
  const [stdout, stderr] = await Promise.all([text(child.stdout), text(child.stderr)])
  return { status: await ended, stdout: stdout.replace(/"seconds": \{[^}]*\}/g, ''), stderr }
}

/**
 * Expects the same output of both programs, and returns it.
 *
 * @param {string[]} args
 * @param {string | Uint8Array} input
 */
export async function both(args, input = '') {
  const [native, wasm] = await Promise.all([NATIVE, WASM].map((program) => outcomeOf(program, args, input)))
  assert.deepEqual(wasm, native, args.join(' '))
  return native
}

/** Runs tests of the native program, selected by a GoogleTest filter, with the program in WebAssembly. */
export function passesNativeTests(filter) {
  const list = execFileSync(NATIVE_TESTS, ['--gtest_list_tests', `--gtest_filter=${filter}`], { encoding: 'utf8' })
  const names = [...list.matchAll(/^(\w+\.)\n((?: {2}.*\n)+)/gm)].flatMap(([, suite, tests]) =>
    tests
      .trim()
      .split(/\n\s*/)
      .map((test) => suite + test),
  )
  if (names.length === 0) throw new Error(`No native test has a name like ${filter}.`)
  describe('passes the tests of the native program', AT_ONCE, () => {
    for (const name of names) {
      it(name, (_, done) => {
        const env = { ...process.env, CIRCLE_VORONOI_PROGRAM: WASM }
        execFile(NATIVE_TESTS, [`--gtest_filter=${name}`], { env }, (error, stdout) => {
          done(error === null && stdout.includes('[  PASSED  ] 1 test.') ? undefined : new Error(stdout))
        })
      })
    }
  })
}

/** Expects that both programs write the same circles of a family. */
export function generatesTheSame(family) {
  it(`circles of the family ${family}`, async () => {
    assert.equal((await both(['generate', family, '60', '--seed', '5'])).status, 0)
  })
}
