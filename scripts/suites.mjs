// SPDX-License-Identifier: GPL-3.0-or-later
// The test suites: quick tests for `npm test`, long ones for `npm run test:long`.
import { readdirSync } from 'node:fs'
import { availableParallelism } from 'node:os'
import { ROOT } from './run.mjs'
import { chromiumPath, chromiumShellPath } from './setup.mjs'

const BIN = `${ROOT}node_modules/.bin`
// Disables colors, progress bars and questions of tools.
export const ENV = {
  CI: 'true',
  NO_COLOR: '1',
  CHROMIUM_PATH: chromiumPath(),
  CHROMIUM_SHELL_PATH: chromiumShellPath(),
}

/**
 * @typedef {object} Suite
 * @property {string} name
 * @property {string} [script]
 * @property {string} program
 * @property {(report: string, isLong?: boolean) => string[]} args
 * @property {(report: string) => Record<string, string | undefined>} [env]
 * @property {('quick' | 'long')[]} [lengths]
 * @property {boolean} [hasPages]
 */

/**
 * The suites in their order: the program, its arguments and its environment, so that it writes a JUnit report to a path
 * and runs quick tests, or with `isLong` the others. `lengths` defaults to quick tests only. `hasPages` marks suites
 * that open pages in a browser. `script` names a script of package.json with the suite's inputs. The script skips the suite if
 * it passed with the same inputs before.
 *
 * @type {Suite[]}
 */
export const SUITES = [
  {
    name: 'CTest',
    script: 'native',
    program: 'ctest',
    args: (report, isLong) => [
      ...['--preset', 'native', '--output-junit', report, '-j', String(availableParallelism())],
      ...[isLong ? '-L' : '-LE', '^long$'],
    ],
    lengths: ['quick', 'long'],
  },
  {
    name: 'Vitest',
    program: `${BIN}/vitest`,
    args: (report) => ['run', '--reporter=default', '--reporter=junit', `--outputFile.junit=${report}`],
  },
  {
    name: 'WebAssembly in Node',
    program: process.execPath,
    // Node then forbids `eval`, as the Content-Security-Policy of a page does.
    args: (report) => ['--disallow-code-generation-from-strings', ...nodeTests(report, 'tests/wasm')],
  },
  {
    name: 'Files, tiles, package and README in Node',
    program: process.execPath,
    args: (report) => nodeTests(report, 'tests/files', 'tests/tiles', 'tests/pack', 'tests/readme'),
  },
  {
    name: 'Python',
    script: 'python',
    // Debian's interpreter has the packages; another python3 may come first on the path.
    program: process.env.PYTHON_PATH ?? '/usr/bin/python3',
    args: (report) => ['-m', 'pytest', 'cpp/python/tests', '-q', '-p', 'no:cacheprovider', `--junitxml=${report}`],
    env: () => ({ PYTHONPATH: `${ROOT}build/native/cpp/python`, PYTHONDONTWRITEBYTECODE: '1' }),
  },
  {
    name: "The paper's results and the program in Node",
    program: process.execPath,
    args: (report) => nodeTests(report, 'tests/long'),
    lengths: ['long'],
  },
  {
    name: 'Playwright',
    program: `${BIN}/playwright`,
    args: (_, isLong) => ['test', '--reporter=list,junit', isLong ? '--grep' : '--grep-invert', '@long'],
    // Playwright has its own setting for colors, and Node warns when both are set.
    env: (report) => ({ NO_COLOR: undefined, PLAYWRIGHT_JUNIT_OUTPUT_FILE: report }),
    lengths: ['quick', 'long'],
    hasPages: true,
  },
]

/** The options of Node's test runner for all tests of some folders. */
function nodeTests(report, ...folders) {
  const files = folders.flatMap((folder) => readdirSync(ROOT + folder).map((name) => `${folder}/${name}`))
  return [
    ...['--test', `--test-concurrency=${availableParallelism()}`],
    ...['--test-reporter=spec', '--test-reporter-destination=stdout'],
    ...['--test-reporter=junit', `--test-reporter-destination=${report}`],
    ...files.filter((name) => name.endsWith('.test.mjs')),
  ]
}
