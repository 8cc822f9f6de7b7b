// SPDX-License-Identifier: GPL-3.0-or-later
import type { KeyRow } from '../editing/key-help.ts'

/** The keyboard shortcuts of the page beyond those of a figure. */
export const PAGE_KEYS = {
  copy: ['Ctrl + C, X, V', 'copy, cut, paste'],
  numbers: ['Enter', 'type the numbers of the selected circle'],
  tools: ['V, H, A', 'select, pan, add until Escape'],
  region: ['P', 'draw a region: click corners, or arrows and Space; double-click or Enter closes, Escape cancels'],
  help: ['?', 'all keys'],
} as const satisfies Readonly<Record<string, KeyRow>>
