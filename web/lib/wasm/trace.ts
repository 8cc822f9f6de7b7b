// SPDX-License-Identifier: GPL-3.0-or-later
import { checkNumber, refuseInput } from '../base/check.ts'
import { at, NONE } from '../base/diagram-data.ts'
import type { Float64s, Int32s, Vertex } from '../base/types.ts'
import type { Diagram } from '../diagram/diagram.ts'
import type { Edit } from './editor.ts'
import type { Options } from './options.ts'

/**
 * The kinds of events, in the order of their numbers in `Trace.kinds`.
 *
 * The touching disc method first reports the candidates (paper, sections 4.1 and 5), then the event loop (Algorithms 2
 * and 3):
 *
 * - `roundBegun`: everything starts again, including the counts. The first event is of this kind; the option `resample`
 *   may add further rounds;
 * - `centersJoined`: an edge of the Delaunay graph of the visible circles' centers;
 * - `sampleTaken`: `disc` is the point, with radius 0, on its circle, which is shrunk by the smallest of all radii;
 * - `samplesJoined`: an edge of the Delaunay graph between the two samples `numbers`;
 * - `pairFound`: two circles get an antipodal disc;
 * - `antipodalDiscAccepted`: the disc is empty, and its two directed edges follow; `antipodalDiscUsed`: rejected,
 *   because a footpoint lies on an arc that the diagram already uses; `antipodalDiscNotEmpty`: rejected, because the
 *   disc meets the third circle;
 * - `threeTouchDiscFormed`: the two directed edges `numbers` put a disc into the queue; `threeTouchDiscStale`: the disc
 *   is discarded, because these edges are gone or no longer adjacent; `branchDisc`: the disc is empty and makes a
 *   vertex;
 * - `directedEdgePlaced`, `directedEdgeDeleted`: from the first circle to the second; `disc` is its disc of R_min;
 * - `segmentFinished`: the Voronoi segment of a directed edge, which ends at a vertex; `disc` is its disc of R_max.
 *
 * Flips and edits change the triangulation that is dual to the diagram. They first report all faces. For each change
 * they report its reason, if it can be named, then the removed faces and the new faces. The remaining faces belong to
 * the diagram:
 *
 * - `faceMade`, `faceRemoved`: a face of three circles, which is a vertex of the diagram, with the disc that touches
 *   them, if it exists; or a face of two circles, which is an unbounded end. `numbers` is its number, which a later
 *   face may reuse;
 * - `discNotEmpty`: the disc of a face meets or touches `circles[2]`, so the edge between the first two circles is
 *   flipped; `discMissing`: no disc touches the three circles of a face, so the edge between the first two is flipped;
 *   `tangentNotClear`: the tangent line of two neighbors on the hull meets the third circle; `hullNotConvex`: the first
 *   circle lies within the tangent line of the others, its neighbors on the hull, and leaves the hull;
 * - `circleInserted`, `circleRemoved`, `circleReplaced`: an edit of the first circle, given by its id; `disc` is the
 *   circle; `circleShrunk`: during its removal, the circle has shrunk to `disc`, where it touches a disc of its
 *   neighbors.
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
  'faceMade',
  'faceRemoved',
  'discNotEmpty',
  'discMissing',
  'tangentNotClear',
  'hullNotConvex',
  'circleInserted',
  'circleRemoved',
  'circleReplaced',
  'circleShrunk',
] as const

/**
 * One of `TRACE_KINDS`.
 *
 * @category Tracing
 */
export type TraceKind = (typeof TRACE_KINDS)[number]

/**
 * Options of `trace`: the options of `compute`, with `touching-disc` as the default method, or a list of edits.
 *
 * @category Tracing
 */
export interface TraceOptions extends Options {
  /**
   * Edits to the diagram of `circles`, in which circle i has the id i. The only other option that they can be combined
   * with is `weights`.
   */
  readonly edits?: Iterable<Edit> | undefined
}

/**
 * The events as arrays, one for each field.
 *
 * @category Tracing
 */
export interface TraceArrays {
  /** The kind of each event, as an index in `TRACE_KINDS`. */
  readonly kinds: Uint8Array
  /** Three numbers for each event: x, y and r of a disc; 0 or NaN if the event has none. */
  readonly discs: Float64s
  /**
   * Three circles for each event, `NONE` if it has fewer. The circles of a three-touch disc are clockwise, like the
   * directed edges from the first to the second and from the second to the third.
   */
  readonly circles: Int32s
  /** For each event, the vertex that it makes or where its segment ends; otherwise `NONE`. */
  readonly vertices: Int32s
  /** Two numbers for each event, `NONE` if it has fewer: samples, directed edges, a face or a round, counted from 0. */
  readonly numbers: Int32s
}

/**
 * One event.
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
 * The state after some events. Each list contains indices of events.
 *
 * @category Tracing
 */
export interface TraceState {
  /** The event that began the round. */
  readonly round: number
  /** The edges of the Delaunay graph of the centers. */
  readonly centerEdges: Int32Array
  readonly samples: Int32Array
  readonly sampleEdges: Int32Array
  readonly pairs: Int32Array
  /** Antipodal discs that were accepted. */
  readonly antipodalDiscs: Int32Array
  readonly branchDiscs: Int32Array
  /** Finished segments. */
  readonly segments: Int32Array
  /** The events that placed the current directed edges. */
  readonly directedEdges: Int32Array
  /** The three-touch discs in the queue, the next one first: sorted by radius, then by their directed edges. */
  readonly queue: Int32Array
  /** The events that made the current faces. */
  readonly faces: Int32Array
  /** The edits in all earlier rounds. */
  readonly edits: Int32Array
}

/** The state before `event`, with only the lists that may shrink. */
interface Keyframe {
  readonly event: number
  readonly round: number
  readonly directedEdges: Int32Array
  readonly queue: Int32Array
  readonly faces: Int32Array
}

const kind = (name: TraceKind) => TRACE_KINDS.indexOf(name)
const ROUND_BEGUN = kind('roundBegun')
const FORMED = kind('threeTouchDiscFormed')
const STALE = kind('threeTouchDiscStale')
const BRANCH = kind('branchDisc')
const PLACED = kind('directedEdgePlaced')
const DELETED = kind('directedEdgeDeleted')
const MADE = kind('faceMade')
const REMOVED = kind('faceRemoved')
const EDITS = [kind('circleInserted'), kind('circleRemoved'), kind('circleReplaced')]
const WITHOUT_DISC = ['roundBegun', 'centersJoined', 'samplesJoined', 'pairFound'].map((name) =>
  kind(name as TraceKind),
)

/** More than the number of directed edges in any trace that fits into memory. Its square is an exact whole number. */
const EDGES = 2 ** 26

/**
 * The events of a construction, and the resulting diagram, which may be wrong if its certificate says so.
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
  readonly #keyframes: Keyframe[] = [
    { event: 0, round: 0, directedEdges: new Int32Array(0), queue: new Int32Array(0), faces: new Int32Array(0) },
  ]
  readonly #spacing: number

  /** Combines a diagram with the events that led to it, which are not copied. */
  constructor(diagram: Diagram, { kinds, discs, circles, vertices, numbers }: TraceArrays) {
    this.diagram = diagram
    this.kinds = kinds
    this.discs = discs
    this.circles = circles
    this.vertices = vertices
    this.numbers = numbers
    // The number of keyframes is about the number of events between two keyframes.
    this.#spacing = Math.max(1024, 16 * Math.ceil(Math.sqrt(kinds.length)))
  }

  /** The number of events. */
  get length(): number {
    return this.kinds.length
  }

  /**
   * Returns event `k`, counted from 0 in the order in which the construction makes the events.
   *
   * @throws CircleVoronoiError `badInput`, if there is no such event
   */
  event(k: number): TraceEvent {
    checkNumber(k, 'event', 'the index of an event')
    if (!(Number.isInteger(k) && 0 <= k && k < this.length)) {
      refuseInput(`event: there is no event ${k}; the trace has ${this.length}.`)
    }
    const number = at(this.kinds, k)
    const vertex = at(this.vertices, k)
    const r = at(this.discs, 3 * k + 2)
    const hasDisc = !WITHOUT_DISC.includes(number) && !Number.isNaN(r)
    return {
      kind: TRACE_KINDS[number] as TraceKind,
      disc: hasDisc ? { x: at(this.discs, 3 * k), y: at(this.discs, 3 * k + 1), r } : undefined,
      circles: presentValues(this.circles, 3 * k, 3),
      vertex: vertex === NONE ? undefined : vertex,
      numbers: presentValues(this.numbers, 2 * k, 2),
    }
  }

  /**
   * Returns the state after the first `k` events, with `k` from 0 to `length`. The time is linear in `k`, because
   * snapshots of the state are kept at intervals.
   *
   * @throws CircleVoronoiError `badInput`, if `k` is not from 0 to `length`
   */
  at(k: number): TraceState {
    checkNumber(k, 'at', 'the number of events')
    if (!(Number.isInteger(k) && 0 <= k && k <= this.length)) {
      refuseInput(`at takes a number of events from 0 to ${this.length}, not ${k}.`)
    }
    const { round, directedEdges, queue, faces } = this.#replayedTo(k)
    const events = this.#eventsByKind(round, k)
    const all = (name: TraceKind) => events[kind(name)] as Int32Array
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
      faces,
      edits: this.#editsBefore(k),
    }
  }

  #editsBefore(end: number): Int32Array {
    const edits: number[] = []
    for (let k = 0; k < end; k++) if (EDITS.includes(at(this.kinds, k))) edits.push(k)
    return Int32Array.from(edits)
  }

  #eventsByKind(from: number, to: number): Int32Array[] {
    const counts = new Int32Array(TRACE_KINDS.length)
    for (let k = from; k < to; k++) counts[at(this.kinds, k)] = at(counts, at(this.kinds, k)) + 1
    const events = Array.from(counts, (count) => new Int32Array(count))
    for (let k = to - 1; k >= from; k--) {
      const kind = at(this.kinds, k)
      const last = at(counts, kind) - 1
      counts[kind] = last
      ;(events[kind] as Int32Array)[last] = k
    }
    return events
  }

  /** Compares discs by their order in the queue of the method. */
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
    const keyframe = this.#keyframes[known] as Keyframe
    const { event } = keyframe
    const replay = new Replay(this, keyframe)
    for (let k = event; k < end; k++) {
      if (k > event && k % spacing === 0) this.#keyframes[k / spacing] = replay.keyframe(k)
      replay.step(k)
    }
    return replay.keyframe(end)
  }
}

/**
 * Returns the values in a range of a list except `NONE`. Players request many events, and a copy of the range would
 * take several times as long.
 */
function presentValues(list: Int32s, first: number, count: number): number[] {
  const numbers: number[] = []
  for (let k = first; k < first + count; k++) {
    const number = at(list, k)
    if (number !== NONE) numbers.push(number)
  }
  return numbers
}

/** Replays events and keeps the current directed edges, faces and queued discs. */
class Replay {
  readonly #trace: TraceArrays
  #round: number
  /** The event that placed each directed edge. */
  readonly #placed = new Map<number, number>()
  readonly #formed = new Map<number, number>()
  /** The event that made each face. */
  readonly #made = new Map<number, number>()

  constructor(trace: TraceArrays, { round, directedEdges, queue, faces }: Keyframe) {
    this.#trace = trace
    this.#round = round
    for (const k of directedEdges) this.#placed.set(this.#numberOf(k), k)
    for (const k of queue) this.#formed.set(this.#edgesOf(k), k)
    for (const k of faces) this.#made.set(this.#numberOf(k), k)
  }

  step(k: number): void {
    switch (this.#trace.kinds[k]) {
      case ROUND_BEGUN:
        this.#round = k
        this.#placed.clear()
        this.#formed.clear()
        this.#made.clear()
        break
      case PLACED:
        this.#placed.set(this.#numberOf(k), k)
        break
      case DELETED:
        this.#placed.delete(this.#numberOf(k))
        break
      case MADE:
        this.#made.set(this.#numberOf(k), k)
        break
      case REMOVED:
        this.#made.delete(this.#numberOf(k))
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
    const listOf = (events: Map<number, number>) => Int32Array.from(events.values())
    return {
      event,
      round: this.#round,
      directedEdges: listOf(this.#placed),
      queue: listOf(this.#formed),
      faces: listOf(this.#made),
    }
  }

  #numberOf(k: number): number {
    return at(this.#trace.numbers, 2 * k)
  }

  #edgesOf(k: number): number {
    return EDGES * at(this.#trace.numbers, 2 * k) + at(this.#trace.numbers, 2 * k + 1)
  }
}
