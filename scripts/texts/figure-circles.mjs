// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the circles of the tutorial's figures. They are listed in the figure or named as in the playground
// (web/app/data-sets.ts): a file, `figure-7a` of the paper, or `ring:1:49`, a family with its seed and number.
import { readFileSync } from 'node:fs'
import { ROOT } from '../run.mjs'

/** Significant digits of circles in a page. More digits would make the page long without a visible difference. */
const DIGITS = 6

/** @returns {Promise<(figure: object) => number[][]>} x, y and r of each circle */
export async function loadFigureCircles() {
  const { default: createModule } = await import(`${ROOT}web/app/generated/families.js`)
  const families = await createModule({ wasmBinary: readFileSync(`${ROOT}web/app/generated/families.wasm`) })

  return ({ name, circles, dataSet }) => {
    if (circles !== undefined) return circles
    const made = named(dataSet)
    if (made === undefined) throw new Error(`The figure ${name} has no circles.`)
    return triples(made).map((circle) => circle.map((value) => Number(value.toPrecision(DIGITS))))
  }

  function named(dataSet = '') {
    const [, figure] = /^figure-(\w+)$/.exec(dataSet) ?? []
    if (figure !== undefined) return families.figure(figure)
    const [, family, seed, count] = /^([a-z-]+):(\d+):(\d+)$/.exec(dataSet) ?? []
    if (family !== undefined) return families.generate(family, Number(count), Number(seed))
    const lines = readFileSync(`${ROOT}public/data/${dataSet}.csv`, 'utf8').trim().split('\n').slice(1)
    return lines.flatMap((line) => line.split(',').slice(0, 3).map(Number))
  }
}

function triples(numbers) {
  return Array.from({ length: numbers.length / 3 }, (_, i) => Array.from(numbers.slice(3 * i, 3 * i + 3)))
}
