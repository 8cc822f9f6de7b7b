// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run monkey [-- --actions 1500 --seed N]`: the page in the hands of a monkey (tests/e2e/monkey.spec.ts), which says its
// seed.
import { parseArgs } from 'node:util'
import { build, main, ROOT, run } from './run.mjs'
import { chromiumPath, setup } from './setup.mjs'

const { values } = parseArgs({ options: { actions: { type: 'string', default: '1500' }, seed: { type: 'string' } } })

await main(async () => {
  await setup('tests')
  await build('build')
  await run(`${ROOT}node_modules/.bin/playwright`, ['test', '--project=page', '--reporter=list', 'monkey.spec.ts'], {
    CHROMIUM_PATH: chromiumPath(),
    MONKEY_ACTIONS: values.actions,
    CIRCLE_VORONOI_SEED: values.seed ?? String(Math.floor(2 ** 31 * Math.random())),
  })
})
