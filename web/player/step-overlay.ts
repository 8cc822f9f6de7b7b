// SPDX-License-Identifier: GPL-3.0-or-later
// The overlay after a step: finished parts are faint, current parts are strong.
import type { Circle, Vertex } from '../lib/index.ts'
import type { Trace, TraceState } from '../lib/wasm/trace.ts'
import { boundingBox } from '../view/camera.ts'
import type { OverlayLayer } from '../view/layers.ts'
import { FinishedArcs } from './finished-arcs.ts'
import { kindAt, type Step } from './steps.ts'

/** The overlay's colors as CSS color values. */
export interface Colors {
  readonly past: string
  readonly sample: string
  readonly current: string
  readonly good: string
  readonly bad: string
  readonly edge: string
  readonly ink: string
}

/** The custom properties of the player's style sheet that hold the colors. */
export const PLAYER_COLORS: Colors = {
  past: 'var(--player-past)',
  sample: 'var(--player-sample)',
  current: 'var(--player-current)',
  good: 'var(--player-good)',
  bad: 'var(--player-bad)',
  edge: 'var(--player-edge)',
  ink: 'var(--player-ink)',
}

/** With more circles than this, only the circles of the current step show their numbers. */
const MOST_NUMBERED = 60
/** A circle is smaller than another circle if the ratio of their radii is below this, not only by rounding. */
const SMALLER = 1 - 1e-9
/** Largest size of an arrow head, relative to the extent of all circles. */
const LARGEST_HEAD = 0.02

type CircleOf = (id: number) => Circle | undefined

/** The circles after `end` events: the given circles, then the edited ones. `ids` defaults to 0, 1, and so on. */
export function circlesAt(trace: Trace, given: Float64Array, state: TraceState, ids?: Int32Array): Map<number, Circle> {
  const circles = new Map<number, Circle>()
  for (let k = 0; 3 * k < given.length; k++) {
    const [x = 0, y = 0, r = 0] = given.subarray(3 * k, 3 * k + 3)
    circles.set(ids?.[k] ?? k, { x, y, r })
  }
  for (const k of state.edits) {
    const { kind, circles: ids, disc } = trace.event(k)
    const id = ids[0] as number
    if (kind === 'circleRemoved') circles.delete(id)
    else if (disc !== undefined) circles.set(id, disc)
  }
  return circles
}

/** `tested` are the circles that the current disc is tested against. */
export function overlayOf(
  trace: Trace,
  step: Step,
  state: TraceState,
  tested: readonly number[],
  circles: ReadonlyMap<number, Circle>,
  colors: Colors,
): readonly OverlayLayer[] {
  const circleOf = (id: number) => circles.get(id)
  const head = LARGEST_HEAD * extentOf(circles)
  const layers: OverlayLayer[] = []
  const add = (id: string, color: string, layer: Omit<OverlayLayer, 'id' | 'color'>) =>
    layers.push({ id, color, ...layer })
  const joined = (events: Int32Array) => segmentsOf(events, (k) => trace.event(k).circles, circleOf)
  const { line } = step

  if (line === 'centers' || line === 'flipCenters')
    add('centers', colors.current, { segments: joined(state.centerEdges) })
  if (line === 'angles') {
    add('centers', colors.past, { segments: joined(state.centerEdges) })
    add('rays', colors.current, { segments: raysOf(trace, step.end, circleOf) })
  }
  if (['samples', 'sampleGraph', 'pairs'].includes(line)) {
    const points = pointsOf(trace, state.samples)
    if (line === 'samples') add('centers', colors.past, { segments: joined(state.centerEdges) })
    else {
      const graph = segmentsOf(
        state.sampleEdges,
        (k) => trace.event(k).numbers,
        (sample) => {
          const disc = trace.event(state.samples[sample] as number).disc
          return disc && { ...disc, r: 0 }
        },
      )
      add('sampleGraph', line === 'pairs' ? colors.past : colors.sample, { segments: graph })
    }
    add('rims', colors.past, { discs: sampledRims(trace, state.samples, circleOf), dash: [3, 3] })
    add('samples', line === 'pairs' ? colors.past : colors.sample, { points })
    if (line === 'pairs') add('pairs', colors.current, { segments: gapsOf(trace, state.pairs, circleOf) })
  }

  add('segments', colors.edge, { segments: finishedSegments(trace, state, step, circleOf), width: 2 })
  const fresh = new Set<number>()
  if (line === 'place' || line === 'placeThird') for (let k = step.event; k < step.end; k++) fresh.add(k)
  const old = state.directedEdges.filter((k) => !fresh.has(k))
  add('directedEdges', colors.past, { segments: arrowsOf(trace, old, circleOf, head), width: 1.25 })

  if (state.faces.length > 0) addFaces(trace, step, state, circleOf, colors, add)
  addDisc(trace, step, tested, circleOf, colors, add)
  const placed = Int32Array.from(fresh).filter((k) => kindAt(trace, k) === 'directedEdgePlaced')
  add('placed', colors.good, { segments: arrowsOf(trace, placed, circleOf, head), width: 2.5 })
  if (line === 'finish') {
    const gone = Int32Array.from({ length: step.end - step.event }, (_, i) => step.event + i)
    const deleted = gone.filter((k) => kindAt(trace, k) === 'directedEdgeDeleted')
    const ended = gone.filter((k) => kindAt(trace, k) === 'segmentFinished')
    add('deleted', colors.bad, { segments: arrowsOf(trace, deleted, circleOf, head), width: 1.25, dash: [4, 4] })
    add('finished', colors.current, { segments: segmentsOfFinished(trace, ended, circleOf), width: 3 })
  }
  const about = step.event < trace.length && step.end <= step.event + 1 ? trace.event(step.event).circles : []
  const named = [...circles.keys()].filter(
    (id) => circles.size <= MOST_NUMBERED || about.includes(id) || tested.includes(id),
  )
  add('numbers', colors.ink, {
    points: Float64Array.from(named.flatMap((id) => [circles.get(id)?.x ?? 0, circles.get(id)?.y ?? 0])),
    numbers: Int32Array.from(named),
  })
  return layers.filter(({ points, segments, discs }) =>
    [points, segments, discs].some((list) => (list?.length ?? 0) > 0),
  )
}

type Add = (id: string, color: string, layer: Omit<OverlayLayer, 'id' | 'color'>) => void

function addDisc(
  trace: Trace,
  step: Step,
  tested: readonly number[],
  circleOf: CircleOf,
  colors: Colors,
  add: Add,
): void {
  const rims = (ids: readonly number[]) => {
    const circles = ids.map(circleOf).filter((circle) => circle !== undefined)
    return Float64Array.from(circles.flatMap(({ x, y, r }) => [x, y, r]))
  }
  if (step.event >= trace.length) return
  const event = trace.event(step.event)
  const { disc, circles } = event
  const discs = (list: readonly (Vertex | undefined)[]) =>
    Float64Array.from(list.flatMap((item) => (item === undefined ? [] : [item.x, item.y, item.r])))
  switch (step.line) {
    case 'take':
      add('tested', colors.sample, { discs: rims(tested), width: 2.5 })
      add('disc', colors.current, { discs: discs([disc]), width: 2, fill: 0.2, points: feetOf(event, circleOf) })
      break
    case 'used':
    case 'notEmpty':
    case 'stale':
      if (step.line === 'notEmpty') add('met', colors.bad, { discs: rims(circles.slice(2)), width: 3 })
      add('disc', colors.bad, {
        discs: discs([disc]),
        width: 2,
        fill: 0.12,
        dash: [5, 4],
        points: feetOf(event, circleOf),
      })
      break
    case 'place':
    case 'branch':
      add('disc', colors.good, { discs: discs([disc]), width: 2, fill: 0.2, points: feetOf(event, circleOf) })
      if (step.line === 'branch' && disc !== undefined) {
        add('vertex', colors.current, { points: Float64Array.of(disc.x, disc.y), dot: 5 })
      }
      break
    case 'form':
    case 'formThird': {
      const formed = []
      for (let k = step.event; k < step.end; k++) formed.push(trace.event(k).disc)
      add('formed', colors.current, { discs: discs(formed), width: 1.25, dash: [3, 3] })
      break
    }
    case 'flipTest':
    case 'editTest': {
      const ids = event.kind === 'circleShrunk' ? [] : circles.slice(2)
      add('met', colors.bad, { discs: rims(ids), width: 3 })
      add('disc', colors.current, { discs: discs([disc]), width: 2, fill: 0.15 })
      if (event.kind !== 'circleShrunk') {
        const edge = segmentsOf(Int32Array.of(step.event), () => circles.slice(0, 2), circleOf)
        add('edge', colors.bad, { segments: edge, width: 3 })
      }
      break
    }
    case 'edit':
      add('edited', colors.current, { discs: discs([disc]), width: 3 })
      break
  }
}

/** Adds the triangulation's edges and the diagram's vertices. */
function addFaces(trace: Trace, step: Step, state: TraceState, circleOf: CircleOf, colors: Colors, add: Add): void {
  const seen = new Set<string>()
  const segments: number[] = []
  const fresh: number[] = []
  const points: number[] = []
  const discs: number[] = []
  for (const k of state.faces) {
    const { circles, disc } = trace.event(k)
    const isFresh = k >= step.event && k < step.end
    if (disc !== undefined && circles.length === 3) {
      points.push(disc.x, disc.y)
      if (step.line === 'flipDiscs') discs.push(disc.x, disc.y, disc.r)
    }
    for (const [i, a] of circles.entries()) {
      const b = circles[(i + 1) % circles.length] as number
      const key = a < b ? `${a} ${b}` : `${b} ${a}`
      const [from, to] = [circleOf(a), circleOf(b)]
      if (from === undefined || to === undefined || (seen.has(key) && !isFresh)) continue
      ;(isFresh && isNew(trace, step, a, b) ? fresh : segments).push(from.x, from.y, to.x, to.y)
      seen.add(key)
    }
  }
  add('triangles', colors.past, { segments: Float64Array.from(segments) })
  add('faceDiscs', colors.past, { discs: Float64Array.from(discs) })
  add('vertices', colors.edge, { points: Float64Array.from(points) })
  add('fresh', colors.good, { segments: Float64Array.from(fresh), width: 3 })
}

/** Whether an edge of a new triangle belonged to none of the removed triangles. */
function isNew(trace: Trace, step: Step, a: number, b: number): boolean {
  if (step.line !== 'flip' && step.line !== 'editFlip') return false
  for (let k = step.event; k < step.end; k++) {
    const { kind, circles } = trace.event(k)
    if (kind === 'faceRemoved' && circles.includes(a) && circles.includes(b)) return false
  }
  return true
}

function segmentsOf(
  events: Int32Array,
  ends: (event: number) => readonly number[],
  placeOf: (id: number) => Circle | undefined,
): Float64Array {
  const segments: number[] = []
  for (const k of events) {
    const [a, b] = ends(k)
    const [from, to] = [placeOf(a as number), placeOf(b as number)]
    if (from !== undefined && to !== undefined) segments.push(from.x, from.y, to.x, to.y)
  }
  return Float64Array.from(segments)
}

function pointsOf(trace: Trace, events: Int32Array): Float64Array {
  return Float64Array.from(
    Array.from(events).flatMap((k) => {
      const { disc } = trace.event(k)
      return disc === undefined ? [] : [disc.x, disc.y]
    }),
  )
}

/** Returns the circles on which the samples lie, if they are smaller than the given circles. */
function sampledRims(trace: Trace, samples: Int32Array, circleOf: CircleOf): Float64Array {
  const rims = new Map<number, readonly number[]>()
  for (const k of samples) {
    const { disc, circles } = trace.event(k)
    const id = circles[0] as number
    const circle = circleOf(id)
    if (disc === undefined || circle === undefined || rims.has(id)) continue
    const radius = Math.hypot(disc.x - circle.x, disc.y - circle.y)
    rims.set(id, radius < SMALLER * circle.r ? [circle.x, circle.y, radius] : [])
  }
  return Float64Array.from([...rims.values()].flat())
}

/** Rays from each center to the samples that are taken next. */
function raysOf(trace: Trace, from: number, circleOf: CircleOf): Float64Array {
  const rays: number[] = []
  for (let k = from; k < trace.length && kindAt(trace, k) === 'sampleTaken'; k++) {
    const { disc, circles } = trace.event(k)
    const circle = circleOf(circles[0] as number)
    if (disc !== undefined && circle !== undefined) rays.push(circle.x, circle.y, disc.x, disc.y)
  }
  return Float64Array.from(rays)
}

/** Connects the rims of each pair across the gap between them. */
function gapsOf(trace: Trace, events: Int32Array, circleOf: CircleOf): Float64Array {
  const gaps: number[] = []
  for (const k of events) {
    const [a, b] = trace.event(k).circles.map(circleOf)
    if (a === undefined || b === undefined) continue
    const [dx, dy] = [b.x - a.x, b.y - a.y]
    const length = Math.hypot(dx, dy)
    if (length === 0) continue
    const [ux, uy] = [dx / length, dy / length]
    gaps.push(a.x + a.r * ux, a.y + a.r * uy, b.x - b.r * ux, b.y - b.r * uy)
  }
  return Float64Array.from(gaps)
}

/** The point where a disc touches a circle. */
function footOf(disc: Vertex, circle: Circle): readonly [number, number] {
  const [dx, dy] = [disc.x - circle.x, disc.y - circle.y]
  const length = Math.hypot(dx, dy)
  return length === 0
    ? [circle.x, circle.y]
    : [circle.x + (dx / length) * circle.r, circle.y + (dy / length) * circle.r]
}

function feetOf({ kind, disc, circles }: ReturnType<Trace['event']>, circleOf: CircleOf): Float64Array {
  const touched = kind === 'antipodalDiscNotEmpty' ? circles.slice(0, 2) : circles
  return Float64Array.from(
    touched.flatMap((id) => {
      const circle = circleOf(id)
      return circle === undefined || disc === undefined ? [] : [...footOf(disc, circle)]
    }),
  )
}

function extentOf(circles: ReadonlyMap<number, Circle>): number {
  const { minX, minY, maxX, maxY } = boundingBox(
    Float64Array.from([...circles.values()].flatMap(({ x, y, r }) => [x, y, r])),
  )
  return Math.max(maxX - minX, maxY - minY)
}

/** The size of an arrow head, relative to the arrow's length. */
const HEAD = 0.3

/**
 * Draws directed edges as arrows between the foot points of their R_min discs, offset to the right, the side of their
 * segments.
 */
function arrowsOf(trace: Trace, events: Int32Array, circleOf: CircleOf, largest: number): Float64Array {
  const arrows: number[] = []
  for (const k of events) {
    const { disc, circles } = trace.event(k)
    const [a, b] = circles.map(circleOf)
    if (disc === undefined || a === undefined || b === undefined) continue
    const from = footOf(disc, a)
    const to = footOf(disc, b)
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]]
    if (Math.hypot(dx, dy) === 0) [dx, dy] = [(b.x - a.x) / 1e3, (b.y - a.y) / 1e3]
    const length = Math.hypot(dx, dy)
    const size = Math.min(HEAD * length, largest)
    const [ux, uy] = [(dx / length) * size, (dy / length) * size]
    const start = [from[0] + uy * 0.5, from[1] - ux * 0.5] as const
    const tip = [start[0] + dx, start[1] + dy] as const
    arrows.push(...start, ...tip)
    arrows.push(...tip, tip[0] - ux + uy / 2, tip[1] - uy - ux / 2)
    arrows.push(...tip, tip[0] - ux - uy / 2, tip[1] - uy + ux / 2)
  }
  return Float64Array.from(arrows)
}

function finishedSegments(trace: Trace, state: TraceState, step: Step, circleOf: CircleOf): Float64Array {
  const before = step.line === 'finish' ? state.segments.filter((k) => k < step.event) : state.segments
  return segmentsOfFinished(trace, before, circleOf)
}

/** Caches the arcs of the traces that are being played. */
const arcsOf = new WeakMap<Trace, FinishedArcs>()

/** The bisector arcs from R_min discs to R_max discs, as polylines. */
function segmentsOfFinished(trace: Trace, events: Int32Array, circleOf: CircleOf): Float64Array {
  const arcs = arcsOf.get(trace) ?? new FinishedArcs(trace)
  arcsOf.set(trace, arcs)
  return arcs.of(events, circleOf)
}
