// SPDX-License-Identifier: GPL-3.0-or-later

/** The texts read out while circles are edited. */
export interface EditingWords {
  /** A circle within a sentence: its name, if it has one. The other texts take what this one returns. */
  called(id: number, name: string): string
  added(circle: string): string
  addedMany(count: number): string
  duplicated(count: number): string
  deleted(circle: string): string
  deletedMany(count: number): string
  moved(count: number): string
  selected(count: number): string
  /** Describes a circle and its cell. */
  circle(circle: string, description: string): string
  numbers(circle: string, x: string, y: string, r: string): string
  hidden(hider: string): string
  cell(isBounded: boolean, neighbors: number): string
  readonly snaps: string
  readonly snapsNot: string
}

const capitalized = (text: string) => text.charAt(0).toUpperCase() + text.slice(1)

export const ENGLISH_EDITING: EditingWords = {
  called: (id, name) => name || `circle ${id}`,
  added: (circle) => `${capitalized(circle)} added`,
  addedMany: (count) => `${count} circles added`,
  duplicated: (count) => (count === 1 ? 'Circle duplicated' : `${count} circles duplicated`),
  deleted: (circle) => `${capitalized(circle)} deleted`,
  deletedMany: (count) => `${count} circles deleted`,
  moved: (count) => `${count} circles moved`,
  selected: (count) => `${count} circles selected`,
  circle: (circle, description) => `${capitalized(circle)}. ${description}`,
  numbers: (circle, x, y, r) => `${capitalized(circle)}: x ${x}, y ${y}, r ${r}`,
  hidden: (hider) => `Hidden inside ${hider}: it has no cell.`,
  cell: (isBounded, neighbors) =>
    `${isBounded ? 'Bounded' : 'Unbounded'} cell, ${neighbors} ${neighbors === 1 ? 'neighbor' : 'neighbors'}`,
  snaps: 'Snapping is on',
  snapsNot: 'Snapping is off',
}
