// SPDX-License-Identifier: GPL-3.0-or-later

/** Formats a number with few digits, for display only. */
export function short(value: number, digits = 6): string {
  return String(Number(value.toPrecision(digits)))
}
