// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run bench [-- --sizes N,... --families NAME|FILE,... ...]`: builds the benchmark and runs it, natively (the table and
// build/bench/native.json; circle-voronoi-bench explains its options), then the WebAssembly build against the native one
// on circles of the same kind (build/bench/wasm.json). With `-- --edits` the table of edits, natively and in WebAssembly;
// with `-- --regions` that of clipping, also of polygons and edits in WebAssembly; with `-- --periodic` that of periodic
// diagrams; with `-- --sphere` that of diagrams on a sphere; with `-- --areas` that of fits of areas, also against
// d3-voronoi-map; with `-- --treemaps` that of treemaps in WebAssembly against d3-voronoi-treemap; with `-- --python` that
// of the Python package against the program and scipy.
import { mkdirSync, writeFileSync } from 'node:fs'
import { benchAreas } from './bench-areas.mjs'
import { benchEdits, benchWorstEdits } from './bench-edits.mjs'
import { benchRegions } from './bench-regions.mjs'
import { benchTreemaps } from './bench-treemap.mjs'
import { benchWasm } from './bench-wasm.mjs'
import { realData } from './data.mjs'
import { build, main, outcomeOf, ROOT, run } from './run.mjs'

const FAMILIES = 'uniform,log-uniform,hidden,hexagonal,grid,rows,intersecting,one-huge,ring'
const WASM_SIZES = [10_000, 100_000, 1_000_000]
const REPETITIONS = 5

await main(async () => {
  if (process.argv[2] === '--treemaps') {
    await build('build:lib')
    return console.table(await benchTreemaps())
  }
  await build('build:native')
  if (process.argv[2] === '--python') {
    const environment = { PYTHONPATH: `${ROOT}build/native/cpp/python` }
    return run(process.env.PYTHON_PATH ?? '/usr/bin/python3', ['scripts/bench-python.py'], environment)
  }
  await run('cmake', ['--preset', 'native', '-DCIRCLE_VORONOI_BUILD_BENCH=ON'])
  await run('cmake', ['--build', 'build/native', '--target', 'circle_voronoi_bench'])
  const chosen = process.argv.slice(2)
  const [cities] = realData()
  const isTable = ['--areas', '--cliffs', '--edits', '--files', '--periodic', '--regions', '--sphere'].includes(
    chosen[0],
  )
  const families = isTable || chosen.includes('--families') ? [] : ['--families', `${FAMILIES},${cities}`]
  const { status, output } = await outcomeOf(`${ROOT}build/native/circle-voronoi-bench`, [...families, ...chosen])
  if (status !== 0) throw new Error('The benchmark failed.')

  const isOfEdits = chosen[0] === '--edits'
  const isOfAreas = chosen[0] === '--areas'
  const isOfRegions = chosen[0] === '--regions'
  if (chosen.length > 0 && !isOfEdits && !isOfAreas && !isOfRegions) return
  await build('build:lib')
  if (isOfAreas) return console.table(await benchAreas(output))
  if (isOfRegions) return console.table(await benchRegions())
  if (isOfEdits) {
    console.table(await benchEdits(output))
    console.table(await benchWorstEdits(output))
    return
  }
  const rows = await benchWasm(FAMILIES.split(','), WASM_SIZES, REPETITIONS)
  console.table(rows)
  mkdirSync(`${ROOT}build/bench`, { recursive: true })
  writeFileSync(`${ROOT}build/bench/wasm.json`, `${JSON.stringify(rows, undefined, 1)}\n`)
})
