// SPDX-License-Identifier: GPL-3.0-or-later

/** What Emscripten has written beside `circle-voronoi-comparison.wasm`: few programs need it, so it is loaded when it is asked for. */
export async function loadComparisonScript(): Promise<typeof import('../generated/circle-voronoi-comparison.js')> {
  return import('../generated/circle-voronoi-comparison.js')
}
