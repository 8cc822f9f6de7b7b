// SPDX-License-Identifier: GPL-3.0-or-later
// Loads Emscripten's scripts of the modules that few programs need.

export async function loadComparisonScript(): Promise<typeof import('../generated/circle-voronoi-comparison.js')> {
  return import('../generated/circle-voronoi-comparison.js')
}

export async function loadRegionsScript(): Promise<typeof import('../generated/circle-voronoi-regions.js')> {
  return import('../generated/circle-voronoi-regions.js')
}
