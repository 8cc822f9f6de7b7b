// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a wrong diagram: its own edges and vertices, and a mark on the part that the judge rejects.
import { expect, test } from 'vitest'
import { claimedLayer, flawOf, markedLayer, markedVertex } from '../../web/tutorial/claimed-diagram.ts'
import { CORRUPTIONS } from '../../web/tutorial/corruptions.ts'
import { library } from './library.ts'

const CIRCLES = [
  [0, 0, 3],
  [10, 1, 1.5],
  [4, 9, 2],
  [13, 9, 0.8],
  [6.2, 4, 0.4],
  [1.6, 1.1, 0.7],
] as const
const right = library.compute(CIRCLES)

/** The marks for each wrong diagram, by its flaw. */
const marked = Object.fromEntries(
  CORRUPTIONS.map((corruption) => {
    const wrong = corruption.make(right, library)
    if (wrong === undefined) throw new Error(corruption.name)
    const certificate = library.certify(wrong)
    return [certificate.flaw, { wrong, certificate, flaw: flawOf(wrong, certificate) }]
  }),
)
const of = (flaw: string) => {
  const found = marked[flaw]
  if (found === undefined) throw new Error(flaw)
  return found
}

test('the flaw is the part that the certificate names', () => {
  const misplaced = of('vertexMisplaced')
  expect(misplaced.flaw).toEqual({ circles: [...misplaced.wrong.vertexCircles.slice(0, 3)], vertices: [0], edges: [] })
  const { certificate, wrong, flaw } = of('edgeOutOfOrder')
  expect(flaw.edges).toEqual([certificate.edge])
  expect(flaw.circles).toEqual([...wrong.edges.slice(4 * certificate.edge, 4 * certificate.edge + 2)])
  expect(of('cellNotClosed').flaw.circles).toEqual([of('cellNotClosed').certificate.circle])
})

test('a circle whose cell was left out is marked, and a hidden circle with its hider', () => {
  expect(of('eulerCount').flaw.circles).toEqual([4])
  const { wrong, flaw } = of('hiddenWithoutHider')
  expect(flaw.circles).toEqual([...wrong.hidden])
})

test('a circle is never said to hide itself', () => {
  const first = library.compute([[1, 1, 0.5], [0, 0, 3], ...CIRCLES.slice(1, 4)])
  const [circle, by] = first.hidden
  expect([circle, by]).toEqual([0, 1])
  for (const { make } of CORRUPTIONS) expect([...(make(first, library)?.hidden ?? [])]).not.toEqual([0, 0])
})

test('edges are drawn from the vertices that the diagram lists, and unbounded ones leave the picture', () => {
  const { wrong } = of('vertexMisplaced')
  const { segments = new Float64Array(), points = new Float64Array() } = claimedLayer(wrong)
  expect(points).toHaveLength(2 * (wrong.vertices.length / 3))
  const ends = Array.from({ length: segments.length / 2 }, (_, k) => `${segments[2 * k]} ${segments[2 * k + 1]}`)
  const moved = `${wrong.vertices[0]} ${wrong.vertices[1]}`
  expect(ends.filter((end) => end === moved)).toHaveLength(3)
  expect(claimedLayer(right).segments).not.toEqual(segments)
  const far = Math.max(...segments.map(Math.abs))
  expect(far).toBeGreaterThan(30)
})

test('a straight line joins ends that are not on the bisector of their edge', () => {
  const { wrong, flaw } = of('edgeOutOfOrder')
  expect(markedLayer(wrong, flaw).segments).toHaveLength(4)
  expect(markedLayer(right, { circles: [], vertices: [], edges: [4] }).segments?.length).toBeGreaterThan(4)
})

test('a marked vertex has its disc and its circles', () => {
  const { points, discs } = markedLayer(right, markedVertex(right, 1))
  expect(points).toEqual(right.vertices.slice(3, 5))
  expect([...(discs ?? [])].slice(-3)).toEqual([...right.vertices.slice(3, 6)])
  expect(discs).toHaveLength(12)
})
