// SPDX-License-Identifier: GPL-3.0-or-later
// The script of the regions' module for a worker. It is imported statically: some bundlers cannot split the code of a worker.
import createModule from '../generated/circle-voronoi-regions.js'
import type { RegionsScript } from '../wasm/regions.ts'

export async function loadRegionsScript(): Promise<{ readonly default: RegionsScript }> {
  return { default: createModule }
}
