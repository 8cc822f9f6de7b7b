// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../lib/wasm/import-modules.ts in the one file, which would be larger by what few figures draw: the modules
// are fetched, as their WebAssembly is.

export function importComparison(): Promise<typeof import('../../lib/wasm/comparison.ts')> {
  return importBeside('comparison')
}

export function importRegions(): Promise<typeof import('../../lib/wasm/regions.ts')> {
  return importBeside('regions')
}

function importBeside(name: string) {
  const here = import.meta.url
  return import(/* @vite-ignore */ new URL(`../lib/wasm/${name}.js`, here).href)
}
