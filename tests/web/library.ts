// SPDX-License-Identifier: GPL-3.0-or-later
import { readFileSync } from 'node:fs'
import { loadCircleVoronoi } from '../../web/lib/index.ts'
import { circlesOfText } from '../../web/view/circle-text.ts'

/** The WebAssembly module, loaded once per test file. */
export const library = await loadCircleVoronoi()

export function dataSet(name: string): Float64Array {
  return circlesOfText(readFileSync(new URL(`../../public/data/${name}.csv`, import.meta.url), 'utf8'))
}

/** A reproducible source of numbers from 0 to 1. */
export function seededRandom(seed: number): () => number {
  let state = seed
  return () => {
    state = (state * 1664525 + 1013904223) % 2 ** 32
    return state / 2 ** 32
  }
}
