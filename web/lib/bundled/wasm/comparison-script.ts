// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../wasm/comparison-script.ts in one file, which would be larger by what few programs need: it is fetched, as its
// WebAssembly is.

export async function loadComparisonScript(): Promise<typeof import('../../generated/circle-voronoi-comparison.js')> {
  const here = import.meta.url
  return import(/* @vite-ignore */ new URL('../lib/generated/circle-voronoi-comparison.js', here).href)
}
