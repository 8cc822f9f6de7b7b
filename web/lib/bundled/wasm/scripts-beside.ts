// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../wasm/module-scripts.ts in the library's bundle, which would be larger by what few programs need: it is
// fetched, as its WebAssembly is.

export function loadComparisonScript(): Promise<typeof import('../../generated/circle-voronoi-comparison.js')> {
  return importBeside('comparison')
}

export function loadRegionsScript(): Promise<typeof import('../../generated/circle-voronoi-regions.js')> {
  return importBeside('regions')
}

async function importBeside(name: string) {
  const here = import.meta.url
  return import(/* @vite-ignore */ new URL(`../lib/generated/circle-voronoi-${name}.js`, here).href)
}
