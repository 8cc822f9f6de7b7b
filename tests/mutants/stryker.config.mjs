// SPDX-License-Identifier: GPL-3.0-or-later
// The changes that `npm run mutate` makes, one at a time, to web/lib and to the parts of the page that need no browser,
// and the way in which the tests of tests/web run on each.
import { fileURLToPath } from 'node:url'

/** Whether only a sample is made (`npm run mutate -- --share`). */
const isSample = process.env.CIRCLE_VORONOI_MUTANTS !== undefined

/** @type {import('@stryker-mutator/api/core').PartialStrykerOptions} */
export default {
  mutate: [
    'web/lib/**/*.ts',
    '!web/lib/**/*.d.ts',
    // Files that run only in a thread or a bundle. tests/pack covers them with the installed package.
    '!web/lib/{bundle,worker-thread,wasm/default-wasm,threads/thread-file}.ts',
    '!web/lib/bundled/**',
    'web/editing/{arranging,domain-change,editing,history,pointer,scene-link,state}.ts',
    'web/editing/gestures/*.ts',
    'web/app/scene-storage.ts',
    'web/view/{camera,circle-table,store}.ts',
  ],
  // Tests do not hold wording in place.
  mutator: { excludedMutations: ['StringLiteral'] },
  testRunner: 'vitest',
  plugins: ['@stryker-mutator/vitest-runner', fileURLToPath(new URL('sample.mjs', import.meta.url))],
  vitest: { configFile: 'tests/mutants/vitest.config.ts' },
  coverageAnalysis: 'perTest',
  // Changes of code that runs only while modules are loaded, which are constants, would need all tests in a new thread.
  ignoreStatic: true,
  concurrency: 2,
  dryRunTimeoutMinutes: 60,
  // Multiple of the tests' usual time. A busy machine must not look like a test that hangs.
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
  // Unchanged code is not run again.
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
