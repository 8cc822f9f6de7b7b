// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it, vi } from 'vitest'
import { type Circle, Diagram, TRACE_KINDS, Trace, type TraceKind } from '../../web/lib/index.ts'
import type { TraceOptions } from '../../web/lib/wasm/trace.ts'
import { ringOf, testedAt, testedCircles, turnTo, waitingCount, waitingDiscs } from '../../web/player/discs.ts'
import { arcOf, FinishedArcs } from '../../web/player/finished-arcs.ts'
import { questionAfter } from '../../web/player/prediction.ts'
import { PROGRAMS } from '../../web/player/program.ts'
import { numberOf, sentenceOf } from '../../web/player/sentences.ts'
import { circlesAt, overlayOf } from '../../web/player/step-overlay.ts'
import { concerns, kindAt, kindOf, nextStep, programOf, type Step, stepsOf } from '../../web/player/steps.ts'
import { columnsOf, drawTimeline } from '../../web/player/timeline.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import { MOST_PLAYED } from '../../web/view/layers.ts'
import { traced } from '../../web/view/painter/traced.ts'
import { library, seededRandom } from './library.ts'

const SMALL = Float64Array.of(0, 0, 2, 10, 1, 1, 5, 8, 1.5, 2, 6, 0.8, 9, 6, 2.2, 6, 3, 0.6, 12, 10, 1)
const COLORS = { past: 'a', sample: 'b', current: 'c', good: 'd', bad: 'e', edge: 'f', ink: 'g' }

function randomCircles(count: number, seed: number): Float64Array {
  const random = seededRandom(seed)
  const side = Math.sqrt(count) * 2
  return Float64Array.from({ length: 3 * count }, (_, k) => (k % 3 === 2 ? random() : side * random()))
}

const EDITS = [
  { kind: 'insert', circle: [5, 5, 0.5] },
  { kind: 'replace', id: 2, circle: [5, 9, 1] },
  { kind: 'remove', id: 4 },
] as const

const ways = [
  ['touching', {}],
  ['touching', { candidates: 'all-pairs' }],
  ['flips', { method: 'auto' }],
  ['edits', { edits: EDITS }],
] as const

const circlesOf = (trace: Trace, given: Float64Array, step: Step) => {
  const circles = circlesAt(trace, given, trace.at(step.end))
  return (id: number) => circles.get(id)
}

describe('the steps of a trace', () => {
  it.each(ways)('are all that happens, in order: %s %o', (program, options) => {
    for (const circles of [SMALL, randomCircles(16, 3), new Float64Array(), Float64Array.of(0, 0, 1, 4, 0, 1)]) {
      if (circles.length < 21 && 'edits' in options) continue
      const trace = library.trace(circles, options)
      const steps = stepsOf(trace)
      const lines = PROGRAMS[programOf(trace)].flatMap(({ lines }) => lines.map(([line]) => line))
      if (circles.length > 6) expect(programOf(trace)).toBe(program)
      let end = 0
      for (const [k, step] of steps.entries()) {
        expect(step.end).toBeGreaterThanOrEqual(end)
        // Each step begins where the previous one ended.
        expect(step.event, `step ${k}, ${step.line}`).toBe(end)
        end = step.end
        expect([...lines, 'again']).toContain(step.line)
        const sentence = sentenceOf(trace, step)
        expect(sentence).toMatch(/^[A-Z0-9].*[.?]$/)
        expect(sentence).not.toMatch(/undefined|NaN|Infinity|null/)
        const state = trace.at(step.end)
        for (const layer of overlayOf(trace, step, state, [], circlesAt(trace, circles, state), COLORS)) {
          for (const list of [layer.points, layer.segments, layer.discs]) {
            expect(list?.every(Number.isFinite) ?? true, `${step.line} ${layer.id}`).toBe(true)
          }
        }
      }
      expect(end).toBe(trace.length)
    }
  })

  it('place both directed edges of an empty disc at once', () => {
    const trace = library.trace(SMALL)
    const placing = stepsOf(trace).filter(({ line }) => line === 'place')
    expect(placing.length).toBeGreaterThan(2)
    for (const { event, end } of placing) {
      const kinds = Array.from({ length: end - event }, (_, k) => kindAt(trace, event + k))
      expect(kinds).toEqual(['antipodalDiscAccepted', 'directedEdgePlaced', 'directedEdgePlaced'])
    }
  })

  it('are told with short numbers', () => {
    expect([1234567, 0.000012345, 0.001, 0, -2.34567, 1234.5678].map(numberOf)).toEqual([
      '1.23e+6',
      '1.23e-5',
      '0.001',
      '0',
      '-2.35',
      '1234.57',
    ])
  })

  it('are those of flips where the trace begins with faces, and of the method where it has neither', () => {
    expect(programOf(library.trace(SMALL, { edits: [] }))).toBe('flips')
    expect(programOf(library.trace([]))).toBe('touching')
  })

  it('can be looked for by sort and by circle', () => {
    const trace = library.trace(SMALL)
    const steps = stepsOf(trace)
    const vertices = steps.flatMap((step, k) => (kindOf(step) === 'vertex' ? [k] : []))
    expect(vertices).toHaveLength(trace.diagram.vertices.length / 3)
    const isVertex = (step: Step) => kindOf(step) === 'vertex'
    expect(nextStep(steps, 0, 1, isVertex)).toBe(vertices[0])
    expect(nextStep(steps, vertices[1] as number, -1, isVertex)).toBe(vertices[0])
    expect(nextStep(steps, vertices[0] as number, -1, isVertex)).toBeUndefined()
    const of6 = steps.flatMap((_, k) => (concerns(trace, steps, k, 6) ? [k] : []))
    expect(of6.length).toBeGreaterThan(2)
    for (const k of of6) expect(sentenceOf(trace, steps[k] as Step)).toMatch(/\b6\b/)
    expect(columnsOf(steps, 100)).toHaveLength(100)
    expect([...(columnsOf(steps, 100)[0]?.keys() ?? [])]).toContain('stage')
    // A column counts its steps, so that few steps differ from many.
    const counts = columnsOf(steps, 10).flatMap((column) => [...column.values()])
    expect(counts.reduce((sum, count) => sum + count, 0)).toBe(
      steps.filter((step) => kindOf(step) !== undefined).length,
    )
    expect(new Set(counts).size).toBeGreaterThan(2)
  })

  it.each([1, 2])('are marked by kind across the timeline, with dots for breakpoints: pixel ratio %d', (pixelRatio) => {
    vi.stubGlobal('devicePixelRatio', pixelRatio)
    const steps = stepsOf(library.trace(SMALL))
    for (const clientWidth of [400, 90, 101]) {
      const dots: number[][] = []
      const ends: number[] = []
      const colors = new Set<string>()
      const context = {
        fillStyle: '',
        fillRect: (x: number, _: number, width: number) => {
          ends.push(x + width)
          colors.add(context.fillStyle)
        },
        beginPath() {},
        fill() {},
        arc: (...dot: number[]) => dots.push(dot.slice(0, 3)),
      }
      const canvas = { clientWidth, clientHeight: 20, getContext: () => context } as object as HTMLCanvasElement
      drawTimeline(canvas, steps, 0, new Set([0, steps.length - 1]), COLORS)
      expect(Math.abs(Math.max(...ends) - clientWidth * pixelRatio)).toBeLessThan(2 * pixelRatio)
      expect(colors.size).toBeGreaterThan(4)
      expect(dots).toEqual([0, clientWidth * pixelRatio - 1].map((x) => [x, 16 * pixelRatio, 4 * pixelRatio]))
    }
    vi.unstubAllGlobals()
  })
})

it.each([
  [10, 1, 0.3],
  [1, 1000, 0.02 * 1004],
])('arrows have heads in proportion, but no larger than a share of the picture: radius %d, gap %d', (r, gap, head) => {
  const circles = Float64Array.of(0, 0, r, gap + 2 * r, 0, r)
  const trace = library.trace(circles)
  const step = stepsOf(trace).find(({ line }) => line === 'place') as Step
  const state = trace.at(step.end)
  const layers = overlayOf(trace, step, state, [], circlesAt(trace, circles, state), COLORS)
  const [x, y, tipX, tipY, , , headX, headY] = layers.find(({ id }) => id === 'placed')?.segments ?? []
  // The arrow lies to the right of its segment, with the head at the tip.
  const expected = [r, -head / 2, r + gap, -head / 2, r + gap - head, -head]
  for (const [k, value] of [x, y, tipX, tipY, headX, headY].entries()) expect(value).toBeCloseTo(expected[k] as number)
})

describe('what is shown beside a step', () => {
  const seed = 5
  const circles = randomCircles(40, seed)
  const trace = library.trace(circles, { samples: 3 })
  const steps = stepsOf(trace)

  it('begins the list with the disc that is taken next', () => {
    let taken = 0
    for (const step of steps) {
      if (step.line !== 'take') continue
      const state = trace.at(step.end)
      const [first] = waitingDiscs(trace, state, step.end, 5)
      const { disc, circles, numbers } = trace.event(step.event)
      expect(first?.r).toBe(disc?.r)
      if (kindAt(trace, step.event) === 'branchDisc') {
        expect(first?.circles).toEqual(circles)
        expect(trace.event(first?.event as number).numbers).toEqual(numbers)
      }
      taken += 1
      if (taken === 1) expect(waitingCount(trace, state, step.end)).toBe(state.pairs.length)
    }
    expect(taken).toBeGreaterThan(80)
  })

  it('names the circle that a disc meets among those that it is tested against', () => {
    let met = 0
    for (const step of steps) {
      if (step.line !== 'notEmpty') continue
      const { circles: ids, disc } = trace.event(step.event)
      const state = trace.at(step.event)
      const circleOf = circlesOf(trace, circles, step)
      const tested = testedCircles(trace, state, ids.slice(0, 2), disc as Circle, circleOf)
      expect(tested).toContain(ids[2])
      expect(tested).toEqual(neighborsOnRings(state, ids.slice(0, 2), disc as Circle, circleOf))
      // The step before announces the disc.
      for (const told of [step, steps[steps.indexOf(step) - 1] as Step])
        expect(testedAt(trace, told, trace.at(told.end), circleOf), told.line).toEqual(tested)
      met += 1
    }
    expect(met).toBeGreaterThan(5)
    const placed = steps.filter(({ line }) => line === 'place')
    const testedIn = (step: Step) => testedAt(trace, step, trace.at(step.end), circlesOf(trace, circles, step))
    expect(placed.filter((step) => testedIn(step).length > 0).length).toBeGreaterThan(5)
    for (const step of steps) if (!['take', 'place', 'notEmpty'].includes(step.line)) expect(testedIn(step)).toEqual([])
  })

  /** The marks nearest to the foot point on either side. */
  function neighborsOnRings(
    state: ReturnType<Trace['at']>,
    pair: readonly number[],
    disc: Circle,
    circleOf: (id: number) => Circle | undefined,
  ): number[] {
    const found = new Set<number>()
    const turned = (turn: number) => turn - Math.floor(turn)
    for (const id of pair) {
      const circle = circleOf(id) as Circle
      const { marks } = ringOf(trace, state, id, circle)
      const foot = turnTo(circle, disc.x, disc.y)
      for (const way of [1, -1]) {
        const rank = ({ angle }: { angle: number }) => turned(way * (angle - foot)) || 1
        const least = Math.min(...marks.map(rank))
        const next = marks.filter((mark) => rank(mark) === least)
        const mark = way === 1 ? next[0] : next.at(-1)
        if (mark !== undefined) found.add(mark.other)
      }
    }
    return [...found].filter((id) => !pair.includes(id)).sort((a, b) => a - b)
  }

  it('has arcs of a ring between edges that end and edges that start, and none where all is used', () => {
    const { hull } = trace.diagram
    const state = trace.at(trace.length)
    const circleOf = circlesOf(trace, circles, steps.at(-1) as Step)
    let arcs = 0
    for (let id = 0; id < 40; id++) {
      const { marks, unused } = ringOf(trace, state, id, circleOf(id) as Circle)
      expect(marks.filter(({ isOut }) => isOut)).toHaveLength(marks.length / 2)
      // At the end, each circle has one unused arc for each of its appearances on the hull.
      expect(unused).toHaveLength(hull.filter((circle) => circle === id).length)
      for (const { from, to } of unused) {
        arcs += 1
        expect(from >= 0 && from < 1 && to > from && to <= from + 1).toBe(true)
        expect(marks.some(({ angle, isOut }) => angle === from && !isOut)).toBe(true)
        expect(marks.some(({ angle, isOut }) => isOut && (angle === to || angle + 1 === to))).toBe(true)
        const isInside = (angle: number) => (angle > from && angle < to) || angle + 1 < to
        expect(marks.some(({ angle }) => isInside(angle))).toBe(false)
      }
    }
    expect(arcs).toBe(hull.length)
  })

  it('draws the bisector of two circles as points with the same distance from both', () => {
    const [a, b] = [
      { x: 0, y: 0, r: 2 },
      { x: 7, y: 1, r: 1 },
    ] as const
    const { vertices, vertexCircles } = library.compute([a, b, { x: 3, y: 6, r: 1 }, { x: 4, y: -5, r: 0.5 }])
    const both = [0, 1].map((v) => ({ x: vertices[3 * v] as number, y: vertices[3 * v + 1] as number, r: 0 }))
    expect([...vertexCircles].filter((circle) => circle < 2)).toHaveLength(4)
    const pieces = arcOf(a, b, both[0] as Circle, both[1] as Circle)
    expect(arcOf(b, a, both[0] as Circle, both[1] as Circle)).toEqual(pieces)
    for (let k = 0; k < pieces.length; k += 2) {
      const [x, y] = pieces.slice(k, k + 2) as [number, number]
      expect(Math.hypot(x, y) - 2).toBeCloseTo(Math.hypot(x - 7, y - 1) - 1, 9)
    }
  })

  /** A trace of events, each with its kind, its circles, its first number and its disc. */
  const traceOf = (...events: [kind: TraceKind, circles?: number[], number?: number, disc?: Circle][]) =>
    Object.create(
      Trace.prototype,
      Object.getOwnPropertyDescriptors({
        length: events.length,
        kinds: Uint8Array.from(events, ([kind]) => TRACE_KINDS.indexOf(kind)),
        numbers: Int32Array.from(events.flatMap(([, , number = 0]) => [number, 0])),
        event: (k: number) => {
          const [kind, circles = [], number = 0, disc] = events[k] as (typeof events)[number]
          return { kind, circles, numbers: [number], disc }
        },
      }),
    ) as Trace

  it('draws no segment from a directed edge of an earlier round, which has the same number', () => {
    const [from, to] = [
      { x: 5, y: 0, r: 4 },
      { x: 5, y: 3, r: 5 },
    ]
    const circleOf = (id: number) => ({ x: 10 * id, y: 0, r: 1 })
    const arcs = (...between: TraceKind[]) => {
      const events = traceOf(['directedEdgePlaced', [0, 1], 7, from], ...between.map((kind): [TraceKind] => [kind]), [
        'segmentFinished',
        [0, 1],
        7,
        to,
      ])
      return new FinishedArcs(events).of(Int32Array.of(events.length - 1), circleOf).length
    }
    expect([arcs(), arcs('antipodalDiscUsed'), arcs('roundBegun')]).toEqual([48, 48, 0])
  })

  const layersAt = (line: Step['line']) => {
    const step = steps.find((step) => step.line === line) as Step
    const state = trace.at(step.end)
    const layers = overlayOf(trace, step, state, [], circlesAt(trace, circles, state), COLORS)
    return { step, state, layer: (name: string) => layers.find(({ id }) => id === name) }
  }

  it('tells what ends from what has ended before', () => {
    const { step, state, layer } = layersAt('finish')
    const before = [...state.segments].filter((k) => k < step.event)
    expect(before.length).toBeLessThan(state.segments.length)
    expect(layer('segments')?.segments ?? []).toHaveLength(48 * before.length)
    expect(layer('finished')).toMatchObject({ color: 'c', width: 3 })
    expect(layer('finished')?.segments).toHaveLength(48 * (state.segments.length - before.length))
    expect(layer('deleted')).toMatchObject({ color: 'e', width: 1.25, dash: [4, 4] })
  })

  it('joins the rims of each pair across the gap between them', () => {
    const { state, layer } = layersAt('pairs')
    const { segments = [] } = layer('pairs') ?? {}
    expect(segments).toHaveLength(4 * state.pairs.length)
    for (const [k, event] of state.pairs.entries()) {
      const [a, b] = trace.event(event).circles.map((id) => circles.subarray(3 * id, 3 * id + 3)) as [
        Float64Array,
        Float64Array,
      ]
      const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = segments.slice(4 * k, 4 * k + 4)
      const away = (circle: Float64Array, x: number, y: number) =>
        Math.hypot(x - Number(circle[0]), y - Number(circle[1]))
      expect(away(a, x0, y0)).toBeCloseTo(Number(a[2]), 9)
      expect(away(b, x1, y1)).toBeCloseTo(Number(b[2]), 9)
      const gap = away(a, Number(b[0]), Number(b[1])) - Number(a[2]) - Number(b[2])
      expect(Math.hypot(x1 - x0, y1 - y0)).toBeCloseTo(Math.abs(gap), 9)
    }
  })

  it('numbers all circles where they are few, and those of the step and of its test where they are many', () => {
    for (const [count, tested, numbered] of [
      [60, [], undefined],
      [61, [7], [7]],
    ] as const) {
      const many = randomCircles(count, 3)
      const own = library.trace(many)
      const step = stepsOf(own).find(({ line }) => line === 'notEmpty') as Step
      const state = own.at(step.end)
      const layers = overlayOf(own, step, state, tested, circlesAt(own, many, state), COLORS)
      const { numbers = [], points = [] } = layers.find(({ id }) => id === 'numbers') ?? {}
      const expected =
        numbered === undefined ? [...Array(count).keys()] : [...numbered, ...own.event(step.event).circles]
      expect([...numbers].sort((a, b) => a - b)).toEqual([...new Set(expected)].sort((a, b) => a - b))
      for (const [k, id] of numbers.entries())
        expect([points[2 * k], points[2 * k + 1]]).toEqual([...many.subarray(3 * id, 3 * id + 2)])
    }
  })

  it('shows where a disc touches, and not the circle that reaches into it', () => {
    const { step, layer } = layersAt('notEmpty')
    const { circles: ids, disc } = trace.event(step.event)
    expect(layer('disc')?.points).toHaveLength(4)
    expect(layer('met')).toMatchObject({ color: 'e', width: 3 })
    expect([...(layer('met')?.discs ?? [])]).toEqual([...circles.subarray(3 * Number(ids[2]), 3 * Number(ids[2]) + 3)])
    const [x = 0, y = 0] = layer('disc')?.points ?? []
    expect(Math.hypot(x - Number(disc?.x), y - Number(disc?.y))).toBeCloseTo(Math.abs(Number(disc?.r)), 9)
  })

  it('draws the circles on which samples lie, which are smaller by the radius of the smallest one', () => {
    const { discs = [] } = layersAt('samples').layer('rims') ?? {}
    expect(discs.length).toBeGreaterThan(3 * 25)
    const differences = new Set<number>()
    for (let k = 0; k < discs.length; k += 3) {
      const id = circles.findIndex((x, i) => i % 3 === 0 && x === discs[k] && circles[i + 1] === discs[k + 1])
      differences.add(Math.round(1e9 * ((circles[id + 2] as number) - (discs[k + 2] as number))))
    }
    expect([differences.size, Math.min(...differences) > 0]).toEqual([1, true])
  })

  it('begins each round anew, and says which', () => {
    const events = traceOf(
      ['roundBegun'],
      ['faceMade'],
      ['discNotEmpty', [0, 1, 2]],
      ['faceRemoved'],
      ['faceMade'],
      ['faceMade'],
      ['roundBegun', [], 1],
      ['faceMade'],
      ['faceRemoved'],
    )
    const lines = ['begin', 'flipDiscs', 'flipTest', 'flip', 'again', 'flipDiscs', 'ties', 'flipDone']
    const steps = stepsOf(events)
    expect(steps.map(({ line }) => line)).toEqual(lines)
    expect(sentenceOf(events, steps[4] as Step)).toContain('round 2 begins')
    const forms = traceOf(
      ['sampleTaken'],
      ['branchDisc', [0, 1, 2]],
      ['threeTouchDiscFormed', [0, 1, 2]],
      ['antipodalDiscAccepted', [0, 1]],
      ['threeTouchDiscFormed', [0, 1, 2]],
    )
    const formed = ['samples', 'take', 'branch', 'formThird', 'take', 'place', 'form', 'hull']
    expect(stepsOf(forms).map(({ line }) => line)).toEqual(formed)
    expect(stepsOf(forms).flatMap((_, k) => (concerns(forms, stepsOf(forms), k, 0) ? [k] : []))).toEqual([
      1, 2, 3, 4, 5, 6,
    ])
  })

  it('has a list that ends with its round, with discs by radius and of one radius in their order', () => {
    const disc = (r: number) => ({ x: 0, y: 0, r })
    const events = traceOf(
      ['threeTouchDiscFormed', [0, 1, 2], 0, disc(3)],
      ['antipodalDiscUsed', [0, 1, 5], 0, disc(4)],
      ['branchDisc', [0, 1, 2], 0, disc(1)],
      ['antipodalDiscNotEmpty', [2, 3, 4], 0, disc(2)],
      ['antipodalDiscAccepted', [4, 5], 0, disc(3)],
      ['roundBegun'],
      ['antipodalDiscAccepted', [6, 7], 0, disc(1)],
    )
    const state = { queue: Int32Array.of(0) } as ReturnType<Trace['at']>
    const listed = (most: number) => waitingDiscs(events, state, 1, most).map(({ circles, r }) => [r, ...circles])
    expect(listed(9)).toEqual([
      [2, 2, 3],
      [3, 0, 1, 2],
      [3, 4, 5],
      [4, 0, 1],
    ])
    expect(listed(2)).toEqual([
      [2, 2, 3],
      [3, 0, 1, 2],
    ])
    expect(waitingCount(events, state, 1)).toBe(4)
    expect(waitingCount(events, state, 2)).toBe(3)
    expect(waitingCount(events, state, 5)).toBe(1)
  })

  it('draws each segment that is finished, from its antipodal or its branch disc to its vertex', () => {
    const last = steps.findLast(({ line }) => line === 'placeThird' || line === 'finish') as Step
    const state = trace.at(last.end)
    expect(state.segments.length).toBeGreaterThan(100)
    const layers = overlayOf(trace, last, state, [], circlesAt(trace, circles, state), COLORS)
    const drawn = layers.flatMap(({ id, segments }) => (/^(segments|finished)$/.test(id) ? [...(segments ?? [])] : []))
    // The end of a piece where no piece begins is a vertex, and each vertex ends at least one segment.
    const ends = new Set<string>()
    for (let k = 0; k < drawn.length; k += 48)
      ends.add(
        drawn
          .slice(k + 46, k + 48)
          .map((value) => value.toFixed(6))
          .join(),
      )
    const vertices = Array.from(state.segments, (k) => trace.event(k).disc as Circle)
    for (const { x, y } of vertices) expect(ends).toContain([x.toFixed(6), y.toFixed(6)].join())
    expect(drawn).toHaveLength(48 * state.segments.length)
  })

  it('draws rays from each center to the samples of its circle that come next', () => {
    const step = steps.find(({ line }) => line === 'angles') as Step
    const state = trace.at(step.end)
    const known = circlesAt(trace, circles, state)
    const { segments = [] } = overlayOf(trace, step, state, [], known, COLORS).find(({ id }) => id === 'rays') ?? {}
    const { samples } = trace.at(trace.length)
    const expected = Array.from(samples).flatMap((event) => {
      const { disc, circles: of } = trace.event(event)
      const { x, y } = known.get(of[0] as number) as Circle
      return [x, y, disc?.x, disc?.y]
    })
    expect([...segments]).toEqual(expected)
    expect(expected.length).toBeGreaterThan(100)
  })

  it('shows circles as edits have left them', () => {
    const edited = library.trace(SMALL, { edits: EDITS })
    const before = circlesAt(edited, SMALL, edited.at(1))
    const after = circlesAt(edited, SMALL, edited.at(edited.length))
    expect([before.size, after.size]).toEqual([7, 7])
    expect(after.get(7)).toMatchObject({ x: 5, y: 5, r: 0.5 })
    expect(after.get(2)).toMatchObject({ x: 5, y: 9, r: 1 })
    expect(after.has(4)).toBe(false)
    // Other ids than 0, 1, and so on.
    const named = circlesAt(edited, SMALL.subarray(0, 6), edited.at(1), Int32Array.of(3, 8))
    expect([...named]).toEqual([
      [3, { x: 0, y: 0, r: 2 }],
      [8, { x: 10, y: 1, r: 1 }],
    ])
  })
})

describe('a trace of circles that were edited', () => {
  const editor = library.edit(SMALL)
  const table = new CircleTable(SMALL.slice())
  for (const edits of [
    [{ kind: 'remove', id: 1 }] as const,
    [
      { kind: 'insert', circle: [5, 5, 0.5] },
      { kind: 'remove', id: 3 },
    ] as const,
    [{ kind: 'insert', circle: [15, 5, 0.5] }] as const,
  ]) {
    table.follow(editor.apply(edits))
  }
  const trace = (options: TraceOptions = {}) => traced(library, table.circles(), table.ids(), options)

  it('names them by their ids', () => {
    const { ids, circles, events, diagram } = trace()
    expect([...ids]).not.toEqual([...ids.keys()])
    // At its contact points, a disc has its radius as the distance.
    const found = new Trace(new Diagram(diagram), events)
    const byId = circlesAt(found, circles, found.at(0), ids)
    let discs = 0
    for (let k = 0; k < found.length; k++) {
      const { kind, disc, circles: three } = found.event(k)
      if (kind !== 'branchDisc' || disc === undefined) continue
      for (const id of three) {
        const { x, y, r } = byId.get(id) as Circle
        expect(Math.hypot(disc.x - x, disc.y - y) - r).toBeCloseTo(disc.r, 9)
      }
      discs += 1
    }
    expect(discs).toBeGreaterThan(4)
  })

  it('takes edits of them', () => {
    const { ids } = trace()
    const [second, last] = [ids[1], ids.at(-1)] as [number, number]
    const edits = [
      { kind: 'replace', id: second, circle: [1, 7, 1] },
      { kind: 'insert', circle: [0, 9, 0.2] },
      { kind: 'remove', id: last + 1 },
    ] as const
    const { events } = trace({ edits })
    const edited = Array.from(events.kinds, (kind, k) => [TRACE_KINDS[kind], events.circles[3 * k]] as const)
    expect(edited.filter(([kind]) => /^circle(Inserted|Removed|Replaced)$/.test(kind as string))).toEqual([
      ['circleReplaced', second],
      ['circleInserted', last + 1],
      ['circleRemoved', last + 1],
    ])
    for (const id of [1, last + 1]) {
      expect(() => trace({ edits: [{ kind: 'remove', id }] })).toThrow(
        expect.objectContaining({ code: 'unknownCircle' }),
      )
    }
  })

  it('is refused where there are too many', () => {
    const many = new CircleTable(Float64Array.from(randomCircles(MOST_PLAYED + 1, 4)))
    expect(() => traced(library, many.circles(), many.ids(), {})).toThrow(
      expect.objectContaining({ code: 'tooManyCircles' }),
    )
  })
})

describe('questions', () => {
  it('have one right answer, which the next step gives', () => {
    const trace = library.trace(randomCircles(30, 8))
    const steps = stepsOf(trace)
    const answers = new Map<string, string[]>()
    for (const [k, step] of steps.entries()) {
      const question = questionAfter(trace, steps, k)
      expect(question !== undefined).toBe(step.line === 'take')
      if (question === undefined) continue
      const { line: next, event } = steps[k + 1] as Step
      const after = Array.from({ length: trace.length - event - 1 }, (_, i) => kindAt(trace, event + 1 + i) as string)
      const others = after.findIndex((kind) => !['directedEdgeDeleted', 'segmentFinished'].includes(kind))
      const ended = after.slice(0, others).filter((kind) => kind === 'directedEdgeDeleted').length
      // At a disc that three circles touch, two edges end, or three, or it is stale.
      if (next === 'branch') expect(question.right).toBe(ended - 2)
      if (next === 'stale') expect(question.right).toBe(2)
      const right = question.answers[question.right] as string
      answers.set(next, [...new Set([...(answers.get(next) ?? []), right])])
    }
    expect([...answers.keys()].sort()).toEqual(['branch', 'notEmpty', 'place', 'stale', 'used'])
    // Two or three edges end in a branch disc.
    expect([...answers].map(([next, { length }]) => length === (next === 'branch' ? 2 : 1))).not.toContain(false)
    expect(new Set([...answers.values()].flat()).size).toBe(6)
  })

  it('ask of a flip which edge comes', () => {
    const trace = library.trace(randomCircles(60, 2), { method: 'auto' })
    const steps = stepsOf(trace)
    let asked = 0
    for (const [k, step] of steps.entries()) {
      const question = questionAfter(trace, steps, k)
      if (question === undefined) continue
      asked += 1
      expect(step.line).toBe('flipTest')
      expect(new Set(question.answers).size).toBe(3)
      expect(sentenceOf(trace, steps[k + 1] as Step)).toContain(`becomes ${question.answers[question.right]}.`)
    }
    expect(asked).toBeGreaterThan(5)
  })
})
