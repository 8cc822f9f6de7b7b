// SPDX-License-Identifier: GPL-3.0-or-later
// `npm test`: installs missing dependencies, builds everything, runs every check and each quick test, and counts the tests.
// `npm run test:long`: the long tests. The last line is `N passed, M failed`; the exit status is 0 only if something ran and
// nothing failed.
import { mkdirSync, rmSync } from 'node:fs'
import { countTests, NO_TESTS, summary } from './count-tests.mjs'
import { build, ROOT, run, statusOf, WIREIT } from './run.mjs'
import { ENV, SUITES } from './suites.mjs'

const RESULTS = `${ROOT}build/test-results`
const length = process.argv.includes('--long') ? 'long' : 'quick'

const results = []
try {
  await timed('Set-up and builds', () => build('build:tests'))
  if (length === 'quick') await timed('Checks', () => run('npm', ['run', '--silent', 'check'], ENV))

  rmSync(RESULTS, { recursive: true, force: true })
  mkdirSync(RESULTS, { recursive: true })
  for (const { name, script, program, args, env, lengths = ['quick'] } of SUITES) {
    if (!lengths.includes(length)) continue
    // A continuous integration runs everything.
    const isKept = script !== undefined && length === 'quick' && !process.env.CI
    const report = isKept ? `${ROOT}build/reports/${script}.xml` : `${RESULTS}/${results.length}.xml`
    const status = await timed(name, () =>
      isKept
        ? statusOf('npm', ['run', '--silent', `test:${script}`], WIREIT)
        : statusOf(program, args(report, length === 'long'), { ...ENV, ...env?.(report) }),
    )
    const counts = countTests(report)
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

async function timed(name, work) {
  console.log(`\n── ${name}`)
  const start = performance.now()
  const result = await work()
  console.log(`── ${name}: ${Math.round((performance.now() - start) / 1000)} s`)
  return result
}
