// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../lib/wasm/import-comparison.ts in the one file, which would be larger by what few figures draw: the module
// is fetched, as its WebAssembly is.

export function importComparison(): Promise<typeof import('../../lib/wasm/comparison.ts')> {
  const here = import.meta.url
  return import(/* @vite-ignore */ new URL('../lib/wasm/comparison.js', here).href)
}
