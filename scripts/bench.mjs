// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run bench [-- --sizes N,... --families NAME|FILE,... ...]`: builds the benchmark and runs it, natively (the table and
// build/bench/native.json; circle-voronoi-bench explains its options), then the WebAssembly build against the native one
// on circles of the same kind (build/bench/wasm.json).
import { execFileSync } from 'node:child_process'
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { buildLib, buildNative, buildWasm } from './build.mjs'
import { realData } from './data.mjs'
import { main, ROOT, run } from './run.mjs'
import { setup } from './setup.mjs'

const NATIVE = `${ROOT}build/native/circle-voronoi`
const FAMILIES = 'uniform,log-uniform,hidden,hexagonal,grid,rows,intersecting,one-huge,ring'
const WASM_SIZES = [10_000, 100_000, 1_000_000]
const REPETITIONS = 5

await main(async () => {
  await setup({ tests: true })
  await buildNative()
  await run('cmake', ['--preset', 'native', '-DCIRCLE_VORONOI_BUILD_BENCH=ON'])
  await run('cmake', ['--build', 'build/native', '--target', 'circle_voronoi_bench'])
  const chosen = process.argv.slice(2)
  const [cities] = realData()
  const isTable = chosen[0] === '--cliffs' || chosen[0] === '--files'
  const families = isTable || chosen.includes('--families') ? [] : ['--families', `${FAMILIES},${cities}`]
  await run(`${ROOT}build/native/circle-voronoi-bench`, [...families, ...chosen])

  if (chosen.length > 0) return
  await buildWasm()
  await buildLib()
  await benchWasm(FAMILIES.split(','))
})

/** Median seconds of `compute` in WebAssembly and in the native program, on the same circles. */
async function benchWasm(families) {
  const { loadCircleVoronoi } = await import(`${ROOT}dist/lib/index.js`)
  const library = await loadCircleVoronoi()
  const rows = []
  mkdirSync(`${ROOT}build/bench`, { recursive: true })
  for (const family of families) {
    for (const n of WASM_SIZES) {
      const file = `${ROOT}build/bench/circles.csv`
      execFileSync(NATIVE, ['generate', family, String(n), '--seed', '1', '-o', file])
      const circles = Float64Array.from(
        readFileSync(file, 'utf8').trim().split('\n').slice(1).join(',').split(','),
        Number,
      )
      const native = median(
        () => JSON.parse(execFileSync(NATIVE, ['compute', file, '--format', 'stats'])).seconds.total,
      )
      const wasm = median(() => library.compute(circles).stats.seconds.total)
      rows.push({ family, n: circles.length / 3, native, wasm, ratio: Number((wasm / native).toFixed(2)) })
    }
  }
  console.table(rows)
  writeFileSync(`${ROOT}build/bench/wasm.json`, `${JSON.stringify(rows, undefined, 1)}\n`)
}

function median(measure) {
  const values = Array.from({ length: REPETITIONS }, measure).sort((a, b) => a - b)
  return values[Math.floor(REPETITIONS / 2)]
}
