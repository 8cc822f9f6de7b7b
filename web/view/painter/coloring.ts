// SPDX-License-Identifier: GPL-3.0-or-later
import { at, NONE } from '../../lib/base/diagram-data.ts'
import type { Change, Diagram, DiagramSnapshot } from '../../lib/index.ts'
import { ENOUGH_COLORS, MAP_COLORS } from '../style.ts'
import { type Identified, idOf } from './cell-boxes.ts'

/**
 * Colors cells so that neighbors differ: eight circles or fewer with a color each, more with six colors. A circle keeps
 * its color through edits, by which it is known; neighbors may share one then.
 * The adjacency graph of cells is planar, and so is each of its subgraphs; each has a cell with at most five neighbors.
 * If such cells are removed one by one and colored in reverse order, a color is free for each.
 */
export class Coloring {
  /** The colors by circle id. */
  #colors: Uint8Array

  /** Whether `news` has returned the current colors. */
  #isTold = false

  constructor(diagram: Diagram) {
    this.#colors = colored(diagram)
  }

  /** Takes the colors of the first circles, a digit each by ascending id. */
  take(diagram: DiagramSnapshot, digits: string): void {
    this.#idsIn(diagram).forEach((id, k) => {
      if (k < digits.length) this.#colors[id] = Number(digits[k]) % MAP_COLORS
    })
    this.#isTold = false
  }

  /** The colors of all circles, as for `take`; `undefined` if they have not changed since the last call. */
  news(diagram: DiagramSnapshot): string | undefined {
    if (this.#isTold) return undefined
    this.#isTold = true
    return this.#idsIn(diagram)
      .map((id) => this.colorOf(id))
      .join('')
  }

  #idsIn(diagram: DiagramSnapshot): number[] {
    return Array.from(this.#colors.keys()).filter((id) => diagram.indexOf(id) !== NONE)
  }

  colorOf(id: number): number {
    return this.#colors[id] ?? 0
  }

  /** Colors inserted circles. One that was removed before gets its color back. */
  follow(diagram: DiagramSnapshot, { inserted, removed }: Change): void {
    if (inserted.length > 0 || removed.length > 0) this.#isTold = false
    for (const id of inserted) {
      if (id >= this.#colors.length) this.#grow(id)
      if (this.#colors[id] !== UNCOLORED) continue
      this.#colors[id] = freeColor(this.#takenBeside(diagram, diagram.indexOf(id)), id) ?? id % ENOUGH_COLORS
    }
  }

  #takenBeside(diagram: Diagram, i: number): number {
    let taken = 0
    for (const j of diagram.neighbors(i)) {
      const color = this.#colors[idOf(diagram, j)] ?? UNCOLORED
      if (color !== UNCOLORED) taken |= 1 << color
    }
    return taken
  }

  #grow(id: number): void {
    const larger = new Uint8Array(2 * id + 16).fill(UNCOLORED)
    larger.set(this.#colors)
    this.#colors = larger
  }
}

const UNCOLORED = 255

/** The first free color from `from` on, so that all colors are used about equally often. */
function freeColor(taken: number, from: number, colors = ENOUGH_COLORS): number | undefined {
  for (let k = 0; k < colors; k++) {
    const color = (from + k) % colors
    if ((taken & (1 << color)) === 0) return color
  }
  return undefined
}

function colored(diagram: Identified): Uint8Array {
  const count = diagram.circles.length / 3
  const used = count <= MAP_COLORS ? MAP_COLORS : ENOUGH_COLORS
  const order = smallestLast(diagram)
  const colors = new Uint8Array(count).fill(UNCOLORED)
  for (let k = count - 1; k >= 0; k--) {
    const i = at(order, k)
    let taken = 0
    for (const j of diagram.neighbors(i)) if (colors[j] !== UNCOLORED) taken |= 1 << (colors[j] as number)
    colors[i] = freeColor(taken, i, used) as number
  }
  const ids = diagram.numbers?.circles
  if (ids === undefined) return colors
  const byId = new Uint8Array(ids.reduce((most, id) => Math.max(most, id + 1), 0)).fill(UNCOLORED)
  for (let i = 0; i < count; i++) byId[at(ids, i)] = colors[i] as number
  return byId
}

/** The smallest-last order: each circle has the fewest neighbors among itself and all circles before it. */
function smallestLast(diagram: Diagram): Int32Array {
  const count = diagram.circles.length / 3
  const degrees = new Int32Array(count)
  const seen = new Int32Array(count).fill(NONE)
  const eachNeighbor = (i: number, act: (j: number) => void) => {
    for (const j of diagram.neighbors(i)) {
      // Two cells may share several edges.
      if (seen[j] === i) continue
      seen[j] = i
      act(j)
    }
  }
  for (let i = 0; i < count; i++) eachNeighbor(i, () => (degrees[i] as number)++)
  // One stack for each degree. Entries with an outdated degree and removed circles are skipped.
  const stacks: number[][] = []
  const push = (i: number) => {
    const degree = at(degrees, i)
    while (stacks.length <= degree) stacks.push([])
    ;(stacks[degree] as number[]).push(i)
  }
  for (let i = 0; i < count; i++) push(i)
  const isOut = new Uint8Array(count)
  const order = new Int32Array(count)
  seen.fill(NONE)
  let least = 0
  for (let k = 0; k < count; ) {
    const i = (stacks[least] as number[]).pop()
    if (i === undefined) {
      least += 1
      continue
    }
    if (isOut[i] === 1 || at(degrees, i) !== least) continue
    isOut[i] = 1
    order[k++] = i
    eachNeighbor(i, (j) => {
      if (isOut[j] === 1) return
      ;(degrees[j] as number)--
      push(j)
    })
    least = Math.max(least - 1, 0)
  }
  return order
}
