// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it, vi } from 'vitest'
import {
  type Change,
  type Circle,
  CircleVoronoiError,
  type Diagram,
  type DiagramEditor,
  DiagramSnapshot,
  type Edit,
  fromJSON,
  loadCircleVoronoi,
  NONE,
} from '../../web/lib/index.ts'
import { contentOf, edited, someCircle, someEdit } from './edit-script.ts'
import { library, seededRandom } from './library.ts'
import { leastDistance, signedDistance } from './oracle.ts'

const THREE = Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1)

/**
 * Expects that a diagram which follows an editor equals the editor's snapshot, is certified, and answers queries alike.
 */
function expectSame(diagram: DiagramSnapshot, snapshot: DiagramSnapshot, random: () => number) {
  expect(contentOf(diagram)).toEqual(contentOf(snapshot))
  const { message } = library.certify(diagram)
  expect(message).toBe('')
  expect(diagram.stats.counts).toMatchObject({
    circles: diagram.circles.length / 3,
    hidden: diagram.hidden.length / 2,
  })
  for (let k = 0; k < 3; k++) {
    const [x, y] = [10 * random() - 1, 10 * random() - 1]
    const found = diagram.find(x, y)
    if (found === NONE) expect(diagram.circles).toHaveLength(0)
    else {
      const least = leastDistance(diagram.circles, { x, y })
      expect(signedDistance(diagram.circles, found, { x, y })).toBeCloseTo(least, 9)
    }
  }
}

function circleOf({ circles }: Diagram, i: number): Circle {
  const [x = NaN, y = NaN, r = NaN] = circles.subarray(3 * i, 3 * i + 3)
  return { x, y, r }
}

describe('a diagram that follows an editor', () => {
  it.each([
    [0, false],
    [0, true],
    [5, true],
    [12, false],
    [40, true],
    [60, false],
  ])('is its snapshot, from %i circles, on a grid: %s', (count, isOnGrid) => {
    for (const seed of [1, 2, 3, 4]) {
      const random = seededRandom(seed + 100 * count)
      const editor = library.edit(Array.from({ length: count }, () => someCircle(random, isOnGrid)))
      const diagram = editor.snapshot()
      diagram.find(0, 0)
      for (let i = 0; i < 120; i++) {
        // Some edits come in batches, which may be refused as a whole.
        const edits = Array.from({ length: i % 10 === 0 ? 12 : 1 }, () => someEdit(random, isOnGrid, editor))
        try {
          diagram.apply(edits.length > 1 ? editor.apply(edits) : edited(editor, edits[0] as Edit))
        } catch (error) {
          expect(error).toMatchObject({ code: 'unknownCircle' })
        }
        if (i % 3 === 0) expectSame(diagram, editor.snapshot(), random)
      }
      editor.dispose()
    }
  })

  it('follows to nothing and back', () => {
    const random = seededRandom(1)
    const editor = library.edit(THREE)
    const diagram = editor.snapshot()
    for (const id of editor.ids()) {
      diagram.apply(editor.remove(id))
      expectSame(diagram, editor.snapshot(), random)
    }
    expect(diagram.find(0, 0)).toBe(NONE)
    for (let k = 0; k < 40; k++) {
      diagram.apply(editor.insert(someCircle(random, false)))
      expectSame(diagram, editor.snapshot(), random)
    }
    const change = editor.apply(Array.from(editor.ids(), (id) => ({ kind: 'remove', id })))
    expect(change.way).toBe('whole')
    expectSame(diagram.apply(change), editor.snapshot(), random)
  })

  it('is its snapshot along a row, whose borders have no vertices', () => {
    const random = seededRandom(11)
    for (let trial = 0; trial < 200; trial++) {
      const editor = library.edit([])
      const diagram = editor.snapshot()
      for (let k = 0; k < 12; k++) {
        const ids = editor.ids()
        const isRemoval = ids.length > 2 && random() < 0.4
        const id = ids[Math.floor(ids.length * random())] as number
        const circle = { x: Math.floor(20 * random()), y: 0, r: 0 }
        diagram.apply(isRemoval ? editor.remove(id) : editor.insert(circle))
        expectSame(diagram, editor.snapshot(), random)
      }
      editor.dispose()
    }
  })

  it('is right where a huge circle hides many, moves and goes', () => {
    const random = seededRandom(5)
    const editor = library.edit(Array.from({ length: 3000 }, () => someCircle(random, false)))
    const diagram = editor.snapshot()
    const [huge] = editor.insert({ x: 4, y: 4, r: 3 }).inserted as unknown as [number]
    expect(() => diagram.apply(editor.replace(huge, { x: 4, y: 4.5, r: 3 }))).toThrow(CircleVoronoiError)
    const again = editor.snapshot()
    for (const circle of [
      { x: 4, y: 3.5, r: 3.1 },
      { x: 100, y: 4, r: 50 },
      { x: 4, y: 4, r: 1e-3 },
    ]) {
      expectSame(again.apply(editor.replace(huge, circle)), editor.snapshot(), random)
    }
    expectSame(again.apply(editor.remove(huge)), editor.snapshot(), random)
    expect(editor.size()).toBe(3000)
  })

  it('has the bits of the snapshot after jumps of scale', () => {
    const random = seededRandom(7)
    const some = (size: number) => ({ x: size * random(), y: size * random(), r: 0.05 * size * random() })
    const editor = library.edit(Array.from({ length: 12 }, () => some(1)))
    const diagram = editor.snapshot()
    for (let i = 0; i < 200; i++) {
      const circle = some(random() < 0.5 ? 1 : 10 ** (56 * random() - 28))
      const ids = editor.ids()
      const id = ids[Math.floor(ids.length * random())] as number
      const isFull = ids.length >= 12
      const isRemoval = isFull && random() < 0.5
      diagram.apply(isRemoval ? editor.remove(id) : isFull ? editor.replace(id, circle) : editor.insert(circle))
      expect(contentOf(diagram)).toEqual(contentOf(editor.snapshot()))
    }
  })

  it('is a snapshot still after a structured clone', () => {
    const editor = library.edit(THREE)
    const first = editor.snapshot().apply(editor.insert({ x: 3, y: 4, r: 1 }))
    const clone = new DiagramSnapshot(structuredClone(first))
    expectSame(clone.apply(editor.remove(1)), editor.snapshot(), seededRandom(1))
    expect(clone.indexOf(1)).toBe(NONE)
    expect(circleOf(clone, clone.indexOf(3))).toEqual({ x: 3, y: 4, r: 1 })
  })

  it('is a file as any other', () => {
    const editor = library.edit(THREE)
    const diagram = editor
      .snapshot()
      .apply(editor.insert({ x: 3, y: 4, r: 1 }))
      .apply(editor.remove(0))
    const read = fromJSON(JSON.stringify(diagram))
    expect(library.certify(read).certified).toBe(true)
    expect(read.circles).toEqual(diagram.circles)
    expect(diagram.render({ bounds: [-9, -9, 9, 9] })).toBe(read.render({ bounds: [-9, -9, 9, 9] }))
  })
})

describe('an editor', () => {
  it('says what an edit did', () => {
    using editor = library.edit(THREE)
    const change = editor.insert([2, 2, 0.5])
    expect(change).toMatchObject({
      revision: 1,
      way: 'local',
      inserted: Int32Array.of(3),
      circles: Float64Array.of(2, 2, 0.5),
      removed: new Int32Array(),
      hidden: new Int32Array(),
    })
    expect([...change.cells].sort()).toEqual([0, 1, 2, 3])
    expect(change.removedVertices).toHaveLength(1)
    expect(change.addedVertices).toHaveLength(3)
    expect(change.vertices).toHaveLength(9)
    expect(change.vertexCircles).toHaveLength(9)
    expect(change.edges).toHaveLength(4 * change.addedEdges.length)
    const hiding = editor.replace(3, { x: 0, y: 0, r: 3 })
    expect(hiding).toMatchObject({ hidden: Int32Array.of(0), hiders: Int32Array.of(0, 3), replaced: Int32Array.of(3) })
    expect(editor.isHidden(0)).toBe(true)
    expect(editor.nearest(0.1, 0.1)).toBe(3)
    expect(editor.remove(3)).toMatchObject({ shown: Int32Array.of(0), removed: Int32Array.of(3) })
    expect(editor.isHidden(0)).toBe(false)
    expect(editor.circle(3)).toBeUndefined()
    expect(editor.circle(1)).toEqual({ x: 6, y: 0, r: 1 })
    expect(editor.nearest(5, 1, 0)).toBe(1)
    expect(editor.nearest(Number.NaN, 1)).toBe(NONE)
    expect([...editor.ids()]).toEqual([0, 1, 2])
    expect(editor.size()).toBe(3)
    expect(editor.certificate().certified).toBe(true)
  })

  it('brings a removed circle back under its id', () => {
    using editor = library.edit(THREE)
    const diagram = editor.snapshot()
    diagram.apply(editor.remove(1))
    const change = editor.apply([
      { kind: 'insert', circle: [2, 2, 1] },
      { kind: 'insert', circle: [6, 0, 1], id: 1 },
    ])
    expect([...change.inserted]).toEqual([3, 1])
    expectSame(diagram.apply(change), editor.snapshot(), seededRandom(1))
    for (const id of [1, 4, -1, -2, 0.5, Number.NaN, 2 ** 31]) {
      expect(() => editor.apply([{ kind: 'insert', circle: [0, 0, 1], id }])).toThrow(
        expect.objectContaining({ code: 'unknownCircle', message: `There is no removed circle with id ${id}.` }),
      )
    }
  })

  it('continues the ids of another editor', () => {
    using editor = library.edit(THREE, { ids: [2, 5, 7], nextId: 9 })
    expect([...editor.ids()]).toEqual([2, 5, 7])
    const change = editor.apply([
      { kind: 'insert', circle: [9, 9, 1], id: 8 },
      { kind: 'insert', circle: [2, 2, 1] },
    ])
    expect([...change.inserted]).toEqual([8, 9])
    const refusals: [message: string, options: object][] = [
      ['ids must be as many as there are circles: 3, not 2.', { ids: [1, 2] }],
      ['ids must be whole numbers from 0 to 2147483646 in increasing order; 1 is not.', { ids: [1, 1, 2] }],
      ['nextId must be above all ids: at least 3, not 2.', { nextId: 2 }],
    ]
    for (const [message, options] of refusals) {
      expect(() => library.edit(THREE, options)).toThrow(expect.objectContaining({ code: 'badOption', message }))
    }
  })

  it('tells each change before its method returns', () => {
    using editor = library.edit([])
    const told: Change[] = []
    editor.onchange = (change) => told.push(change)
    const made = [
      editor.insert([0, 0, 1]),
      editor.apply([{ kind: 'replace', id: 0, circle: [1, 1, 1] }]),
      editor.remove(0),
    ]
    expect(told).toEqual(made)
    expect(told.map(({ revision }) => revision)).toEqual([1, 2, 3])
  })

  it('makes its change where a listener throws, which is an uncaught error', () => {
    using editor = library.edit([])
    editor.onchange = () => {
      throw new RangeError('mine')
    }
    const later: (() => void)[] = []
    vi.stubGlobal('queueMicrotask', (act: () => void) => later.push(act))
    expect([...editor.insert([0, 0, 1]).inserted]).toEqual([0])
    vi.unstubAllGlobals()
    expect(editor.size()).toBe(1)
    expect(later).toHaveLength(1)
    expect(later[0]).toThrow(new RangeError('mine'))
  })

  it('makes a snapshot that is what compute makes, and does not follow', () => {
    const random = seededRandom(9)
    const circles = Array.from({ length: 300 }, () => someCircle(random, false))
    using editor = library.edit(library.compute(circles))
    for (let i = 0; i < 50; i++) edited(editor, someEdit(random, false, editor))
    const snapshot = editor.snapshot()
    const computed = library.compute(snapshot.circles)
    const numbers = {
      revision: 0,
      circles: snapshot.numbers.circles,
      vertices: new Int32Array(),
      edges: new Int32Array(),
      hiders: new Int32Array(),
    }
    expect(contentOf(snapshot)).toEqual(contentOf({ ...computed, numbers }))
    expect(snapshot.hidden).toEqual(computed.hidden)
    expect(snapshot.hull).toEqual(computed.hull)
    const before = contentOf(snapshot)
    editor.remove(snapshot.numbers.circles[0] as number)
    expect(contentOf(snapshot)).toEqual(before)
  })

  it('starts the hull with its smallest step, though a circle is there several times', () => {
    // A circle whose neighbors hardly reach beyond it.
    const around = [0, 1, 2, 3, 4].map((k) => [10 * Math.cos(1.2 * k), 10 * Math.sin(1.2 * k), 0.5] as const)
    const isOften = (hull: Int32Array) => hull.filter((circle) => circle === 0).length > 1
    for (let last = 0; last < 5; last++) {
      const others = around.filter((_, k) => k !== last)
      for (let turn = 0; turn < 4; turn++) {
        using editor = library.edit([[0, 0, 10], ...others.slice(turn), ...others.slice(0, turn)])
        const diagram = editor.snapshot()
        diagram.apply(editor.insert(around[last] as readonly [number, number, number]))
        expect(isOften(diagram.hull)).toBe(true)
        expect(diagram.hull).toEqual(editor.snapshot().hull)
      }
    }
  })

  it('refuses without a trace', () => {
    using editor = library.edit(THREE)
    const before = contentOf(editor.snapshot())
    const called = vi.fn()
    editor.onchange = called
    const refusals: [string, number | undefined, () => unknown][] = [
      ['unknownCircle', 7, () => editor.remove(7)],
      ['unknownCircle', undefined, () => editor.remove(-1)],
      ['unknownCircle', 3, () => editor.replace(3, [0, 0, 1])],
      ['unknownCircle', 9, () => editor.isHidden(9)],
      ['unknownCircle', 1, () => editor.apply([1, 1].map((id) => ({ kind: 'remove', id })))],
      [
        'negativeRadius',
        2,
        () =>
          editor.apply([
            { kind: 'insert', circle: [1, 1, 1] },
            { kind: 'replace', id: 2, circle: [0, 0, -1] },
          ]),
      ],
    ]
    for (const [code, circle, act] of refusals) expect(act).toThrow(expect.objectContaining({ code, circle }))
    expect(editor.circle(NONE)).toBeUndefined()
    expect(contentOf(editor.snapshot())).toEqual(before)
    expect(called).not.toHaveBeenCalled()
    expect(editor.insert([0, 0, 1]).inserted).toEqual(Int32Array.of(3))
  })

  it('answers nothing once it is disposed of', () => {
    const editor = library.edit(THREE)
    const kept = editor.snapshot()
    editor.dispose()
    editor.dispose()
    for (const act of [
      () => editor.insert([0, 0, 1]),
      () => editor.remove(0),
      () => editor.replace(0, [0, 0, 1]),
      () => editor.apply([]),
      () => editor.nearest(0, 0),
      () => editor.circle(0),
      () => editor.isHidden(0),
      () => editor.ids(),
      () => editor.size(),
      () => editor.snapshot(),
      () => editor.certificate(),
    ]) {
      expect(act).toThrow(expect.objectContaining({ code: 'badInput' }))
    }
    expect(kept.find(5, 1)).toBe(1)
  })
})

it('an editor is freed once it is disposed of or no longer used', async () => {
  const held = new Map<unknown, number>()
  let free = (_: number) => {}
  vi.stubGlobal(
    'FinalizationRegistry',
    class {
      constructor(callback: (address: number) => void) {
        free = callback
      }
      register(target: WeakKey, address: number, token: unknown) {
        expect(token).toBe(target)
        held.set(token, address)
      }
      unregister(token: unknown) {
        held.delete(token)
      }
    },
  )
  const { edit } = await loadCircleVoronoi()
  vi.unstubAllGlobals()
  const editors = [edit(THREE), edit(THREE)] as const
  expect([...held.keys()]).toEqual(editors)
  editors[0].dispose()
  editors[0][Symbol.dispose]()
  expect([...held.keys()]).toEqual([editors[1]])
  free([...held.values()][0] as number)
  // The memory is used again.
  for (const end of [(one: DiagramEditor) => one.dispose(), (one: DiagramEditor) => free(held.get(one) as number)]) {
    const addresses = new Set<number | undefined>()
    for (let k = 0; k < 50; k++) {
      const one = edit(THREE)
      addresses.add(held.get(one))
      end(one)
    }
    expect(addresses.size).toBeLessThan(20)
  }
})

describe('an editor of additive weights', () => {
  /** A scripted circle with a different radius, of either sign. */
  const lowered = ({ x, y, r }: Circle): Circle => ({ x, y, r: 2 * r - 1.5 })
  const loweredEdit = (edit: Edit): Edit =>
    edit.kind === 'remove' ? edit : { ...edit, circle: lowered(edit.circle as Circle) }

  it('makes of 1,000 random scripts what compute makes of their circles', () => {
    for (let seed = 1; seed <= 1000; seed++) {
      const random = seededRandom(seed)
      const isOnGrid = seed % 2 === 0
      const count = seed % 9
      const circles = Array.from({ length: count }, () => lowered(someCircle(random, isOnGrid)))
      using editor = library.edit(circles, { weights: true })
      const diagram = editor.snapshot()
      for (let i = 0; i < 6; i++) {
        // Some edits come in batches, which may be refused as a whole.
        const edits = Array.from({ length: i === 3 ? 4 : 1 }, () => loweredEdit(someEdit(random, isOnGrid, editor)))
        try {
          diagram.apply(edits.length > 1 ? editor.apply(edits) : edited(editor, edits[0] as Edit))
        } catch (error) {
          expect(error).toMatchObject({ code: 'unknownCircle' })
        }
      }
      const ids = editor.ids()
      const weighted = Array.from(ids, (id) => editor.circle(id) as Circle)
      const computed = library.compute(weighted, { weights: true })
      const none = new Int32Array()
      const named = { ...computed, numbers: { revision: 0, circles: ids, vertices: none, edges: none } }
      expect(contentOf(diagram), `seed ${seed}`).toEqual(contentOf(named))
      expectSame(diagram, editor.snapshot(), random)
    }
  })

  it('takes those of a diagram, if not told otherwise, and of traced edits', () => {
    const circles = Float64Array.of(0, 0, -1, 6, 0, 1, 0, 8, -2)
    const diagram = library.compute(circles, { weights: true })
    using editor = library.edit(diagram)
    expect(editor.insert({ x: 3, y: 3, r: -4 }).circles).toEqual(Float64Array.of(3, 3, -4))
    expect(editor.snapshot().weights).toBe(true)
    const negative = expect.objectContaining({ code: 'negativeRadius', circle: 0 })
    expect(() => library.edit(diagram, { weights: false })).toThrow(negative)
    const far = expect.objectContaining({ code: 'coordinateTooLarge', circle: undefined })
    expect(() => editor.insert({ x: 3, y: 3, r: -1e29 })).toThrow(far)
    const edits: Edit[] = [{ kind: 'insert', circle: [3, 3, -4] }]
    const trace = library.trace(circles, { edits, weights: true })
    expect(contentOf(trace.diagram as DiagramSnapshot)).toEqual(contentOf(editor.snapshot()))
  })
})
