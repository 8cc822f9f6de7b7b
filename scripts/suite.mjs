// SPDX-License-Identifier: GPL-3.0-or-later
// `node scripts/suite.mjs NAME REPORT`: runs one suite of quick tests, for the scripts of package.json that know its inputs.
import { mkdirSync } from 'node:fs'
import { dirname } from 'node:path'
import { main, ROOT, run } from './run.mjs'
import { ENV, SUITES } from './suites.mjs'

await main(async () => {
  const [name, path] = process.argv.slice(2)
  const [{ program, args, env }] = SUITES.filter((suite) => suite.name === name)
  const report = ROOT + path
  mkdirSync(dirname(report), { recursive: true })
  await run(program, args(report, false), { ...ENV, ...env?.(report) })
})
