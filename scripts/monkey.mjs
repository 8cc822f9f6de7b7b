// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run monkey [-- --minutes 5] [--seed N]`: the page in the hands of a monkey (tests/e2e/monkey.spec.ts), which says its seed.
import { buildSite, buildWasm } from './build.mjs'
import { main, ROOT, run } from './run.mjs'
import { chromiumPath, setup } from './setup.mjs'

const MINUTES = 5

await main(async () => {
  const option = (name) => {
    const place = process.argv.indexOf(`--${name}`)
    return place < 0 ? undefined : Number(process.argv[place + 1])
  }
  await setup('tests')
  await buildWasm('page')
  await buildSite()
  const seed = option('seed') ?? Math.floor(2 ** 31 * Math.random())
  await run(`${ROOT}node_modules/.bin/playwright`, ['test', '--project=page', '--reporter=list', 'monkey.spec.ts'], {
    CHROMIUM_PATH: chromiumPath(),
    MONKEY_SECONDS: String(60 * (option('minutes') ?? MINUTES)),
    CIRCLE_VORONOI_SEED: String(seed),
  })
})
