// SPDX-License-Identifier: GPL-3.0-or-later

/** A number with the digits that a reader needs. The number itself keeps all of its own. */
export function short(value: number, digits = 6): string {
  return String(Number(value.toPrecision(digits)))
}
