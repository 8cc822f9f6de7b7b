// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run mutate [-- --mutate web/lib/NAME.ts,... | --share 0.1 [--seed N]]`: StrykerJS changes web/lib, and the parts of the
// page that need no browser, in one place at a time (tests/mutants/stryker.config.mjs). It says which changes the tests in
// tests/web do not notice. A full run takes hours; `--share` draws some changes at random. The command fails if fewer than 85 %
// are noticed. The report is build/mutants/web.html. Other options are Stryker's.
import { parseArgs } from 'node:util'
import { build, main, ROOT, run } from './run.mjs'

const { values, tokens } = parseArgs({
  options: { share: { type: 'string' }, seed: { type: 'string', default: '1' } },
  strict: false,
  tokens: true,
})

await main(async () => {
  if (values.share !== undefined && !(Number(values.share) > 0 && Number(values.share) <= 1)) {
    throw new Error('--share is above 0 and at most 1.')
  }
  await build('build:wasm')
  const own = tokens
    .filter((token) => token.kind === 'option')
    .filter(({ name }) => name === 'share' || name === 'seed')
  const taken = new Set(own.flatMap(({ index, inlineValue }) => (inlineValue ? [index] : [index, index + 1])))
  const others = process.argv.slice(2).filter((_, i) => !taken.has(i))
  const sample =
    values.share === undefined ? {} : { CIRCLE_VORONOI_MUTANTS: values.share, CIRCLE_VORONOI_SEED: values.seed }
  await run(`${ROOT}node_modules/.bin/stryker`, ['run', 'tests/mutants/stryker.config.mjs', ...others], sample)
})
