// SPDX-License-Identifier: GPL-3.0-or-later
// Which discs wait, and what a disc is tested against.
import type { Circle, Vertex } from '../lib/index.ts'
import type { Trace, TraceState } from '../lib/wasm/trace.ts'
import { kindAt, type Step } from './steps.ts'

/** A disc that waits in the list, by radius. */
export interface WaitingDisc {
  readonly event: number
  readonly r: number
  readonly circles: readonly number[]
}

const ANTIPODAL = ['antipodalDiscAccepted', 'antipodalDiscUsed', 'antipodalDiscNotEmpty']

/** The first discs of the list, antipodal ones included: these are in the order in which they will be taken. */
export function waitingDiscs(trace: Trace, state: TraceState, after: number, most: number): readonly WaitingDisc[] {
  const waiting: WaitingDisc[] = []
  const add = (event: number) => {
    const { disc, circles } = trace.event(event)
    const isTriple = kindAt(trace, event) === 'threeTouchDiscFormed'
    waiting.push({ event, r: disc?.r ?? 0, circles: isTriple ? circles : circles.slice(0, 2) })
  }
  for (const event of state.queue.subarray(0, most)) add(event)
  let found = 0
  for (let k = after; k < trace.length && found < most; k++) {
    const kind = kindAt(trace, k) as string
    if (kind === 'roundBegun') break
    if (!ANTIPODAL.includes(kind)) continue
    add(k)
    found += 1
  }
  // Of equal radii three-touch discs come first, as they stand in the queue.
  return waiting.sort((a, b) => a.r - b.r).slice(0, most)
}

/** How many discs wait in all. */
export function waitingCount(trace: Trace, state: TraceState, after: number): number {
  let count = state.queue.length
  for (let k = after; k < trace.length && kindAt(trace, k) !== 'roundBegun'; k++) {
    if (ANTIPODAL.includes(kindAt(trace, k) as string)) count += 1
  }
  return count
}

/** A directed edge as seen from the center of one of its circles: an angle in turns, and whether it starts there. */
export interface RingMark {
  readonly angle: number
  readonly isOut: boolean
  readonly other: number
  readonly event: number
}

/** An arc, counter-clockwise, in turns from 0 to 1 on; `to` may be beyond 1. */
export interface RingArc {
  readonly from: number
  readonly to: number
}

export interface Ring {
  readonly marks: readonly RingMark[]
  /** Where no disc has touched the circle for the diagram yet. */
  readonly unused: readonly RingArc[]
}

/** The direction from a circle to a point, in turns, 0 to 1. */
export function turnTo(circle: Circle, x: number, y: number): number {
  const turn = Math.atan2(y - circle.y, x - circle.x) / (2 * Math.PI)
  return turn < 0 ? turn + 1 : turn
}

/** What lies around a circle, counter-clockwise. */
export function ringOf(trace: Trace, state: TraceState, id: number, circle: Circle): Ring {
  const marks: RingMark[] = []
  for (const event of state.directedEdges) {
    const { circles, disc } = trace.event(event)
    const [a, b] = circles as [number, number]
    if ((a !== id && b !== id) || disc === undefined) continue
    marks.push({ angle: turnTo(circle, disc.x, disc.y), isOut: a === id, other: a === id ? b : a, event })
  }
  // Where both directed edges of one disc are, the one that ends comes last: the unused arc begins there.
  marks.sort((s, t) => s.angle - t.angle || Number(t.isOut) - Number(s.isOut))
  const unused: RingArc[] = []
  for (const [k, mark] of marks.entries()) {
    if (mark.isOut) continue
    const next = marks[(k + 1) % marks.length] as RingMark
    if (next.isOut) unused.push({ from: mark.angle, to: next.angle + (next.angle <= mark.angle ? 1 : 0) })
  }
  return { marks, unused }
}

/** The circles that an antipodal disc is tested against: those at the next directed edges on both sides of its foot points. */
export function testedCircles(
  trace: Trace,
  state: TraceState,
  pair: readonly number[],
  disc: Vertex,
  circleOf: (id: number) => Circle | undefined,
): readonly number[] {
  const tested = new Set<number>()
  for (const id of pair) {
    const circle = circleOf(id)
    if (circle === undefined) continue
    const { marks } = ringOf(trace, state, id, circle)
    const foot = turnTo(circle, disc.x, disc.y)
    const before = marks.findLast((mark) => mark.angle < foot) ?? marks.at(-1)
    const after = marks.find((mark) => mark.angle > foot) ?? marks[0]
    for (const mark of [before, after]) if (mark !== undefined) tested.add(mark.other)
  }
  for (const id of pair) tested.delete(id)
  return [...tested].sort((a, b) => a - b)
}

/** The circles that the disc of a step is tested against. `state`: that after the step. */
export function testedAt(
  trace: Trace,
  { line, event, end }: Step,
  state: TraceState,
  circleOf: (id: number) => Circle | undefined,
): readonly number[] {
  if (!['take', 'place', 'notEmpty'].includes(line) || event >= trace.length) return []
  const { kind, circles, disc } = trace.event(event)
  if (!kind.startsWith('antipodal') || disc === undefined) return []
  const before = end === event ? state : trace.at(event)
  return testedCircles(trace, before, circles.slice(0, 2), disc, circleOf)
}
