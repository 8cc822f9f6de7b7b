// SPDX-License-Identifier: GPL-3.0-or-later
import { execFileSync } from 'node:child_process'
import { mkdirSync, readFileSync } from 'node:fs'
import { median } from './results/fit.mjs'
import { ROOT } from './run.mjs'

const NATIVE = `${ROOT}build/native/circle-voronoi`

/**
 * Returns the seconds of `compute` in WebAssembly and in the native program on the same circles, in turns: medians, and
 * the median of the ratios within each turn. Needs build/native and dist/lib.
 */
export async function benchWasm(families, sizes, repetitions) {
  const { loadCircleVoronoi } = await import(`${ROOT}dist/lib/index.js`)
  const library = await loadCircleVoronoi()
  const rows = []
  mkdirSync(`${ROOT}build/bench`, { recursive: true })
  for (const family of families) {
    for (const n of sizes) {
      const file = `${ROOT}build/bench/circles.csv`
      execFileSync(NATIVE, ['generate', family, String(n), '--seed', '1', '-o', file])
      const circles = Float64Array.from(
        readFileSync(file, 'utf8').trim().split('\n').slice(1).join(',').split(','),
        Number,
      )
      const turns = Array.from({ length: repetitions }, () => ({
        native: JSON.parse(execFileSync(NATIVE, ['compute', file, '--format', 'stats'], { encoding: 'utf8' })).seconds
          .total,
        wasm: library.compute(circles).stats.seconds.total,
      }))
      rows.push({
        family,
        n: circles.length / 3,
        native: median(turns.map(({ native }) => native)),
        wasm: median(turns.map(({ wasm }) => wasm)),
        ratio: Number(median(turns.map(({ native, wasm }) => wasm / native)).toFixed(2)),
      })
    }
  }
  return rows
}
