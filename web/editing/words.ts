// SPDX-License-Identifier: GPL-3.0-or-later

/** The texts read out while circles are edited. */
export interface EditingWords {
  added(id: number): string
  addedMany(count: number): string
  duplicated(count: number): string
  deleted(id: number): string
  deletedMany(count: number): string
  moved(count: number): string
  selected(count: number): string
  /** Describes a circle and its cell. */
  circle(id: number, description: string): string
  numbers(id: number, x: string, y: string, r: string): string
  hidden(hider: number): string
  cell(isBounded: boolean, neighbors: number): string
  readonly snaps: string
  readonly snapsNot: string
}

export const ENGLISH_EDITING: EditingWords = {
  added: (id) => `Circle ${id} added`,
  addedMany: (count) => `${count} circles added`,
  duplicated: (count) => (count === 1 ? 'Circle duplicated' : `${count} circles duplicated`),
  deleted: (id) => `Circle ${id} deleted`,
  deletedMany: (count) => `${count} circles deleted`,
  moved: (count) => `${count} circles moved`,
  selected: (count) => `${count} circles selected`,
  circle: (id, description) => `Circle ${id}. ${description}`,
  numbers: (id, x, y, r) => `Circle ${id}: x ${x}, y ${y}, r ${r}`,
  hidden: (hider) => `Hidden inside circle ${hider}: it has no cell.`,
  cell: (isBounded, neighbors) =>
    `${isBounded ? 'Bounded' : 'Unbounded'} cell, ${neighbors} ${neighbors === 1 ? 'neighbor' : 'neighbors'}`,
  snaps: 'Snapping is on',
  snapsNot: 'Snapping is off',
}
