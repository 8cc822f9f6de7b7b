// SPDX-License-Identifier: GPL-3.0-or-later
// What Emscripten has written beside the modules that few programs need: it is loaded when it is asked for.

export async function loadComparisonScript(): Promise<typeof import('../generated/circle-voronoi-comparison.js')> {
  return import('../generated/circle-voronoi-comparison.js')
}

export async function loadRegionsScript(): Promise<typeof import('../generated/circle-voronoi-regions.js')> {
  return import('../generated/circle-voronoi-regions.js')
}
