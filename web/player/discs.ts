// SPDX-License-Identifier: GPL-3.0-or-later
// The discs that wait in the queue, and the circles that a disc is tested against.
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

/** The first discs of the queue, antipodal ones included, in the order in which the method will take them. */
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
  // Discs of equal radius keep the order in which they entered the queue.
  return waiting.sort((a, b) => a.r - b.r).slice(0, most)
}

/** The number of discs in the queue. */
export function waitingCount(trace: Trace, state: TraceState, after: number): number {
  let count = state.queue.length
  for (let k = after; k < trace.length && kindAt(trace, k) !== 'roundBegun'; k++) {
    if (ANTIPODAL.includes(kindAt(trace, k) as string)) count += 1
  }
  return count
}

/** One end of a directed edge as seen from a circle's center: the angle in turns, and whether the edge starts there. */
export interface RingMark {
  readonly angle: number
  readonly isOut: boolean
  readonly other: number
  readonly event: number
}

/** A counter-clockwise arc, in turns. It starts between 0 and 1; `to` may exceed 1. */
export interface RingArc {
  readonly from: number
  readonly to: number
}

export interface Ring {
  readonly marks: readonly RingMark[]
  /** The arcs that no disc of the diagram has touched yet. */
  readonly unused: readonly RingArc[]
}

/** The direction from a circle to a point, in turns, 0 to 1. */
export function turnTo(circle: Circle, x: number, y: number): number {
  const turn = Math.atan2(y - circle.y, x - circle.x) / (2 * Math.PI)
  return turn < 0 ? turn + 1 : turn
}

/** The directed edges and unused arcs around a circle, counter-clockwise. */
export function ringOf(trace: Trace, state: TraceState, id: number, circle: Circle): Ring {
  const marks: RingMark[] = []
  for (const event of state.directedEdges) {
    const { circles, disc } = trace.event(event)
    const [a, b] = circles as [number, number]
    if ((a !== id && b !== id) || disc === undefined) continue
    marks.push({ angle: turnTo(circle, disc.x, disc.y), isOut: a === id, other: a === id ? b : a, event })
  }
  // If both ends lie at one disc, the incoming end comes last because the unused arc begins there.
  marks.sort((s, t) => s.angle - t.angle || Number(t.isOut) - Number(s.isOut))
  const unused: RingArc[] = []
  for (const [k, mark] of marks.entries()) {
    if (mark.isOut) continue
    const next = marks[(k + 1) % marks.length] as RingMark
    if (next.isOut) unused.push({ from: mark.angle, to: next.angle + (next.angle <= mark.angle ? 1 : 0) })
  }
  return { marks, unused }
}

/**
 * The circles that an antipodal disc is tested against: the circles at the nearest directed edges beside its foot
 * points.
 */
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

/** The circles that the disc of a step is tested against. `state` is the state after the step. */
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
