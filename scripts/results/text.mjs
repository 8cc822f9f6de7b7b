// SPDX-License-Identifier: GPL-3.0-or-later
// Formats numbers and tables for docs/results.md.

export function count(value) {
  return value.toLocaleString('en-US')
}

export function fixed(value, digits) {
  return value.toFixed(digits)
}

export function percent(part) {
  const value = 100 * part
  return `${value === 0 || value >= 10 ? Math.round(value) : value.toPrecision(2)}${NBSP}%`
}

const NBSP = '\u00a0'

/** Formats a duration with three digits and a unit. */
export function seconds(value) {
  if (value >= 1) return `${Number(value.toPrecision(3))}${NBSP}s`
  return value >= 1e-3
    ? `${Number((1e3 * value).toPrecision(3))}${NBSP}ms`
    : `${Number((1e6 * value).toPrecision(3))}${NBSP}µs`
}

/** Formats the exponent of a power law with its confidence interval. */
export function power({ slope, halfWidth }) {
  return `n^${slope.toFixed(3)}${NBSP}±${NBSP}${halfWidth.toFixed(3)}`
}

/** A Markdown table. */
export function table(header, rows) {
  const line = (cells) => `| ${cells.join(' | ')} |`
  return [line(header), `|${'---|'.repeat(header.length)}`, ...rows.map(line)].join('\n')
}
