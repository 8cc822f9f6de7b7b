// SPDX-License-Identifier: GPL-3.0-or-later
// Which changes `npm run mutate` makes to web/lib and to what of the page needs no browser, one at a time, and how the tests of tests/web are run on each.
// @ts-check
import { fileURLToPath } from 'node:url'

/** Whether only a sample of them is made (`npm run mutate -- --share`). */
const isSample = process.env.CIRCLE_VORONOI_MUTANTS !== undefined

/** @type {import('@stryker-mutator/api/core').PartialStrykerOptions} */
export default {
  mutate: [
    'web/lib/**/*.ts',
    '!web/lib/**/*.d.ts',
    // What only runs as a file of its own, in a thread or a bundle: tests/pack has the package as installed.
    '!web/lib/{bundle,worker-thread,wasm/default-wasm,threads/thread-file}.ts',
    '!web/lib/bundled/**',
    'web/editing/{arranging,editing,history,scene-link,store}.ts',
    'web/app/scene-storage.ts',
    'web/view/{camera,circle-table,gestures,pointer}.ts',
  ],
  testRunner: 'vitest',
  plugins: ['@stryker-mutator/vitest-runner', fileURLToPath(new URL('sample.mjs', import.meta.url))],
  vitest: { configFile: 'tests/mutants/vitest.config.ts' },
  coverageAnalysis: 'perTest',
  // What runs while modules are loaded, and in no test, is constants: each would need all tests, in a new thread.
  ignoreStatic: true,
  concurrency: 2,
  dryRunTimeoutMinutes: 60,
  // Of what tests take without a change. A machine that others use as well must not look like a test that hangs.
  timeoutFactor: 4,
  ignorePatterns: [
    '/*',
    '!/web',
    '!/tests',
    '!/public',
    '!/docs',
    '!/scripts',
    '!/*.json',
    '!/*.ts',
    '/tests/{cpp,files,fuzz,soak}',
  ],
  tempDirName: 'build/mutants/web',
  // What did not change since the last run is not run again.
  incremental: !isSample,
  incrementalFile: 'build/mutants/web.json',
  reporters: ['clear-text', 'html', 'json', 'progress-append-only'],
  htmlReporter: { fileName: 'build/mutants/web.html' },
  jsonReporter: { fileName: 'build/mutants/web-report.json' },
  clearTextReporter: { allowColor: false, logTests: false },
  thresholds: { high: 90, low: 85, break: 85 },
  checkers: isSample ? ['sample'] : [],
  allowConsoleColors: false,
}
