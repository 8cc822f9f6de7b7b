// SPDX-License-Identifier: GPL-3.0-or-later

const capitalized = (text: string) => text.charAt(0).toUpperCase() + text.slice(1)

/** The texts read out while circles are edited. */
export const ENGLISH_EDITING = {
  /** A circle within a sentence: its name, if it has one. The other texts take what this one returns. */
  called: (id: number, name: string) => name || `circle ${id}`,
  added: (circle: string) => `${capitalized(circle)} added`,
  addedMany: (count: number) => `${count} circles added`,
  duplicated: (count: number) => (count === 1 ? 'Circle duplicated' : `${count} circles duplicated`),
  deleted: (circle: string) => `${capitalized(circle)} deleted`,
  deletedMany: (count: number) => `${count} circles deleted`,
  moved: (count: number) => `${count} circles moved`,
  selected: (count: number) => `${count} circles selected`,
  /** Describes a circle and its cell. */
  circle: (circle: string, description: string) => `${capitalized(circle)}. ${description}`,
  numbers: (circle: string, x: string, y: string, r: string) => `${capitalized(circle)}: x ${x}, y ${y}, r ${r}`,
  hidden: (hider: string) => `Hidden inside ${hider}: it has no cell.`,
  cell: (isBounded: boolean, neighbors: number) =>
    `${isBounded ? 'Bounded' : 'Unbounded'} cell, ${neighbors} ${neighbors === 1 ? 'neighbor' : 'neighbors'}`,
  snaps: 'Snapping is on',
  snapsNot: 'Snapping is off',
}

export type EditingWords = typeof ENGLISH_EDITING
