// SPDX-License-Identifier: GPL-3.0-or-later
// Modules that not every program needs: they are loaded when they are asked for.

/** The module of comparison diagrams. */
export function importComparison(): Promise<typeof import('./comparison.ts')> {
  return import('./comparison.ts')
}

/** The module of regions and fitted areas. */
export function importRegions(): Promise<typeof import('./regions.ts')> {
  return import('./regions.ts')
}
