// SPDX-License-Identifier: GPL-3.0-or-later

/** The module of comparison diagrams, which few programs need: it is loaded when it is asked for. */
export function importComparison(): Promise<typeof import('./comparison.ts')> {
  return import('./comparison.ts')
}
