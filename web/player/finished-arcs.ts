// SPDX-License-Identifier: GPL-3.0-or-later
import { at, NONE } from '../lib/base/diagram-data.ts'
import type { Circle, Vertex } from '../lib/index.ts'
import { TRACE_KINDS, type Trace } from '../lib/wasm/trace.ts'

const ROUND_BEGUN = TRACE_KINDS.indexOf('roundBegun')
const PLACED = TRACE_KINDS.indexOf('directedEdgePlaced')
const FINISHED = TRACE_KINDS.indexOf('segmentFinished')

/**
 * Finds the segments that a trace finishes. Each runs from the disc that placed its directed edge to the disc that
 * ended it.
 */
export class FinishedArcs {
  readonly #trace: Trace
  /** Maps an event that finishes a segment to the event that placed its directed edge. */
  readonly #placing: Int32Array
  readonly #arcs = new Map<number, readonly number[]>()

  constructor(trace: Trace) {
    this.#trace = trace
    this.#placing = new Int32Array(trace.length).fill(NONE)
    const placed = new Map<number, number>()
    for (const [k, kind] of trace.kinds.entries()) {
      const number = at(trace.numbers, 2 * k)
      if (kind === ROUND_BEGUN) placed.clear()
      else if (kind === PLACED) placed.set(number, k)
      else if (kind === FINISHED) this.#placing[k] = placed.get(number) ?? NONE
    }
  }

  /** Returns segments as polylines: x and y of one end, then x and y of the other, for each piece. */
  of(events: Int32Array, circleOf: (id: number) => Circle | undefined): Float64Array {
    const pieces: number[] = []
    for (const k of events) {
      let arc = this.#arcs.get(k)
      if (arc === undefined) {
        arc = this.#arcOf(k, circleOf)
        this.#arcs.set(k, arc)
      }
      for (const value of arc) pieces.push(value)
    }
    return Float64Array.from(pieces)
  }

  #arcOf(k: number, circleOf: (id: number) => Circle | undefined): readonly number[] {
    const placing = at(this.#placing, k)
    if (placing === NONE) return []
    const { disc: from, circles } = this.#trace.event(placing)
    const { disc: to } = this.#trace.event(k)
    const [a, b] = circles.map(circleOf)
    if (from === undefined || to === undefined || a === undefined || b === undefined) return []
    return arcOf(a, b, from, to)
  }
}

const PIECES = 12

/** The bisector between two discs, as seen from the larger circle, within half a turn. */
export function arcOf(a: Circle, b: Circle, from: Vertex, to: Vertex): number[] {
  const [large, small] = a.r >= b.r ? [a, b] : [b, a]
  const [dx, dy, s] = [small.x - large.x, small.y - large.y, small.r - large.r]
  const gap = dx * dx + dy * dy - s * s
  const start = Math.atan2(from.y - large.y, from.x - large.x)
  const whole = Math.atan2(to.y - large.y, to.x - large.x) - start
  const turn = whole - 2 * Math.PI * Math.round(whole / (2 * Math.PI))
  const pieces: number[] = []
  let [x, y] = [from.x, from.y]
  for (let k = 1; k <= PIECES; k++) {
    const angle = start + (turn * k) / PIECES
    const reach = gap / (2 * (dx * Math.cos(angle) + dy * Math.sin(angle) + s))
    const isLast = k === PIECES || !(reach > 0)
    const next = isLast ? to : { x: large.x + reach * Math.cos(angle), y: large.y + reach * Math.sin(angle) }
    pieces.push(x, y, next.x, next.y)
    ;[x, y] = [next.x, next.y]
    if (isLast) break
  }
  return pieces
}
