// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * A change of the circles: at circle `at`, the circles `removed` give way to the circles `inserted` (x, y, r each).
 * Moving, resizing, adding, deleting and loading are all of this form, and so is each one's reverse.
 */
export interface Edit {
  readonly at: number
  readonly removed: Float64Array
  readonly inserted: Float64Array
}

export function applyEdit(circles: Float64Array, { at, removed, inserted }: Edit): Float64Array {
  const result = new Float64Array(circles.length - removed.length + inserted.length)
  result.set(circles.subarray(0, 3 * at))
  result.set(inserted, 3 * at)
  result.set(circles.subarray(3 * at + removed.length), 3 * at + inserted.length)
  return result
}

export function reverse({ at, removed, inserted }: Edit): Edit {
  return { at, removed: inserted, inserted: removed }
}

export function replaceCircle(circles: Float64Array, index: number, x: number, y: number, r: number): Edit {
  return { at: index, removed: circles.slice(3 * index, 3 * index + 3), inserted: Float64Array.of(x, y, r) }
}

export function appendCircle(circles: Float64Array, x: number, y: number, r: number): Edit {
  return { at: circles.length / 3, removed: new Float64Array(0), inserted: Float64Array.of(x, y, r) }
}

export function removeCircle(circles: Float64Array, index: number): Edit {
  return { at: index, removed: circles.slice(3 * index, 3 * index + 3), inserted: new Float64Array(0) }
}

export function replaceAll(circles: Float64Array, others: Float64Array): Edit {
  return { at: 0, removed: circles, inserted: others }
}
