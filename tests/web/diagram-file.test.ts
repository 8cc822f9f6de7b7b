// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { Diagram, type DiagramFile, fromJSON } from '../../web/lib/index.ts'
import { loadMetrics } from '../../web/lib/metrics.ts'
import { anyCircles } from './arbitrary-circles.ts'
import { errorOf, problemOf } from './errors.ts'
import { library } from './library.ts'

const THREE = [
  [0, 0, 1],
  [6, 0, 1],
  [0, 8, 1],
]

/** The arrays of a diagram, without the signs of zeros. */
function arraysOf(diagram: Diagram) {
  const { metric, weights, circles, vertices, vertexCircles, edges, hidden, hull, nextSide, vertexSides, firstSide } =
    diagram
  const [unsignedCircles, unsignedVertices] = [circles, vertices].map((array) => array.map((value) => value + 0))
  return {
    ...{ metric, weights, circles: unsignedCircles, vertices: unsignedVertices, vertexCircles, edges, hidden, hull },
    ...{ nextSide, vertexSides, firstSide },
  }
}

describe('a diagram as JSON', () => {
  it('is one again, to the bit, and certified anew', () => {
    fc.assert(
      fc.property(anyCircles, (input) => {
        const diagram = library.compute(input)
        const read = fromJSON(JSON.stringify(diagram))
        expect(arraysOf(read)).toEqual(arraysOf(diagram))
        expect(read.stats).toEqual(diagram.stats)
        expect(read.certificate.certified).toBe(false)
        expect(library.certify(read)).toEqual(diagram.certificate)
        expect(read.render()).toBe(diagram.render())
      }),
      { numRuns: 200 },
    )
  })

  it('has the keys of the format', () => {
    const file = JSON.parse(JSON.stringify(library.compute(THREE)))
    expect(Object.keys(file)).toEqual(['format', 'version', 'circles', 'hidden', 'vertices', 'edges', 'hull', 'stats'])
    expect(file.vertices).toEqual([{ x: 3, y: 4, r: 4, circles: expect.arrayContaining([0, 1, 2]) }])
    expect(file.edges).toHaveLength(3)
    expect(file.stats.certificate).toEqual(library.compute(THREE).certificate)
  })

  it('keeps another distance', async () => {
    const { compute } = await loadMetrics({ library })
    const given = [...THREE, [0, 0, 0.5]]
    const powers = [
      [0, 0, -(2 ** 191)],
      [6, 0, 2 ** 192],
      [0, 8, 2 ** -192],
      [1, 1, 0],
    ]
    for (const diagram of [
      compute(given, { metric: 'centers' }),
      compute(powers.slice(2), { metric: 'centers', weights: true }),
      compute(given, { metric: 'power' }),
      compute(powers, { metric: 'power', weights: true }),
    ]) {
      expect(arraysOf(fromJSON(JSON.stringify(diagram)))).toEqual(arraysOf(diagram))
    }
    const file = compute(powers, { metric: 'power', weights: true }).toJSON()
    const circles = [{ x: 0, y: 0, r: 2 ** 193 }]
    expect(errorOf(() => fromJSON({ ...file, circles } as object))).toMatchObject({
      code: 'coordinateTooLarge',
      circle: 0,
    })
  })

  it('may have been parsed, and have more than it needs and fewer stats', () => {
    const { stats: _, ...file } = library.compute(THREE).toJSON()
    const read = fromJSON({ ...file, more: 1 })
    expect(read.stats.way).toBe('')
    expect(read.stats.counts.circles).toBe(0)
    const odd = fromJSON({
      ...file,
      stats: { method: 7, way: 'flip', counts: { flips: 3, events: '2', odd: 1 } },
    })
    expect(odd.stats).toMatchObject({ method: '', way: 'flip', counts: { flips: 3, events: 0 } })
    expect(odd.stats.counts).not.toHaveProperty('odd')
  })

  it('is refused in one sentence where it is none', () => {
    const file = library.compute([...THREE, [0, 0, 0.5]]).toJSON()
    const [vertex] = file.vertices
    const [edge] = file.edges
    const lists = ['circles', 'hidden', 'vertices', 'edges', 'hull'] as const
    const wrong: unknown[] = [
      ...lists.flatMap((list) => [undefined, {}, [null]].map((value) => ({ ...file, [list]: value }))),
      ...['circles', 'vertices'].flatMap((list) =>
        ['x', 'y', 'r'].flatMap((name) =>
          [undefined, '1', Infinity, Number.NaN].map((value) => ({
            ...file,
            [list]: [{ x: 0, y: 0, r: 0, circles: [0, 0, 0], [name]: value }],
          })),
        ),
      ),
      ...[1, 'no'].map((weights) => ({ ...file, weights })),
      ...[0, 2].map((version) => ({ ...file, version })),
      { ...file, metric: 'taxi' },
      ...[
        [0, 1],
        [0, 0, 0],
        [-2, 0],
      ].map((vertices) => ({ ...file, edges: [{ ...edge, vertices }] })),
      ...[[0], [0, -1]].map((circles) => ({ ...file, edges: [{ ...edge, circles }] })),
      ...[
        [0, 1],
        [0, 1, 4],
      ].map((circles) => ({ ...file, vertices: [{ ...vertex, circles }] })),
      { ...file, hidden: [{ circle: 3, by: 4 }] },
      { ...file, hidden: [{ circle: 4, by: 0 }] },
      { ...file, hidden: [{ circle: 3, by: -1 }] },
      { ...file, hull: [0.5] },
      ...['{"format"', null, '[]', {}],
    ]
    for (const json of wrong)
      expect(errorOf(() => fromJSON(json as object)).code, JSON.stringify(json)).toBe('badInput')
    const ofCircle = (circle: object) =>
      errorOf(() => fromJSON({ ...file, circles: [...file.circles.slice(0, 3), circle] } as object))
    expect(ofCircle({ x: 0, y: 0, r: -1 })).toMatchObject({ code: 'negativeRadius', circle: 3 })
    for (const name of ['x', 'y', 'r']) {
      const beyond = (value: number) => ({ x: 0, y: 0, r: 1, [name]: value })
      expect(ofCircle(beyond(1e29))).toMatchObject({ code: 'coordinateTooLarge', circle: 3 })
      const circles = [...file.circles.slice(0, 3), beyond(2 ** 96)]
      expect(fromJSON({ ...file, circles } as object).circles).toContain(2 ** 96)
    }
    expect(ofCircle({ x: 0, y: -1e29, r: 1 })).toMatchObject({ code: 'coordinateTooLarge', circle: 3 })
    const far = [...file.circles.slice(0, 3), { x: 0, y: 0, r: -1e29 }]
    expect(errorOf(() => fromJSON({ ...file, weights: true, circles: far } as object)).code).toBe('coordinateTooLarge')
  })

  it('has numbers in the range of compute', () => {
    for (const x of [0, 2 ** -56, 2 ** -57, 1e-30, 5e-324]) {
      const circles = [
        { x, y: 0, r: 0 },
        { x: 0, y: -x, r: 0 },
      ]
      const problem = problemOf(() => library.compute(circles))
      expect(problemOf(() => fromJSON({ ...library.compute([]).toJSON(), circles }))).toBe(problem)
      expect(problem === 'no problem').toBe(x === 0 || x === 2 ** -56)
    }
  })

  it('has types', () => {
    const file: DiagramFile = library.compute(THREE).toJSON()
    expect(fromJSON(file).vertices).toHaveLength(3)
  })
})

describe('a structured clone of a diagram', () => {
  it('gets its methods back from new Diagram', () => {
    const diagram = library.compute(THREE)
    const clone = new Diagram(structuredClone(diagram))
    expect(arraysOf(clone)).toEqual(arraysOf(diagram))
    expect(clone.certificate).toEqual(diagram.certificate)
    expect(clone.find(5, 1)).toBe(1)
  })
})
