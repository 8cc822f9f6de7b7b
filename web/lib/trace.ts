// SPDX-License-Identifier: GPL-3.0-or-later
import { checkNumber, refuseArgument } from './check.ts'
import type { Diagram } from './diagram.ts'
import { at, type Float64s, type Int32s, NONE, type Vertex } from './diagram-data.ts'
import type { Options } from './options.ts'

/**
 * The kinds of events of the touching disc method, in the order of their numbers in `Trace.kinds`: candidates (paper,
 * sections 4.1 and 5), then the event loop (Algorithms 2 and 3).
 *
 * - `roundBegun`: all begins anew (the option `resample`); samples, directed edges and vertices are counted anew. The first
 *   event is one;
 * - `centersJoined`: an edge of the Delaunay graph of the visible circles' centres;
 * - `sampleTaken`: `disc` is the point, of radius 0, on its circle less the smallest of all radii;
 * - `samplesJoined`: an edge of the Delaunay graph of the samples, of which `numbers` are two;
 * - `pairFound`: two circles get an antipodal disc;
 * - `antipodalDiscAccepted`: it is empty, and its two directed edges follow; `antipodalDiscUsed`: a footpoint lies on an arc
 *   that the diagram has used already; `antipodalDiscNotEmpty`: it meets the third circle;
 * - `threeTouchDiscFormed`: put into the queue by the two directed edges `numbers`; `threeTouchDiscStale`: discarded, as these
 *   are gone or no longer adjacent; `branchDisc`: it is empty, and makes a vertex;
 * - `directedEdgePlaced`, `directedEdgeDeleted`: from the first circle to the second; `disc` is its disc of R_min;
 * - `segmentFinished`: the Voronoi segment of a directed edge, which ends at a vertex; `disc` is its disc of R_max.
 *
 * @category Tracing
 * @example
 * TRACE_KINDS[0] // 'roundBegun'
 */
export const TRACE_KINDS = [
  'roundBegun',
  'centersJoined',
  'sampleTaken',
  'samplesJoined',
  'pairFound',
  'antipodalDiscAccepted',
  'antipodalDiscUsed',
  'antipodalDiscNotEmpty',
  'threeTouchDiscFormed',
  'threeTouchDiscStale',
  'branchDisc',
  'directedEdgePlaced',
  'directedEdgeDeleted',
  'segmentFinished',
] as const

/**
 * One of `TRACE_KINDS`.
 *
 * @category Tracing
 */
export type TraceKind = (typeof TRACE_KINDS)[number]

/**
 * Those of `compute`; the method is `touching-disc`.
 *
 * @category Tracing
 */
export interface TraceOptions extends Omit<Options, 'method'> {
  readonly method?: 'touching-disc' | undefined
}

/**
 * The events field by field.
 *
 * @category Tracing
 */
export interface TraceArrays {
  /** Of each event its index in `TRACE_KINDS`. */
  readonly kinds: Uint8Array
  /** Three of each: x, y and r of a disc; 0 where there is none. */
  readonly discs: Float64s
  /** Three of each, `NONE` where there is none; of a three-touch disc clockwise, as the directed edges 0 to 1 and 1 to 2. */
  readonly circles: Int32s
  /** Of each the vertex that is made or where a segment ends, or `NONE`. */
  readonly vertices: Int32s
  /** Two of each, `NONE` where there is none: samples, directed edges or a round, counted from 0. */
  readonly numbers: Int32s
}

/**
 * What happened.
 *
 * @category Tracing
 */
export interface TraceEvent {
  readonly kind: TraceKind
  readonly disc: Vertex | undefined
  readonly circles: readonly number[]
  readonly vertex: number | undefined
  readonly numbers: readonly number[]
}

/**
 * What is there after some events, each as a list of events by their indices.
 *
 * @category Tracing
 */
export interface TraceState {
  /** The event that began the round. */
  readonly round: number
  /** The edges of the centres' Delaunay graph. */
  readonly centerEdges: Int32Array
  readonly samples: Int32Array
  readonly sampleEdges: Int32Array
  readonly pairs: Int32Array
  /** Antipodal discs that were accepted. */
  readonly antipodalDiscs: Int32Array
  readonly branchDiscs: Int32Array
  /** Segments that are finished. */
  readonly segments: Int32Array
  /** The placings of directed edges that are there. */
  readonly directedEdges: Int32Array
  /** The three-touch discs that wait, the next one first: by radius, then by their directed edges. */
  readonly queue: Int32Array
}

/** What changes back and forth, and the event before which it is so. */
interface Keyframe {
  readonly event: number
  readonly round: number
  readonly directedEdges: Int32Array
  readonly queue: Int32Array
}

const kind = (name: TraceKind) => TRACE_KINDS.indexOf(name)
const ROUND_BEGUN = kind('roundBegun')
const FORMED = kind('threeTouchDiscFormed')
const STALE = kind('threeTouchDiscStale')
const BRANCH = kind('branchDisc')
const PLACED = kind('directedEdgePlaced')
const DELETED = kind('directedEdgeDeleted')
const WITHOUT_DISC = ['roundBegun', 'centersJoined', 'samplesJoined', 'pairFound'].map((name) =>
  kind(name as TraceKind),
)

/** More than there are directed edges in a trace that memory holds, and its square is a whole number. */
const EDGES = 2 ** 26

/**
 * What the touching disc method did, event by event, and the diagram that it made, which may be wrong where its certificate
 * says so.
 *
 * @category Tracing
 * @example
 * const trace = library.trace([[0, 0, 1], [6, 0, 1], [0, 8, 1]])
 * trace.event(trace.length - 1).kind // 'antipodalDiscUsed'
 * trace.at(trace.length).directedEdges.length // 3
 * trace.at(trace.length).branchDiscs.length // 1
 */
export class Trace implements TraceArrays {
  readonly diagram: Diagram
  readonly kinds: Uint8Array
  readonly discs: Float64s
  readonly circles: Int32s
  readonly vertices: Int32s
  readonly numbers: Int32s
  readonly #keyframes: Keyframe[] = [{ event: 0, round: 0, directedEdges: new Int32Array(0), queue: new Int32Array(0) }]
  readonly #spacing: number

  /** Of a diagram and the events that led to it, which are not copied. */
  constructor(diagram: Diagram, { kinds, discs, circles, vertices, numbers }: TraceArrays) {
    this.diagram = diagram
    this.kinds = kinds
    this.discs = discs
    this.circles = circles
    this.vertices = vertices
    this.numbers = numbers
    // As many keyframes as events between two of them, but for small factors.
    this.#spacing = Math.max(1024, 16 * Math.ceil(Math.sqrt(kinds.length)))
  }

  /** How many events there are. */
  get length(): number {
    return this.kinds.length
  }

  /** @throws CircleVoronoiError `badArgument`, if there is no such event */
  event(k: number): TraceEvent {
    checkNumber(k, 'event', 'the index of an event')
    if (!(Number.isInteger(k) && 0 <= k && k < this.length)) {
      refuseArgument(`event: there is no event ${k}; the trace has ${this.length}.`)
    }
    const number = at(this.kinds, k)
    const vertex = at(this.vertices, k)
    const [x, y, r] = this.discs.subarray(3 * k, 3 * k + 3) as unknown as [number, number, number]
    return {
      kind: TRACE_KINDS[number] as TraceKind,
      disc: WITHOUT_DISC.includes(number) ? undefined : { x, y, r },
      circles: [...this.circles.subarray(3 * k, 3 * k + 3)].filter((circle) => circle !== NONE),
      vertex: vertex === NONE ? undefined : vertex,
      numbers: [...this.numbers.subarray(2 * k, 2 * k + 2)].filter((item) => item !== NONE),
    }
  }

  /**
   * What is there after the first `k` events, `k` from 0 to `length`: in the time that it takes to look once at each kind of
   * event so far, as the rest is kept now and then.
   *
   * @throws CircleVoronoiError `badArgument`, if there are not so many events
   */
  at(k: number): TraceState {
    checkNumber(k, 'at', 'the number of events')
    if (!(Number.isInteger(k) && 0 <= k && k <= this.length)) {
      refuseArgument(`at takes a number of events from 0 to ${this.length}, not ${k}.`)
    }
    const { round, directedEdges, queue } = this.#replayedTo(k)
    const all = (name: TraceKind) => this.#eventsOf(kind(name), round, k)
    return {
      round,
      centerEdges: all('centersJoined'),
      samples: all('sampleTaken'),
      sampleEdges: all('samplesJoined'),
      pairs: all('pairFound'),
      antipodalDiscs: all('antipodalDiscAccepted'),
      branchDiscs: all('branchDisc'),
      segments: all('segmentFinished'),
      directedEdges,
      queue: queue.sort((a, b) => this.#compareDiscs(a, b)),
    }
  }

  #eventsOf(kind: number, from: number, to: number): Int32Array {
    let count = 0
    for (let k = from; k < to; k++) if (this.kinds[k] === kind) count += 1
    const events = new Int32Array(count)
    for (let k = to - 1; count > 0; k--) if (this.kinds[k] === kind) events[--count] = k
    return events
  }

  /** As the queue of the method serves them. */
  #compareDiscs(a: number, b: number): number {
    const { discs, numbers } = this
    return (
      at(discs, 3 * a + 2) - at(discs, 3 * b + 2) ||
      at(numbers, 2 * a) - at(numbers, 2 * b) ||
      at(numbers, 2 * a + 1) - at(numbers, 2 * b + 1)
    )
  }

  #replayedTo(end: number): Keyframe {
    const spacing = this.#spacing
    const known = Math.min(Math.floor(end / spacing), this.#keyframes.length - 1)
    const { event, round, directedEdges, queue } = this.#keyframes[known] as Keyframe
    const replay = new Replay(this, round, directedEdges, queue)
    for (let k = event; k < end; k++) {
      if (k > event && k % spacing === 0) this.#keyframes[k / spacing] = replay.keyframe(k)
      replay.step(k)
    }
    return replay.keyframe(end)
  }
}

/** The directed edges that are there and the discs that wait, while events happen. */
class Replay {
  readonly #trace: TraceArrays
  #round: number
  /** Events by directed edges, and by pairs of them. */
  readonly #placed = new Map<number, number>()
  readonly #formed = new Map<number, number>()

  constructor(trace: TraceArrays, round: number, placed: Int32Array, formed: Int32Array) {
    this.#trace = trace
    this.#round = round
    for (const k of placed) this.#placed.set(this.#edgeOf(k), k)
    for (const k of formed) this.#formed.set(this.#edgesOf(k), k)
  }

  step(k: number): void {
    switch (this.#trace.kinds[k]) {
      case ROUND_BEGUN:
        this.#round = k
        this.#placed.clear()
        this.#formed.clear()
        break
      case PLACED:
        this.#placed.set(this.#edgeOf(k), k)
        break
      case DELETED:
        this.#placed.delete(this.#edgeOf(k))
        break
      case FORMED:
        this.#formed.set(this.#edgesOf(k), k)
        break
      case STALE:
      case BRANCH:
        this.#formed.delete(this.#edgesOf(k))
        break
    }
  }

  keyframe(event: number): Keyframe {
    const [directedEdges, queue] = [this.#placed, this.#formed].map((events) => Int32Array.from(events.values()))
    return { event, round: this.#round, directedEdges: directedEdges as Int32Array, queue: queue as Int32Array }
  }

  #edgeOf(k: number): number {
    return at(this.#trace.numbers, 2 * k)
  }

  #edgesOf(k: number): number {
    return EDGES * at(this.#trace.numbers, 2 * k) + at(this.#trace.numbers, 2 * k + 1)
  }
}
