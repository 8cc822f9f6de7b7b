// SPDX-License-Identifier: GPL-3.0-or-later
import { readFileSync } from 'node:fs'
import fc from 'fast-check'
import { describe, expect, it, vi } from 'vitest'
import createModule from '../../web/lib/generated/circle-voronoi.js'
import { type Diagram, DiagramSnapshot, NONE, TRACE_KINDS, type Trace, type TraceState } from '../../web/lib/index.ts'
import { compileCircleVoronoi } from '../../web/lib/wasm/load-options.ts'
import { Editor } from '../../web/lib/wasm/module-editor.ts'
import { instantiate } from '../../web/lib/wasm/wasm.ts'
import { library, seededRandom } from './library.ts'
import { tuple } from './tuples.ts'

function circlesOf(count: number, seed: number, largest = 1): Float64Array {
  const random = seededRandom(seed)
  const side = Math.sqrt(count) * 2
  return Float64Array.from({ length: 3 * count }, (_, k) => (k % 3 === 2 ? largest * random() : side * random()))
}

/** The edges of a diagram as text: left and right circle, and the circles of both vertices. */
function edgesOf({ edges, vertexCircles }: Diagram): string[] {
  const corner = (v: number) => (v === NONE ? '-' : tripleOf(vertexCircles.subarray(3 * v, 3 * v + 3)))
  return Array.from({ length: edges.length / 4 }, (_, e) => {
    const [left, right, start, end] = tuple(edges, 4 * e, 4)
    return turned(left, right, corner(start), corner(end))
  }).sort()
}

/** Puts the circle with the lower index on the left. */
function turned(left: number, right: number, start: string, end: string): string {
  return left < right ? `${left} ${right} ${start} ${end}` : `${right} ${left} ${end} ${start}`
}

function tripleOf(circles: ArrayLike<number>): string {
  return Array.from(circles)
    .sort((a, b) => a - b)
    .join(',')
}

/**
 * The edges from the events alone: one for each accepted antipodal disc, and one for each vertex that leaves an edge
 * open.
 */
function replayedEdges(trace: Trace, from = 0): string[] {
  const edges: { left: number; right: number; ends: [string, string] }[] = []
  const ofDirectedEdge = new Map<number, { edge: number; end: 0 | 1 }>()
  let vertex = '-'
  let placedAtOnce = 0
  for (let k = from; k < trace.length; k++) {
    const { kind, circles, numbers } = trace.event(k)
    const [a, b] = circles as [number, number]
    const [number] = numbers as [number]
    if (kind === 'antipodalDiscAccepted') {
      placedAtOnce = 2
      vertex = '-'
      edges.push({ left: b, right: a, ends: ['-', '-'] })
    } else if (kind === 'branchDisc') {
      vertex = tripleOf(circles)
    } else if (kind === 'directedEdgePlaced' && placedAtOnce > 0) {
      ofDirectedEdge.set(number, { edge: edges.length - 1, end: placedAtOnce === 2 ? 1 : 0 })
      placedAtOnce -= 1
    } else if (kind === 'directedEdgePlaced') {
      edges.push({ left: b, right: a, ends: [vertex, '-'] })
      ofDirectedEdge.set(number, { edge: edges.length - 1, end: 1 })
    } else if (kind === 'segmentFinished') {
      const { edge, end } = ofDirectedEdge.get(number) as { edge: number; end: 0 | 1 }
      ;(edges[edge] as (typeof edges)[number]).ends[end] = vertex
    }
  }
  return edges.map(({ left, right, ends }) => turned(left, right, ...ends)).sort()
}

/** Replays all events from the first one. */
function stateByReplay(trace: Trace, end: number): Partial<TraceState> {
  let alive: number[] = []
  let queue: number[] = []
  let faces: number[] = []
  const numbers = (k: number) => String(trace.event(k).numbers)
  for (let k = 0; k < end; k++) {
    const { kind } = trace.event(k)
    if (kind === 'directedEdgePlaced') alive.push(k)
    if (kind === 'directedEdgeDeleted') alive = alive.filter((other) => numbers(other) !== numbers(k))
    if (kind === 'faceMade') faces.push(k)
    if (kind === 'faceRemoved') faces = faces.filter((other) => numbers(other) !== numbers(k))
    if (kind === 'threeTouchDiscFormed') queue.push(k)
    if (kind === 'branchDisc' || kind === 'threeTouchDiscStale') {
      queue = queue.filter((other) => numbers(other) !== numbers(k))
    }
  }
  const r = (k: number) => trace.event(k).disc?.r as number
  const edge = (k: number, which: number) => trace.event(k).numbers[which] as number
  return {
    faces: Int32Array.from(faces),
    directedEdges: Int32Array.from(alive),
    queue: Int32Array.from(queue.sort((s, t) => r(s) - r(t) || edge(s, 0) - edge(t, 0) || edge(s, 1) - edge(t, 1))),
  }
}

describe('a trace', () => {
  it('has the kinds of the core', async () => {
    const { traceKindNames } = await instantiate(createModule, await compileCircleVoronoi({}))
    expect(traceKindNames()).toEqual(TRACE_KINDS)
  })

  it.each(['dynamic', 'uniform', 'all-pairs'] as const)('gives the diagram, event by event: %s', (candidates) => {
    fc.assert(
      fc.property(fc.integer({ min: 0, max: 60 }), fc.nat(), fc.constantFrom(0.5, 1, 3), (count, seed, largest) => {
        const circles = circlesOf(count, seed, largest)
        const trace = library.trace(circles, { candidates })
        expect(replayedEdges(trace)).toEqual(edgesOf(trace.diagram))
        for (let k = 0, made = 0; k < trace.length; k++) {
          const { kind, vertex } = trace.event(k)
          const last = kind === 'segmentFinished' ? made - 1 : undefined
          expect(vertex).toBe(kind === 'branchDisc' ? made++ : last)
        }
        const { vertices, hidden, edges } = library.compute(circles, { method: 'touching-disc', candidates })
        expect([trace.diagram.vertices, trace.diagram.hidden, trace.diagram.edges]).toEqual([vertices, hidden, edges])
      }),
      { numRuns: 60 },
    )
  })

  it('knows what is there after each event, in whichever order it is asked', () => {
    const circles = circlesOf(150, 7)
    const trace = library.trace(circles)
    const random = seededRandom(3)
    const places = [0, trace.length, ...Array.from({ length: 40 }, () => Math.floor(random() * (trace.length + 1)))]
    for (const k of places) {
      const state = trace.at(k)
      const { directedEdges, queue } = stateByReplay(trace, k)
      expect(state.directedEdges).toEqual(directedEdges)
      expect(state.queue).toEqual(queue)
    }
    const { counts } = trace.diagram.stats
    const { samples, pairs, branchDiscs, queue, round } = trace.at(trace.length)
    expect([samples.length, pairs.length, branchDiscs.length]).toEqual([
      counts.samples,
      counts.antipodalDiscs,
      trace.diagram.vertices.length / 3,
    ])
    expect([queue.length, round]).toEqual([0, 0])
    expect(trace.at(0)).toMatchObject({ samples: new Int32Array(0), directedEdges: new Int32Array(0) })
  })

  it('takes samples on circles less the smallest radius, and joins them', () => {
    const trace = library.trace(Float64Array.of(0, 0, 3, 10, 0, 1, 4, 9, 2))
    const { samples, sampleEdges } = trace.at(trace.length)
    const radii = [2, 0, 1]
    for (const k of samples) {
      const { disc, circles } = trace.event(k)
      const [x, y] = [0, 1].map((axis) => trace.diagram.circles[3 * (circles[0] as number) + axis] as number)
      expect(Math.hypot((disc?.x ?? 0) - (x as number), (disc?.y ?? 0) - (y as number))).toBeCloseTo(
        radii[circles[0] as number] as number,
        12,
      )
    }
    for (const k of sampleEdges) {
      const { numbers, circles } = trace.event(k)
      expect(numbers.map((sample) => trace.event(samples[sample] as number).circles[0])).toEqual(circles)
    }
  })

  it('begins anew where it samples again', () => {
    const text = readFileSync(new URL('../fixtures/missed-antipodal-disc-mixed-4.csv', import.meta.url), 'utf8')
    const circles = text
      .trim()
      .split('\n')
      .filter((line) => /^[-\d]/.test(line))
      .map((line) => line.split(',').map(Number))
    const trace = library.trace(circles as [number, number, number][], { samples: 0, resample: true })
    const rounds = trace.kinds.reduce((count, kind) => count + (TRACE_KINDS[kind] === 'roundBegun' ? 1 : 0), 0)
    expect(rounds).toBe(trace.diagram.stats.counts.resamplings + 1)
    expect(rounds).toBeGreaterThan(1)
    const { round, samples, pairs, branchDiscs } = trace.at(trace.length)
    expect(trace.event(round).numbers).toEqual([rounds - 1])
    expect(samples).toHaveLength(trace.diagram.stats.counts.samples)
    // All candidates are of the last round; those of earlier rounds are gone.
    expect(Math.min(...samples, ...pairs, ...branchDiscs)).toBeGreaterThan(round)
    expect(branchDiscs).toHaveLength(trace.diagram.vertices.length / 3)
    const before = trace.at(round)
    expect(before.directedEdges.length).toBeGreaterThan(0)
    expect(trace.at(round + 1)).toMatchObject({
      round,
      samples: new Int32Array(),
      pairs: new Int32Array(),
      branchDiscs: new Int32Array(),
      directedEdges: new Int32Array(),
      queue: new Int32Array(),
    })
    expect(replayedEdges(trace, round)).toEqual(edgesOf(trace.diagram))
  })

  it('has no faces of the round before where edits compute all anew', () => {
    const circles = circlesOf(30, 5)
    const move = (x: number) => ({ kind: 'replace', id: 0, circle: [x, 40, 1] }) as const
    const edits = [...Array.from({ length: 34 }, (_, x) => move(x)), { kind: 'insert', circle: [8, 8, 9] }] as const
    const trace = library.trace(circles, { edits })
    const begun = [...trace.kinds.keys()].filter((k) => TRACE_KINDS[trace.kinds[k] as number] === 'roundBegun')
    for (const k of begun) expect(trace.at(k + 1).faces).toEqual(new Int32Array())
    for (let k = 0; k <= trace.length; k++) {
      const { round, faces } = trace.at(k)
      expect(faces.every((event) => event > round)).toBe(true)
    }
    expect(begun).toHaveLength(2)
  })

  it('has the circles as they are rounded', () => {
    const circles = [[2 ** -97, 1, 2 ** -95]] as const
    expect(library.trace(circles).diagram.circles).toEqual(Float64Array.of(0, 1, 2 ** -95))
    expect(library.trace(circles, { edits: [] }).diagram.circles).toEqual(Float64Array.of(0, 1, 2 ** -95))
  })

  it('disposes of its editor, also where the edits are refused', () => {
    const dispose = vi.spyOn(Editor.prototype, 'dispose')
    try {
      library.trace([[0, 0, 1]], { edits: [] })
      expect(dispose).toHaveBeenCalledTimes(1)
      expect(() => library.trace([[0, 0, 1]], { edits: [{ kind: 'remove', id: 7 }] })).toThrow(
        expect.objectContaining({ code: 'unknownCircle' }),
      )
      expect(dispose).toHaveBeenCalledTimes(2)
    } finally {
      dispose.mockRestore()
    }
  })

  it('refuses what makes no sense', () => {
    const trace = library.trace([[0, 0, 1]])
    expect(trace.diagram.hull).toEqual(Int32Array.of(0))
    const others = { method: 'flip', candidates: 'uniform', samples: 1, resample: true, progress() {} } as const
    for (const [name, value] of Object.entries(others)) {
      expect(() => library.trace([], { edits: [], [name]: value })).toThrow(
        `The option ${name} does not go with edits.`,
      )
      expect(library.trace([], { edits: [], [name]: undefined })).toHaveLength(1)
    }
    expect(() => library.trace([[0, 0, 1]], { edits: [{ kind: 'remove', id: 7 }] })).toThrow(
      'There is no circle with id 7',
    )
    const stop = new Error('enough')
    const progress = () => {
      throw stop
    }
    expect(() => library.trace([[0, 0, 1]], { progress })).toThrow(stop)
  })

  it('flips edges and makes edits face by face', () => {
    const circles = circlesOf(80, 4, 3)
    const edits = [
      { kind: 'insert', circle: [9, 9, 1.5] },
      { kind: 'remove', id: 5 },
      { kind: 'replace', id: 7, circle: { x: 2, y: 3, r: 0.25 } },
    ] as const
    for (const options of [{ method: 'auto' }, { method: 'flip' }, { edits }] as const) {
      const trace = library.trace(circles, options)
      const { faces, edits: edited } = trace.at(trace.length)
      // If a move in place fails, it is reverted and done by removal and insertion.
      const ids = new Set(Array.from(edited, (k) => trace.event(k).circles[0]))
      expect([...ids]).toEqual('edits' in options ? [80, 5, 7] : [])
      const vertices = Array.from(faces, (k) => trace.event(k)).filter((face) => face.circles.length === 3)
      // The events name circles by id.
      const { diagram } = trace
      const { circles: idsOf = [] } = diagram instanceof DiagramSnapshot ? diagram.numbers : {}
      const idOf = (index: number) => idsOf[index] ?? index
      const triples = Array.from({ length: trace.diagram.vertices.length / 3 }, (_, v) =>
        tripleOf([0, 1, 2].map((k) => idOf(trace.diagram.vertexCircles[3 * v + k] as number))),
      )
      expect(vertices.map((face) => tripleOf(face.circles)).sort()).toEqual(triples.sort())
      for (const k of [0, 1, trace.length >> 1, trace.length - 3, trace.length]) {
        expect(trace.at(k).faces.toSorted()).toEqual((stateByReplay(trace, k).faces as Int32Array).toSorted())
      }
      expect(trace.kinds.some((kind) => TRACE_KINDS[kind] === 'discNotEmpty')).toBe(true)
    }
  })
})
