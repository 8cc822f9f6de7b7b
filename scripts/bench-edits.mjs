// SPDX-License-Identifier: GPL-3.0-or-later
import { execFileSync } from 'node:child_process'
import { mkdirSync, readFileSync } from 'node:fs'
import { median } from './results/fit.mjs'
import { ROOT } from './run.mjs'

const NATIVE = `${ROOT}build/native/circle-voronoi`
/** The number of edits in cpp/bench/edits.cpp. */
const EDITS = 10_000

/**
 * Repeats the native table's single edits anywhere in WebAssembly, called from JavaScript with a `Change` each. Returns
 * microseconds, and multiples of the native times. Needs build/native and dist/lib.
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

/**
 * Returns a row for each line of the native table about one of the worst edits: milliseconds in WebAssembly, and multiples of a
 * `compute` of the circles before the edit or after it, whichever takes longer.
 */
export async function benchWorstEdits(table) {
  const { loadCircleVoronoi } = await import(`${ROOT}dist/lib/index.js`)
  const library = await loadCircleVoronoi()
  const lines = [
    ...table.matchAll(/^(\S+) +(\d+) +((?:insert|shrink|nudge|remove) .*?) +([\d.]+) s, ([\d.]+) times compute$/gm),
  ]
  const edits = new Map()
  return lines.flatMap(([, family, count, what, seconds, multiple]) => {
    const key = `${family} ${count}`
    if (!edits.has(key)) edits.set(key, worstEdits(inputOf(family, Number(count))?.circles))
    const worst = edits.get(key)?.[what]
    if (worst === undefined) return []
    const { milliseconds, compute } = worstTime(library, worst)
    return {
      family,
      n: Number(count),
      edit: what,
      'native, ms': 1000 * Number(seconds),
      'of a compute': Number(multiple),
      'wasm, ms': rounded(milliseconds),
      'of its compute': Number((milliseconds / compute).toFixed(2)),
    }
  })
}

/** The edits of cpp/bench/edits.cpp. */
function worstEdits(circles) {
  if (circles === undefined) return undefined
  const least = (list) => list.reduce((a, b) => Math.min(a, b))
  const most = (list) => list.reduce((a, b) => Math.max(a, b))
  const [xs, ys] = [circles.map(({ x }) => x), circles.map(({ y }) => y)]
  const side = Math.max(most(xs) - least(xs), most(ys) - least(ys))
  const middle = { x: (least(xs) + most(xs)) / 2, y: (least(ys) + most(ys)) / 2 }
  const disc = (radius) => ({ ...middle, r: radius * side })
  const [ofAll, ofASixth] = [disc(1), disc(0.23)]
  const moved = { ...ofASixth, x: ofASixth.x + ofASixth.r / 50 }
  const around = circles.map(({ x, y, r }, i) =>
    i % 5 === 0
      ? { x: middle.x + side * Math.cos(i), y: middle.y + side * Math.sin(i), r: 0 }
      : { x: x + 3 * side, y, r },
  )
  const last = circles.length
  const inserting = (circle) => ({ circles, after: [...circles, circle], edit: (editor) => editor.insert(circle) })
  const replacing = (circle, by) => ({
    circles: [...circles, circle],
    after: [...circles, by],
    edit: (editor) => editor.replace(last, by),
  })
  const removing = (after, circle) => ({ circles: [...after, circle], after, edit: (editor) => editor.remove(last) })
  return {
    'insert a point at 1e28': inserting({ x: 1e28, y: 0, r: 0 }),
    'insert one that hides all': inserting(ofAll),
    'shrink one that hides all': replacing(ofAll, disc(1e-6)),
    'insert one that hides a sixth': inserting(ofASixth),
    'nudge one that hides a sixth': replacing(ofASixth, moved),
    'remove one that hides a sixth': removing(circles, ofASixth),
    'remove a neighbor of a fifth': removing(around, disc(0.5)),
  }
}

/** The least of three runs, as in the native benchmark. */
function worstTime(library, { circles, after, edit }) {
  const turns = [1, 2, 3].map(() => {
    const editor = library.edit(circles)
    try {
      return [() => edit(editor), () => library.compute(circles), () => library.compute(after)].map(microsecondsOf)
    } finally {
      editor.dispose()
    }
  })
  const [ours, ...computes] = [0, 1, 2].map((k) => Math.min(...turns.map((times) => times[k])) / 1000)
  return { milliseconds: ours, compute: Math.max(...computes) }
}

/**
 * The native benchmark's circles: even ones are edited, odd ones are inserted. `undefined` if the circles come from a
 * file.
 */
function inputOf(family, count) {
  const file = `${ROOT}build/bench/circles.csv`
  mkdirSync(`${ROOT}build/bench`, { recursive: true })
  const isFamily = execFileSync(NATIVE, ['generate', '--list'], { encoding: 'utf8' })
    .split('\n')
    .some((line) => line.split(' ')[0] === family)
  if (!isFamily) return undefined
  execFileSync(NATIVE, ['generate', family, String(2 * count), '--seed', '1', '-o', file])
  /** @type {{ x: number, y: number, r: number }[][]} */
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
