// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run soak -- --minutes N`: random circles of every family against CGAL's exact Apollonius graph
// (build/native/circle-voronoi-soak explains its options).
import { buildNative } from './build.mjs'
import { main, ROOT, run } from './run.mjs'
import { setup } from './setup.mjs'

await main(async () => {
  await setup('tests')
  await buildNative()
  await run(`${ROOT}build/native/circle-voronoi-soak`, process.argv.slice(2))
})
