// SPDX-License-Identifier: GPL-3.0-or-later
// The growing phase of the touching disc method: discs in the order of their radii, with the edges that begin and end,
// the discs that are rejected, and the reasons.

import type { Circle, CircleVoronoi, Point, Vertex } from '../../lib/index.ts'
import type { Trace } from '../../lib/wasm/trace.ts'
import { ringOf } from '../../player/discs.ts'
import { FinishedArcs } from '../../player/finished-arcs.ts'
import { colorsOf, coordinatesOf, drawDiscs, footOf, type Kind, list, Pen, type Scene, said } from './scene.ts'

/** The outcome of a disc when its turn comes. */
export type What = 'start' | 'begin' | 'notEmpty' | 'used' | 'stale' | 'vertex' | 'end'

export interface Moment {
  readonly what: What
  /** The disc's first event, and the first event after it. */
  readonly event: number
  readonly end: number
  /** The radius that the discs have reached. */
  readonly r: number
}

const WHAT: Readonly<Record<string, What>> = {
  antipodalDiscAccepted: 'begin',
  antipodalDiscNotEmpty: 'notEmpty',
  antipodalDiscUsed: 'used',
  threeTouchDiscStale: 'stale',
  branchDisc: 'vertex',
}
/** The events that a disc causes. */
const EFFECTS = ['directedEdgePlaced', 'threeTouchDiscFormed', 'segmentFinished', 'directedEdgeDeleted']

interface Grown {
  readonly trace: Trace
  readonly moments: readonly Moment[]
  readonly arcs: FinishedArcs
}

/** The last result. A slider requests the same circles again and again. */
let kept: { readonly key: string; readonly grown: Grown } | undefined

/** Runs the growing phase alone. Every pair of circles is a candidate, so no samples are needed. */
export function grow(circles: readonly Circle[], library: CircleVoronoi): Grown {
  const key = JSON.stringify(circles)
  if (kept?.key === key) return kept.grown
  const trace = library.trace(coordinatesOf(circles), { candidates: 'all-pairs' })
  const moments: Moment[] = []
  for (let k = 0; k < trace.length; k++) {
    const { kind, disc } = trace.event(k)
    const what = WHAT[kind]
    if (what === undefined) continue
    let end = k + 1
    while (end < trace.length && EFFECTS.includes(trace.event(end).kind)) end += 1
    moments.push({ what, event: k, end, r: disc?.r ?? 0 })
  }
  const first = moments[0]
  const last = moments.at(-1)
  const grown = {
    trace,
    moments: [
      { what: 'start' as const, event: first?.event ?? 0, end: first?.event ?? 0, r: 0 },
      ...moments,
      { what: 'end' as const, event: trace.length, end: trace.length, r: 1.35 * (last?.r ?? 0) },
    ],
    arcs: new FinishedArcs(trace),
  }
  kept = { key, grown }
  return grown
}

export const growing: Kind = {
  range: ({ circles }, library) => ({ last: grow(circles, library).moments.length - 1, step: 1 }),

  draw(scene, value, library) {
    const { circles } = scene
    const { trace, moments, arcs } = grow(circles, library)
    // Discs grow between two moments.
    const k = Math.min(Math.floor(value), moments.length - 1)
    const moment = moments[k] as Moment
    const next = moments[k + 1] ?? moment
    const r = moment.r + (value - k) * (next.r - moment.r)
    const isExact = value === k
    const state = trace.at(moment.end)
    const pen = new Pen(scene)
    const circleOf = (id: number) => circles[id]

    if (moment.what !== 'start' || !isExact)
      for (const circle of circles) if (circle.r + r > 0) pen.disc('wave', { ...circle, r: circle.r + r })
    drawDiscs(pen, circles, colorsOf(library.compute(coordinatesOf(circles))))
    pen.segments('border', arcs.of(state.segments, circleOf))
    for (const event of state.directedEdges) {
      const { disc, circles: ids } = trace.event(event)
      const [a, b] = ids.map(circleOf)
      if (disc === undefined || a === undefined || b === undefined) continue
      const front = frontOf(a, b, r)
      if (front !== undefined) pen.segments('border growing', arcBetween(a, b, disc, front)).dot('front', front, 4)
      const isNew = isExact && event >= moment.event
      pen.arrow(isNew ? 'arrow fresh' : 'arrow', footOf(a, disc), footOf(b, disc), 5)
    }
    if (isExact) drawMoment(pen, scene, trace, moment, circleOf)
    return { content: pen.content, told: tellMoment(trace, moment, circles) }
  },
}

function drawMoment(
  pen: Pen,
  { circles }: Scene,
  trace: Trace,
  { what, event, end }: Moment,
  circleOf: (id: number) => Circle | undefined,
): void {
  if (what === 'start' || what === 'end') return
  const { disc, circles: ids } = trace.event(event)
  if (disc === undefined) return
  const touched = what === 'notEmpty' ? ids.slice(0, 2) : ids
  const isGood = what === 'begin' || what === 'vertex'
  pen.disc(isGood ? 'touching good' : 'touching bad', disc)
  for (const id of touched) {
    const circle = circleOf(id)
    if (circle === undefined) continue
    pen.line(isGood ? 'spoke good' : 'spoke bad', disc, footOf(circle, disc))
  }
  if (what === 'notEmpty') {
    const met = circleOf(ids[2] as number)
    if (met !== undefined) pen.disc('met', met)
  }
  if (what === 'used') {
    for (const id of passedAt(trace, event, circles)) {
      const circle = circles[id] as Circle
      pen.dot('passed', footOf(circle, disc), 6).disc('met', circle)
    }
  }
  if (what === 'vertex') {
    pen.dot('vertex', disc, 6)
    for (let k = event; k < end; k++) {
      const told = trace.event(k)
      const [a, b] = told.circles.map((id) => circles[id])
      if (told.kind !== 'directedEdgeDeleted' || told.disc === undefined || a === undefined || b === undefined) continue
      pen.arrow('arrow gone', footOf(a, told.disc), footOf(b, told.disc), 5)
    }
  }
}

/**
 * Returns the circles touching an antipodal disc whose rim the border of other circles has already passed at the foot
 * point.
 */
function passedAt(trace: Trace, event: number, circles: readonly Circle[]): readonly number[] {
  const { disc, circles: ids } = trace.event(event)
  const before = trace.at(event)
  return ids.filter((id) => {
    const circle = circles[id]
    if (circle === undefined || disc === undefined) return false
    const { marks, unused } = ringOf(trace, before, id, circle)
    const turn = Math.atan2(disc.y - circle.y, disc.x - circle.x) / (2 * Math.PI)
    const isFree = unused.some(({ from, to }) => [0, 1, 2].some((k) => turn + k >= from && turn + k <= to))
    return marks.length > 0 && !isFree
  })
}

function circlesIn(ids: readonly number[]): string {
  return `${ids.length === 1 ? 'circle' : 'circles'} ${list(ids)}`
}

/** Describes a moment in words. */
export function tellMoment(trace: Trace, { what, event, end, r }: Moment, circles: readonly Circle[]): string {
  if (what === 'start') return 'The discs wait in a list, the smallest first. Nothing has grown yet.'
  if (what === 'end') {
    const left = trace.at(trace.length).directedEdges.length
    return `The list is empty. The borders of the ${left} directed edges that are left go on forever.`
  }
  const { circles: ids } = trace.event(event)
  const [a = 0, b = 0, c = 0] = ids
  const at = `Radius ${said(r)}: `
  const formed = new Set<string>()
  const begun: string[] = []
  const gone: string[] = []
  for (let k = event; k < end; k++) {
    const told = trace.event(k)
    const name = `${told.circles[0]}→${told.circles[1]}`
    if (told.kind === 'threeTouchDiscFormed') formed.add(list([...told.circles].sort((s, t) => s - t)))
    if (told.kind === 'directedEdgePlaced') begun.push(name)
    if (told.kind === 'directedEdgeDeleted') gone.push(name)
  }
  const joins =
    formed.size === 0
      ? ''
      : ` ${formed.size === 1 ? 'A disc that may touch three circles joins' : 'Discs that may touch three circles join'} the list: ${[...formed].map((name) => `of ${name}`).join('; ')}.`
  switch (what) {
    case 'begin':
      return `${at}the disc between circles ${a} and ${b} is empty. A border begins at its center and grows both ways: directed edges ${list(begun)}.${joins}`
    case 'notEmpty':
      return `${at}circle ${c} reaches into the disc between circles ${a} and ${b}. The disc is thrown away.`
    case 'used':
      return `${at}the disc between circles ${a} and ${b} touches ${circlesIn(passedAt(trace, event, circles))} where another border has already passed. The disc is thrown away.`
    case 'stale':
      return `${at}a directed edge of the disc of circles ${list([...ids].sort((s, t) => s - t))} has already ended. The disc is thrown away.`
    case 'vertex': {
      const names = list([...ids].sort((s, t) => s - t))
      const ends = `${gone.length} borders end there: ${list(gone)}.`
      const next = begun.length === 0 ? '' : ` A new border begins there: ${list(begun)}.`
      return `${at}the disc of circles ${names} is empty. Its center is a vertex. ${ends}${next}${joins}`
    }
  }
}

/** The center of the disc of radius r that touches a and b, on the right of the arrow from a to b. */
export function frontOf(a: Circle, b: Circle, r: number): Vertex | undefined {
  const [dx, dy] = [b.x - a.x, b.y - a.y]
  const d = Math.hypot(dx, dy)
  const [s, t] = [a.r + r, b.r + r]
  const along = (d * d + s * s - t * t) / (2 * d)
  const square = s * s - along * along
  if (d === 0 || square < 0) return undefined
  const aside = Math.sqrt(square)
  return { x: a.x + (along * dx + aside * dy) / d, y: a.y + (along * dy - aside * dx) / d, r }
}

const PIECES = 24

/** The border of a and b between two discs that touch both, as a polyline sampled by radius. */
export function arcBetween(a: Circle, b: Circle, from: Vertex, to: Vertex): number[] {
  const pieces: number[] = []
  let last: Point = from
  for (let k = 1; k <= PIECES; k++) {
    // Squaring the parameter spaces points evenly along the border, because the radius hardly grows near its beginning.
    const next = k === PIECES ? to : (frontOf(a, b, from.r + (to.r - from.r) * (k / PIECES) ** 2) ?? last)
    pieces.push(last.x, last.y, next.x, next.y)
    last = next
  }
  return pieces
}
