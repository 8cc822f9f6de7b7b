// SPDX-License-Identifier: GPL-3.0-or-later
// The half-edges of diagrams and of their duals.
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { linkSides } from '../../web/lib/diagram/link-sides.ts'
import { type Diagram, NONE } from '../../web/lib/index.ts'
import { KINDS } from './arbitrary-circles.ts'
import { library } from './library.ts'

function sidesOf({ edges }: Diagram): number[] {
  return Array.from({ length: edges.length / 2 }, (_, side) => side)
}

describe.each(Object.entries(KINDS))('sides of the diagram of circles that are %s', (_, arbitrary) => {
  it('go around each cell once, on its left, and meet where they say', () => {
    fc.assert(
      fc.property(arbitrary, (circles) => {
        const diagram = library.compute(circles)
        const { cells, nextSide, firstSide, edges } = diagram
        const met = new Set<number>()
        for (let i = 0; i < circles.length / 3; i++) {
          const sides = cells.sides(i)
          expect(sides[0] ?? NONE).toBe(firstSide[i])
          if (sides.length > 0) expect(Math.min(...sides)).toBe(firstSide[i])
          sides.forEach((side, k) => {
            expect(met.has(side)).toBe(false)
            met.add(side)
            const next = sides[(k + 1) % sides.length] as number
            expect(nextSide[side]).toBe(next)
            expect(cells.circleOf(side)).toBe(i)
            // The next side continues through a vertex, or across infinity.
            expect(cells.targetOf(side)).toBe(cells.originOf(next))
          })
        }
        expect(met.size).toBe(edges.length / 2)
      }),
    )
  })

  it('have twins, which are theirs and run back on the other side', () => {
    fc.assert(
      fc.property(arbitrary, (circles) => {
        const diagram = library.compute(circles)
        const { cells, edges } = diagram
        for (const side of sidesOf(diagram)) {
          const twin = side ^ 1
          expect(twin ^ 1).toBe(side)
          expect([cells.circleOf(twin), cells.neighborOf(twin)]).toEqual([cells.neighborOf(side), cells.circleOf(side)])
          expect([cells.originOf(twin), cells.targetOf(twin)]).toEqual([cells.targetOf(side), cells.originOf(side)])
          const [left, right, start, end] = edges.subarray(4 * (side >> 1), 4 * (side >> 1) + 4)
          expect([cells.circleOf(side), cells.originOf(side)]).toEqual(side % 2 === 0 ? [left, start] : [right, end])
          const [curve, back] = [cells.curveOf(side), cells.curveOf(twin)]
          expect([curve.start, curve.end]).toEqual([back.end, back.start])
          expect([curve.bisector.left, curve.bisector.a]).toEqual([back.bisector.right, -back.bisector.a])
        }
      }),
    )
  })

  it('leave each vertex three by three, one for each of its circles', () => {
    fc.assert(
      fc.property(arbitrary, (circles) => {
        const diagram = library.compute(circles)
        const { cells, vertexSides, vertexCircles, nextSide } = diagram
        vertexSides.forEach((side, slot) => {
          expect(cells.originOf(side)).toBe(Math.floor(slot / 3))
          expect(cells.circleOf(side)).toBe(vertexCircles[slot])
          // The side that enters beside it continues in the cell on its right, which belongs to the previous circle of
          // the vertex.
          const before = slot % 3 === 0 ? slot + 2 : slot - 1
          expect(nextSide[side ^ 1]).toBe(vertexSides[before])
        })
        expect(new Set(vertexSides).size).toBe(vertexSides.length)
      }),
    )
  })

  it('are linked again as they were', () => {
    fc.assert(
      fc.property(arbitrary, (circles) => {
        const diagram = library.compute(circles)
        const { nextSide, vertexSides, firstSide } = diagram
        expect(linkSides(diagram)).toEqual({ nextSide, vertexSides, firstSide })
      }),
    )
  })

  it('have half-edges of the dual across them: opposite is opposite, and three make a triangle', () => {
    fc.assert(
      fc.property(arbitrary, (circles) => {
        const diagram = library.compute(circles)
        const { triangles, halfedges, cells, hull } = diagram
        expect(halfedges).toHaveLength(triangles.length)
        const next = (half: number) => (half % 3 === 2 ? half - 2 : half + 1)
        let open = 0
        halfedges.forEach((opposite, half) => {
          if (opposite === NONE) {
            open += 1
            return
          }
          expect(opposite).not.toBe(half)
          expect(halfedges[opposite]).toBe(half)
          expect([triangles[opposite], triangles[next(opposite)]]).toEqual([triangles[next(half)], triangles[half]])
        })
        const unbounded = sidesOf(diagram).filter((side) => cells.originOf(side) === NONE)
        const lines = unbounded.filter((side) => cells.targetOf(side) === NONE).length
        expect(open).toBe(unbounded.length - lines)
        expect(unbounded).toHaveLength(hull.length > 1 ? hull.length : 0)
        expect(diagram.halfedges).toBe(halfedges)
      }),
    )
  })
})

describe('parts that do not fit together', () => {
  const diagram = library.compute(Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1, 7, 7, 2))
  const { circles, vertexCircles, edges, hull } = diagram
  const parts = { circles, vertexCircles, edges, hull }
  const changed = (array: Int32Array, k: number, value: number) => array.map((old, i) => (i === k ? value : old))
  const isLinked = (wrong: Partial<typeof parts>) => {
    const { nextSide, vertexSides, firstSide } = linkSides({ ...parts, ...wrong } as typeof parts)
    const all = [...nextSide, ...vertexSides, ...firstSide]
    expect(all.every((value) => value === NONE)).toBe(all.includes(NONE))
    return !all.includes(NONE)
  }

  it('have no next sides at all', () => {
    expect(isLinked({})).toBe(true)
    expect(isLinked({ hull: hull.toReversed() as typeof hull })).toBe(false)
    expect(isLinked({ hull: hull.slice(1) as typeof hull })).toBe(false)
    expect(isLinked({ hull: new Int32Array(0) as typeof hull })).toBe(false)
    expect(isLinked({ hull: changed(hull, 0, hull[1] as number) as typeof hull })).toBe(false)
    for (let k = 0; k < vertexCircles.length; k++) {
      const other = [0, 1, 2, 3].find((i) => !vertexCircles.subarray(k - (k % 3), k - (k % 3) + 3).includes(i))
      expect(isLinked({ vertexCircles: changed(vertexCircles, k, other as number) as typeof vertexCircles })).toBe(
        false,
      )
    }
    const mirrored = vertexCircles.map((_, k) => vertexCircles[k + 2 - 2 * (k % 3)] as number)
    expect(isLinked({ vertexCircles: mirrored as typeof vertexCircles })).toBe(false)
    // A vertex without edges, an edge twice, and two lines between two circles.
    expect(isLinked({ vertexCircles: Int32Array.of(...vertexCircles, 0, 1, 2) })).toBe(false)
    for (let e = 0; e < edges.length; e += 4) {
      expect(isLinked({ edges: Int32Array.of(...edges, ...edges.subarray(e, e + 4)) })).toBe(false)
    }
    const two = {
      circles: Float64Array.of(0, 0, 1, 6, 0, 1),
      vertexCircles: new Int32Array(),
      hull: Int32Array.of(0, 1),
    }
    const line = [0, 1, NONE, NONE]
    expect(isLinked({ ...two, edges: Int32Array.of(...line) })).toBe(true)
    const twice = { hull: Int32Array.of(0, 1, 0, 1), edges: Int32Array.of(...line, ...line) }
    expect(isLinked({ ...two, ...twice })).toBe(false)
    for (let e = 0; e < edges.length; e += 4) {
      const swapped = edges.slice()
      swapped.set([edges[e + 1] as number, edges[e] as number], e)
      expect(isLinked({ edges: swapped as typeof edges })).toBe(false)
      for (const k of [e + 2, e + 3]) {
        const end = edges[k] === NONE ? 0 : NONE
        expect(isLinked({ edges: changed(edges, k, end) as typeof edges })).toBe(false)
      }
    }
  })
})
