// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../lib/comparison.ts in the one file, which would be larger by what few figures draw: it is fetched, as its
// WebAssembly is.
import type { Comparison } from '../../lib/comparison.ts'
import type { CircleVoronoi } from '../../lib/index.ts'

export async function loadComparison(library: CircleVoronoi): Promise<Comparison> {
  const here = import.meta.url
  const file = new URL('../lib/comparison.js', here).href
  return (await import(/* @vite-ignore */ file)).loadComparison(library)
}
