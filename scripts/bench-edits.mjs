// SPDX-License-Identifier: GPL-3.0-or-later
import { execFileSync } from 'node:child_process'
import { mkdirSync, readFileSync } from 'node:fs'
import { median } from './results/fit.mjs'
import { ROOT } from './run.mjs'

const NATIVE = `${ROOT}build/native/circle-voronoi`
/** As in cpp/bench/edits.cpp. */
const EDITS = 10_000

/**
 * For each line of the native table about single edits anywhere the same edits in WebAssembly, called from JavaScript, a
 * `Change` each: microseconds, and how many times the native ones. Needs build/native and dist/lib.
 */
export async function benchEdits(table) {
  const { loadCircleVoronoi } = await import(`${ROOT}dist/lib/index.js`)
  const library = await loadCircleVoronoi()
  const lines = [...table.matchAll(/^(\S+) +(\d+) +ours +(insert|remove|small move), anywhere +([\d.]+) +([\d.]+)$/gm)]
  const measured = new Map()
  return lines.flatMap(([, family, count, what, microseconds]) => {
    const key = `${family} ${count}`
    if (!measured.has(key)) measured.set(key, timesOf(library, inputOf(family, Number(count))))
    const times = measured.get(key)
    if (times === undefined) return []
    const sorted = times[what].toSorted((a, b) => a - b)
    return {
      family,
      n: Number(count),
      edit: what,
      native: Number(microseconds),
      wasm: rounded(median(sorted)),
      'wasm, 99.9 %': rounded(sorted[Math.floor(0.999 * (sorted.length - 1))]),
      ratio: Number((median(sorted) / Number(microseconds)).toFixed(2)),
    }
  })
}

/** The native benchmark's circles: the even ones are edited, the odd ones come. `undefined` for those of a file. */
function inputOf(family, count) {
  const file = `${ROOT}build/bench/circles.csv`
  mkdirSync(`${ROOT}build/bench`, { recursive: true })
  const isFamily = execFileSync(NATIVE, ['generate', '--list'], { encoding: 'utf8' })
    .split('\n')
    .some((line) => line.split(' ')[0] === family)
  if (!isFamily) return undefined
  execFileSync(NATIVE, ['generate', family, String(2 * count), '--seed', '1', '-o', file])
  const [circles, supply] = [[], []]
  for (const [i, line] of readFileSync(file, 'utf8').trim().split('\n').slice(1).entries()) {
    const [x, y, r] = line.split(',').map(Number)
    ;(i % 2 === 0 ? circles : supply).push({ x, y, r })
  }
  return { circles, supply }
}

function timesOf(library, input) {
  if (input === undefined) return undefined
  const { circles, supply } = input
  const xs = circles.map(({ x }) => x)
  const spacing = (xs.reduce((a, b) => Math.max(a, b)) - xs.reduce((a, b) => Math.min(a, b))) / Math.sqrt(xs.length)
  const editor = library.edit(circles)
  try {
    const moved = shuffled(circles.map((_, id) => id)).slice(0, EDITS)
    const moves = moved.map((id) => {
      const { x, y, r } = editor.circle(id)
      return microsecondsOf(() => editor.replace(id, { x: x + 0.01 * spacing, y, r }))
    })
    const ids = []
    const inserts = supply.slice(0, EDITS).map((circle) =>
      microsecondsOf(() => {
        ids.push(editor.insert(circle).inserted[0])
      }),
    )
    return {
      insert: inserts,
      remove: shuffled(ids).map((id) => microsecondsOf(() => editor.remove(id))),
      'small move': moves,
    }
  } finally {
    editor.dispose()
  }
}

function microsecondsOf(edit) {
  const start = performance.now()
  edit()
  return 1000 * (performance.now() - start)
}

function shuffled(list) {
  let state = 1
  for (let i = list.length - 1; i > 0; i--) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0
    const k = Math.floor((state / 2 ** 32) * (i + 1))
    ;[list[i], list[k]] = [list[k], list[i]]
  }
  return list
}

function rounded(value) {
  return Number(value.toPrecision(3))
}
