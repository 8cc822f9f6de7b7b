// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run soak -- --minutes N`: random circles of every family against CGAL's exact Apollonius graph
// (build/native/circle-voronoi-soak explains its options).
import { build, main, ROOT, run } from './run.mjs'

await main(async () => {
  await build('build:native')
  await run(`${ROOT}build/native/circle-voronoi-soak`, process.argv.slice(2))
})
