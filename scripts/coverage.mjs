// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run coverage`: the share of lines and branches in C++ that the native tests run. build/coverage/report.txt lists the other
// lines of each file. Options are CTest's. `npm run coverage -- --web`: the share of web/ that the Vitest tests run, with the
// lines in build/coverage-web. Further options are Vitest's.
import { existsSync, readdirSync, rmSync } from 'node:fs'
import { build, main, ROOT, run, statusOf } from './run.mjs'
import { setup } from './setup.mjs'

const BUILD = `${ROOT}build/coverage`
const WEB = '--web'
const options = process.argv.slice(2).filter((option) => option !== WEB)

await main(process.argv.includes(WEB) ? coverageOfWeb : coverageOfCore)

async function coverageOfWeb() {
  await build('build:tests')
  const reporters = ['text-summary', 'html'].map((name) => `--coverage.reporter=${name}`)
  const files = ['--coverage.include=web/**/*.ts', '--coverage.exclude=web/**/generated/**']
  const place = '--coverage.reportsDirectory=build/coverage-web'
  // Includes code that only failing tests have run.
  const always = '--coverage.reportOnFailure'
  await run(`${ROOT}node_modules/.bin/vitest`, ['run', '--coverage', ...reporters, ...files, place, always, ...options])
  console.log('Lines that no test runs: build/coverage-web/index.html')
}

async function coverageOfCore() {
  await setup('tests')
  if (!existsSync(`${BUILD}/build.ninja`)) await run('cmake', ['--preset', 'coverage'])
  await run('cmake', ['--build', '--preset', 'coverage'])
  const counts = readdirSync(BUILD, { recursive: true, encoding: 'utf8' }).filter((path) => path.endsWith('.gcda'))
  for (const path of counts) rmSync(`${BUILD}/${path}`)
  const status = await statusOf('ctest', ['--preset', 'coverage', ...options])
  // Branches to exception handlers are not counted.
  const report = ['--exclude-throw-branches', '--print-summary', '--output', `${BUILD}/report.txt`]
  await run('gcovr', ['--root', ROOT, '--filter', 'cpp/(include|src|cli)/', ...report, BUILD])
  console.log('Lines that no test runs: build/coverage/report.txt')
  if (status !== 0) throw new Error('Tests failed, so that others may not have run.')
}
