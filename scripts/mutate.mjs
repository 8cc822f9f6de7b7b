// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run mutate [-- --mutate web/lib/NAME.ts,...]`: StrykerJS changes web/lib in one place at a time, and says which
// changes the tests in tests/web do not notice (tests/mutants/stryker.config.mjs); all of it takes hours. It fails if fewer
// than 85 % are noticed. The report is build/mutants/web.html.
import { buildWasm } from './build.mjs'
import { main, ROOT, run } from './run.mjs'
import { setup } from './setup.mjs'

await main(async () => {
  await setup('package')
  await buildWasm('package')
  const options = process.argv.slice(2)
  await run(`${ROOT}node_modules/.bin/stryker`, ['run', 'tests/mutants/stryker.config.mjs', ...options])
})
