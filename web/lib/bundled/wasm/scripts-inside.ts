// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../wasm/module-scripts.ts in the element's thread and one-file builds. They are imported statically: Vite up to 7
// cannot split the code of a worker, and a script that is opened from a disk can import nothing.
import createComparison from '../../generated/circle-voronoi-comparison.js'
import createRegions from '../../generated/circle-voronoi-regions.js'

export async function loadComparisonScript(): Promise<typeof import('../../generated/circle-voronoi-comparison.js')> {
  return { default: createComparison }
}

export async function loadRegionsScript(): Promise<typeof import('../../generated/circle-voronoi-regions.js')> {
  return { default: createRegions }
}
