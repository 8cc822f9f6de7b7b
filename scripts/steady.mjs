// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run test:steady [-- --suite Vitest --times 2]`: every quick test twice alone, on one core, beside two busy loops, and, if
// it is of a page, with a processor that seems four times as slow. Prints each test that was not always green; the exit
// status is 0 if there is none.
import { spawn } from 'node:child_process'
import { mkdirSync, rmSync } from 'node:fs'
import { parseArgs } from 'node:util'
import { countTests, failedTests } from './count-tests.mjs'
import { build, main, ROOT, statusOf } from './run.mjs'
import { ENV, SUITES } from './suites.mjs'

const REPORTS = `${ROOT}build/steady`
const CONDITIONS = [
  { name: 'alone' },
  { name: 'on one core', before: ['taskset', '--cpu-list', '0'] },
  { name: 'beside two busy loops', loops: 2 },
  { name: 'with a slowed processor', env: { CIRCLE_VORONOI_SLOWDOWN: '4' }, pagesAlone: true },
]

const { values } = parseArgs({
  options: { suite: { type: 'string', multiple: true }, times: { type: 'string', default: '2' } },
})

await main(async () => {
  const names = SUITES.map(({ name }) => name)
  const unknown = values.suite?.find((name) => !names.includes(name))
  if (unknown !== undefined) throw new Error(`There is no suite "${unknown}": ${names.join(', ')}.`)
  await build('build:tests')
  rmSync(REPORTS, { recursive: true, force: true })
  mkdirSync(REPORTS, { recursive: true })

  /** Counts of failures by test and condition. */
  const failures = new Map()
  const quick = SUITES.filter(({ name, lengths = ['quick'] }) => {
    return lengths.includes('quick') && (values.suite?.includes(name) ?? true)
  })
  const tell = (heading) => {
    console.log(`\n${heading}`)
    for (const [test, count] of failures) console.log(`${count} of ${values.times}: ${test}`)
  }
  for (const suite of quick) {
    for (const condition of CONDITIONS.filter(({ pagesAlone }) => !pagesAlone || suite.hasPages)) {
      for (let time = 0; time < Number(values.times); time++) {
        console.log(`\n── ${suite.name}, ${condition.name}, ${time + 1} of ${values.times}`)
        for (const test of await failedUnder(suite, condition)) {
          const key = `${suite.name}, ${condition.name}: ${test}`
          failures.set(key, (failures.get(key) ?? 0) + 1)
        }
      }
      // A run takes hours, and may be interrupted.
      if (failures.size > 0) tell(`Not always green until now, after ${suite.name}, ${condition.name}:`)
    }
  }
  tell('Not always green:')
  if (failures.size > 0) throw new Error(`${failures.size} tests were not always green.`)
  console.log('nothing')
})

/**
 * @param {import('./suites.mjs').Suite} suite
 * @param {typeof CONDITIONS[number]} condition
 */
async function failedUnder({ name, program, args, env }, { before = [], loops = 0, env: own }) {
  const report = `${REPORTS}/report.xml`
  rmSync(report, { force: true })
  const busy = Array.from({ length: loops }, () => spawn(process.execPath, ['-e', 'for (;;) {}']))
  try {
    const command = [...before, program, ...args(report, false)]
    const status = await statusOf(command[0], command.slice(1), { ...ENV, ...env?.(report), ...own })
    const failed = failedTests(report)
    const isSilentFailure = failed.length === 0 && (status !== 0 || countTests(report).passed === 0)
    return isSilentFailure ? [`all of ${name}`] : failed
  } finally {
    for (const loop of busy) loop.kill()
  }
}
