// SPDX-License-Identifier: GPL-3.0-or-later
// The colors of cells: neighbors differ, or a column of the table decides.

/** The colors of the drawing in light and dark pages. A measure has one of `tints`, more is stronger. */
export const PALETTES = {
  light: {
    water: '#faf8f4',
    ink: '#20242c',
    border: '#2a3140b0',
    coast: '#2a314059',
    disc: '#2a3140',
    accent: '#bf3f26',
    none: '#d9d6cf',
    hues: ['#c0d6ec', '#f6dfb1', '#bcdfd3', '#f0cddb', '#d0cdec', '#f7cdb9', '#dbe3b5', '#c9d0d8'],
    tints: ['#f6ecd2', '#dce8cd', '#b5d7cd', '#88bfd1', '#6399c8', '#5171b2'],
  },
  dark: {
    water: '#14171c',
    ink: '#eceef2',
    border: '#eceef2b0',
    coast: '#c9d0dc59',
    disc: '#c9d0dc',
    accent: '#ff8562',
    none: '#3a3f49',
    hues: ['#2b4864', '#6b5628', '#27534a', '#65405a', '#45437a', '#70432d', '#4b5526', '#454c57'],
    tints: ['#333d74', '#37609a', '#4284a3', '#63a597', '#97b98f', '#cfc08f'],
  },
}
const CLASSES = PALETTES.light.tints.length
/** More values than this share the hues. */
const MOST_LISTED = PALETTES.light.hues.length

/**
 * Names a color of a palette: a hue, a tint, or the color of cells without a value.
 * @typedef {`hues ${number}` | `tints ${number}` | 'none'} ColorName
 * @typedef {{ colors: ColorName[], legend: { color: ColorName, label: string }[] }} Coloring one color for each circle
 */

/** Returns a color of a palette. */
export function colorOf(palette, name) {
  const [list, index] = name.split(' ')
  return index === undefined ? palette[list] : palette[list][index]
}

/**
 * Gives different colors to neighbors.
 * @returns {Coloring}
 */
export function neighborColors(diagram) {
  const count = diagram.caps.length / 3
  const around = Array.from({ length: count }, (_, circle) => diagram.neighbors(circle))
  return { colors: hueByGraph(around), legend: [] }
}

/**
 * Colors cells by a value for each circle. Numbers have classes of equal size; other values have a hue each, or, if
 * these are too many, hues that differ between neighbors.
 * @param {readonly unknown[]} values
 * @returns {Coloring}
 */
export function valueColors(diagram, values) {
  const known = values.filter(isValue)
  if (known.length > 0 && known.every((value) => typeof value === 'number')) return numberColors(values, known)
  const names = [...new Set(known.map(String))].sort((a, b) => a.localeCompare(b))
  const indices = new Map(names.map((name, k) => [name, k]))
  const of = values.map((value) => (isValue(value) ? indices.get(String(value)) : undefined))
  const isListed = names.length <= MOST_LISTED
  const hues = isListed ? names.map((_, k) => `hues ${k}`) : hueByGraph(graphOf(diagram, of, names.length))
  return {
    colors: of.map((k) => (k === undefined ? 'none' : hues[k])),
    legend: isListed
      ? withNone(
          names.map((label, k) => ({ color: hues[k], label })),
          known,
          values,
        )
      : [],
  }
}

function numberColors(values, known) {
  const sorted = known.toSorted((a, b) => a - b)
  const quantiles = Array.from({ length: CLASSES }, (_, k) => sorted[Math.floor((k * sorted.length) / CLASSES)])
  const starts = [...new Set(quantiles)]
  const classOf = (value) => starts.findLastIndex((start) => value >= start)
  // Few classes are spread over all tints.
  const tint = (k) =>
    `tints ${starts.length === 1 ? CLASSES - 1 : Math.round((k * (CLASSES - 1)) / (starts.length - 1))}`
  const legend = starts.map((start, k) => {
    const largest = sorted.findLast((value) => classOf(value) === k)
    return { color: tint(k), label: start === largest ? short(start) : `${short(start)} to ${short(largest)}` }
  })
  return {
    colors: values.map((value) => (isValue(value) ? tint(classOf(value)) : 'none')),
    legend: withNone(legend, known, values),
  }
}

function withNone(legend, known, values) {
  return known.length === values.length ? legend : [...legend, { color: 'none', label: 'no value' }]
}

function isValue(value) {
  return value !== undefined && value !== null && value !== ''
}

/** The values whose cells are neighbors, for each value. */
function graphOf(diagram, indices, count) {
  const around = Array.from({ length: count }, () => new Set())
  for (const [circle, k] of indices.entries()) {
    for (const neighbor of k === undefined ? [] : diagram.neighbors(circle)) {
      const other = indices[neighbor]
      if (other !== undefined && other !== k) around[k].add(other)
    }
  }
  return around.map((set) => [...set])
}

/** Colors a graph: the nodes with the most neighbors first, each with the first hue that is free. */
function hueByGraph(around) {
  const hues = PALETTES.light.hues.length
  const colors = new Int8Array(around.length).fill(-1)
  const order = around.map((_, node) => node).sort((a, b) => around[b].length - around[a].length)
  for (const node of order) {
    const taken = new Set(Array.from(around[node], (neighbor) => colors[neighbor]))
    const free = Array.from({ length: hues }, (_, k) => k).find((k) => !taken.has(k))
    colors[node] = free ?? node % hues
  }
  return Array.from(colors, (color) => `hues ${color}`)
}

/** Returns a number with three significant digits. */
export function short(value) {
  return new Intl.NumberFormat('en', { maximumSignificantDigits: 3, useGrouping: true }).format(value)
}
