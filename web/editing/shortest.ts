// SPDX-License-Identifier: GPL-3.0-or-later

/** Six digits are enough to read; the number itself keeps all of its own. */
export function shortest(value: number): string {
  return String(Number(value.toPrecision(6)))
}
