// SPDX-License-Identifier: GPL-3.0-or-later
// `npm test`: installs what is missing, builds everything, runs every check and test, and counts the tests.
// The last line is `N passed, M failed`; the exit status is 0 only if something ran and nothing failed.
import { mkdirSync, rmSync } from 'node:fs'
import { availableParallelism } from 'node:os'
import { buildCli, buildElement, buildLib, buildNative, buildSite, buildWasm } from './build.mjs'
import { countTests, NO_TESTS, summary } from './count-tests.mjs'
import { ROOT, run, statusOf } from './run.mjs'
import { chromiumPath, setup } from './setup.mjs'

const BIN = `${ROOT}node_modules/.bin`
const RESULTS = `${ROOT}build/test-results`
// Colours and progress bars are for people, and so are the questions that some tools ask.
const ENV = { CI: 'true', NO_COLOR: '1', CHROMIUM_PATH: chromiumPath() }

/** The options of Node's test runner that writes a report. */
function testing(report) {
  const each = ['--test', `--test-concurrency=${availableParallelism()}`]
  const reporters = ['--test-reporter=spec', '--test-reporter-destination=stdout', '--test-reporter=junit']
  return [...each, ...reporters, `--test-reporter-destination=${report}`]
}

/** In this order; each of them writes a JUnit report. */
const SUITES = [
  {
    name: 'CTest',
    report: `${RESULTS}/ctest.xml`,
    program: 'ctest',
    args: ['--test-dir', 'build/native', '--output-on-failure', '--output-junit', `${RESULTS}/ctest.xml`, '-j', '2'],
  },
  {
    name: 'Vitest',
    report: `${RESULTS}/vitest.xml`,
    program: `${BIN}/vitest`,
    args: ['run', '--reporter=default', '--reporter=junit', `--outputFile.junit=${RESULTS}/vitest.xml`],
  },
  {
    name: 'WebAssembly in Node',
    report: `${RESULTS}/node.xml`,
    program: process.execPath,
    // As strict as a page whose Content-Security-Policy forbids `eval`.
    args: [
      '--disallow-code-generation-from-strings',
      ...testing(`${RESULTS}/node.xml`),
      'tests/wasm/native.test.mjs',
      'tests/wasm/equal-radii.test.mjs',
      'tests/wasm/worker.test.mjs',
      'tests/wasm/editor.test.mjs',
      'tests/wasm/geometry.test.mjs',
      'tests/wasm/examples.test.mjs',
      'tests/wasm/final-cells.test.mjs',
      'tests/wasm/diagram-file.test.mjs',
      'tests/wasm/files.test.mjs',
      'tests/wasm/program.test.mjs',
    ],
  },
  {
    name: 'Files, tiles and README in Node',
    report: `${RESULTS}/files.xml`,
    program: process.execPath,
    args: [
      ...testing(`${RESULTS}/files.xml`),
      'tests/files/geojson.test.mjs',
      'tests/tiles/tiles.test.mjs',
      'tests/readme/native.test.mjs',
    ],
  },
  {
    name: "The paper's results in Node",
    report: `${RESULTS}/results.xml`,
    program: process.execPath,
    args: [...testing(`${RESULTS}/results.xml`), 'tests/results/reproduce.test.mjs'],
  },
  {
    name: 'Playwright',
    report: `${RESULTS}/playwright.xml`,
    program: `${BIN}/playwright`,
    args: ['test', '--reporter=list,junit'],
    // Playwright colours its own way, and Node warns when both are set.
    env: { NO_COLOR: undefined, PLAYWRIGHT_JUNIT_OUTPUT_FILE: `${RESULTS}/playwright.xml` },
  },
]

const results = []
try {
  await setup('tests')
  await buildWasm('package')
  await buildNative()
  await buildLib()
  await buildElement()
  await buildCli()
  await buildSite()
  await run('npm', ['run', '--silent', 'check'], ENV)

  rmSync(RESULTS, { recursive: true, force: true })
  mkdirSync(RESULTS, { recursive: true })
  for (const { name, report, program, args, env } of SUITES) {
    console.log(`\n── ${name}`)
    const start = performance.now()
    const status = await statusOf(program, args, { ...ENV, ...env })
    const counts = countTests(report)
    console.log(`── ${name}: ${Math.round((performance.now() - start) / 1000)} s`)
    // A suite that fails without a failed test, or runs none, counts as one failure.
    const isSilentFailure = counts.failed === 0 && (status !== 0 || counts.passed === 0)
    results.push({ name, ...counts, failed: isSilentFailure ? 1 : counts.failed })
  }
} catch (error) {
  console.error(`\n${error.message}`)
  results.push({ ...NO_TESTS, name: 'Set-up, build and checks', failed: 1 })
}

console.log('')
for (const { name, ...counts } of results) console.log(`${name}: ${summary(counts)}`)
const total = results.reduce(
  (sum, { passed, failed, skipped }) => ({
    passed: sum.passed + passed,
    failed: sum.failed + failed,
    skipped: sum.skipped + skipped,
  }),
  NO_TESTS,
)
console.log(summary(total))
process.exitCode = total.failed > 0 || total.passed === 0 ? 1 : 0
