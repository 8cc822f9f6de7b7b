// SPDX-License-Identifier: GPL-3.0-or-later

/** Returns two, three or four numbers of a flat array. */
export function tuple(values: ArrayLike<number>, from: number, count: 2): [number, number]
export function tuple(values: ArrayLike<number>, from: number, count: 3): [number, number, number]
export function tuple(values: ArrayLike<number>, from: number, count: 4): [number, number, number, number]
export function tuple(values: ArrayLike<number>, from: number, count: number): number[] {
  return Array.from({ length: count }, (_, k) => values[from + k] as number)
}
