// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run coverage`: how much of the C++ the native tests run, lines and branches, and in build/coverage/report.txt the lines of
// each file that none of them runs. Options are CTest's.
import { existsSync, readdirSync, rmSync } from 'node:fs'
import { main, ROOT, run, statusOf } from './run.mjs'
import { setup } from './setup.mjs'

const BUILD = `${ROOT}build/coverage`

await main(async () => {
  await setup('tests')
  if (!existsSync(`${BUILD}/build.ninja`)) await run('cmake', ['--preset', 'coverage'])
  await run('cmake', ['--build', '--preset', 'coverage'])
  const counts = readdirSync(BUILD, { recursive: true }).filter((path) => path.endsWith('.gcda'))
  for (const path of counts) rmSync(`${BUILD}/${path}`)
  const status = await statusOf('ctest', ['--preset', 'coverage', ...process.argv.slice(2)])
  // Ways out by an exception are no branches of ours.
  const options = ['--exclude-throw-branches', '--print-summary', '--output', `${BUILD}/report.txt`]
  await run('gcovr', ['--root', ROOT, '--filter', 'cpp/(include|src|cli)/', ...options, BUILD])
  console.log('Lines that no test runs: build/coverage/report.txt')
  if (status !== 0) throw new Error('Tests failed, so that others may not have run.')
})
