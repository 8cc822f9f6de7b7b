// SPDX-License-Identifier: GPL-3.0-or-later
// The figures that the tutorial draws itself: what they show is so.
import { describe, expect, it, test } from 'vitest'
import { loadFigureCircles } from '../../scripts/texts/figure-circles.mjs'
import { readBook } from '../../scripts/texts/tutorial.mjs'
import { CORRUPTIONS } from '../../web/tutorial/corruptions.ts'
import { frontOf, grow, tellMoment } from '../../web/tutorial/drawn/growing.ts'
import { KINDS, type KindName } from '../../web/tutorial/drawn/kinds.ts'
import { paintCones } from '../../web/tutorial/drawn/paint-cones.ts'
import { coordinatesOf, distance, nearest, type Scene } from '../../web/tutorial/drawn/scene.ts'
import { type DrawnSpec, sceneOf } from '../../web/tutorial/drawn.ts'
import { shrunkenRims, stepsBetween } from '../../web/tutorial/extras.ts'
import { library, seededRandom } from './library.ts'

const circlesOf = await loadFigureCircles()
const SPECS = readBook().flatMap(({ blocks }) =>
  blocks.filter(({ spec }) => spec.name !== undefined).map(({ kind, spec }) => ({ block: kind, ...spec })),
)

function specOf(name: string) {
  const spec = SPECS.find((each) => each.name === name)
  if (spec === undefined) throw new Error(`There is no figure ${name}.`)
  return spec
}

function drawnScene(name: string): Scene {
  const spec = specOf(name)
  return sceneOf({ ...spec, circles: circlesOf(spec) } as unknown as DrawnSpec)
}

const drawn = SPECS.filter(({ block }) => block === 'drawn').map(({ name, kind }) => [name, kind as KindName] as const)

test.each(drawn)('%s is drawn at each place of its slider, with words', (name, kind) => {
  const scene = drawnScene(name)
  const { last } = KINDS[kind].range(scene, library)
  expect(last).toBeGreaterThan(0)
  for (const value of [0, last / 3, Math.floor(last / 2), last]) {
    const { content, told } = KINDS[kind].draw(scene, value, library)
    expect(content).toContain('<circle')
    expect(content).not.toMatch(/NaN|undefined|Infinity/)
    expect(told).toMatch(/^[A-Z0-9].*\.$/)
  }
})

describe('the growing phase', () => {
  const scene = drawnScene('growing-discs')
  const { trace, moments } = grow(scene.circles, library)
  const told = moments.map((moment) => tellMoment(trace, moment, scene.circles))

  it('has discs that begin borders, discs that a circle rejects, and vertices where a border ends and where one begins', () => {
    const kinds = new Set(moments.map(({ what }) => what))
    expect([...kinds].sort()).toEqual(['begin', 'end', 'notEmpty', 'stale', 'start', 'used', 'vertex'])
    expect(told.filter((text) => / circle \d reaches into the disc .* thrown away/.test(text)).length).toBeGreaterThan(
      0,
    )
    expect(
      told.filter((text) => /2 borders end there: .* A new border begins there: \d→\d\./.test(text)).length,
    ).toBeGreaterThan(0)
    expect(told.filter((text) => /touches circle \d where another border/.test(text)).length).toBeGreaterThan(0)
    expect(told.filter((text) => /3 borders end there/.test(text)).length).toBeGreaterThan(0)
  })

  it('takes the discs in the order of their radii', () => {
    const radii = moments.slice(1, -1).map(({ r }) => r)
    expect(radii).toEqual([...radii].sort((one, other) => one - other))
  })

  it('needs no samples', () => {
    expect(trace.at(trace.length).samples).toHaveLength(0)
    expect(told.join(' ')).not.toMatch(/sample|Delaunay|foot/)
  })

  it('draws the reason: the circle that is met, the new arrow, and the vertex', () => {
    const contentAt = (what: string) => {
      const k = moments.findIndex((moment) => moment.what === what)
      return KINDS.growing.draw(scene, k, library).content
    }
    expect(contentAt('notEmpty')).toMatch(/class="touching bad".*class="met"/)
    expect(contentAt('used')).toMatch(/class="[^"]*passed/)
    expect(contentAt('begin')).toMatch(/class="arrow fresh"/)
    expect(contentAt('vertex')).toMatch(/class="touching good".*class="[^"]*vertex/)
  })
})

test('a directed edge has its border on its right', () => {
  const [a, b] = [
    { x: 0, y: 0, r: 2 },
    { x: 7, y: 1, r: 1 },
  ]
  const least = (Math.hypot(7, 1) - 3) / 2
  for (const r of [least + 0.1, least + 1, least + 20]) {
    const front = frontOf(a, b, r)
    if (front === undefined) throw new Error('There is a disc of this radius.')
    for (const circle of [a, b]) expect(distance(circle, front)).toBeCloseTo(r, 9)
    // Less than 0: clockwise, on the right.
    expect(b.x * front.y - b.y * front.x).toBeLessThan(0)
  }
  expect(frontOf(a, b, least - 0.1)).toBeUndefined()
})

test('the first figure of the tutorial says how far it is to each circle, and which one is nearest', () => {
  const scene = drawnScene('one-point')
  expect(scene.circles).toHaveLength(3)
  const { told, content } = KINDS.nearest.draw(scene, 0, library)
  const first = nearest(scene.circles, scene.point as NonNullable<typeof scene.point>)
  expect(told).toMatch(new RegExp(`Circle ${first} is nearest\\.$`))
  expect(content.match(/class="way/g)).toHaveLength(3)
  // At the end of the slider all points have a color.
  const { last } = KINDS.nearest.range(scene, library)
  expect(KINDS.nearest.draw(scene, last, library).content.match(/class="cell /g)).toHaveLength(3)
})

test('on a walk the distance to the nearest circle never rises faster than the walk', () => {
  const scene = drawnScene('walk')
  const [start] = scene.circles as [(typeof scene.circles)[number]]
  for (const value of [0, 0.2, 0.5, 0.8, 1]) {
    const { told } = KINDS.walk.draw(scene, value, library)
    const [, f, bound] = /f is (−?[\d.]+)\. .* would be (−?[\d.]+)\.$/.exec(told) as unknown as [string, string, string]
    expect(Number(f.replace('−', '-'))).toBeLessThanOrEqual(Number(bound.replace('−', '-')) + 0.01)
    if (value === 0) expect(Number(f.replace('−', '-'))).toBeCloseTo(-start.r, 2)
  }
})

test('fewer cells of a tile are final where larger circles may lie outside', () => {
  const scene = drawnScene('final')
  const counts = [0, 0.5, 1.5, 3].map((value) => {
    const { told } = KINDS.final.draw(scene, value, library)
    return Number(/(\d+) of \d+ cells/.exec(told)?.[1])
  })
  expect(counts[0]).toBeGreaterThan(counts[3] as number)
  expect(counts).toEqual([...counts].sort((one, other) => other - one))
  expect(counts[3]).toBeGreaterThan(0)
})

test('cones seen from above are the diagram', () => {
  const { circles = [], view = [0, 0, 1] } = specOf('cones')
  const [width, height] = [80, 50]
  const pixels = paintCones(circles, view, { tilt: 90, turn: 0 }, width, height)
  const colors = [
    [63, 127, 191],
    [224, 160, 48],
    [60, 154, 124],
    [201, 104, 143],
    [107, 102, 184],
    [217, 104, 60],
  ]
  const list = circles.map(([x = 0, y = 0, r = 0]) => ({ x, y, r }))
  const random = seededRandom(3)
  let compared = 0
  for (let n = 0; n < 400; n++) {
    const [column, row] = [Math.floor(width * random()), Math.floor(height * random())]
    const scale = width / view[2]
    const at = { x: view[0] + (column + 0.5 - width / 2) / scale, y: view[1] - (row + 0.5 - height / 2) / scale }
    const i = nearest(list, at)
    const sorted = list.map((circle) => distance(circle, at)).sort((one, other) => one - other)
    // Beside a border or a rim the pixel may be a line's.
    if ((sorted[1] as number) - (sorted[0] as number) < 1 || Math.abs(sorted[0] as number) < 0.5) continue
    const k = 4 * (row * width + column)
    const white = (sorted[0] as number) <= 0 ? 0 : 0.62
    for (const [c, value] of (colors[i] as number[]).entries()) {
      expect(Math.abs((pixels[k + c] as number) - (value * (1 - white) + 250 * white))).toBeLessThan(25)
    }
    compared += 1
  }
  expect(compared).toBeGreaterThan(50)
})

test('shrunken rims are the rims on which samples lie', () => {
  const circles = Float64Array.from([0, 0, 3, 10, 1, 1.5, 4, 9, 2])
  const rims = shrunkenRims(circles)
  expect([...rims]).toEqual([0, 0, 1.5, 10, 1, 0, 4, 9, 0.5])
  const trace = library.trace(circles)
  for (const k of trace.at(trace.length).samples) {
    const { disc, circles: ids } = trace.event(k)
    const i = ids[0] as number
    const away = Math.hypot((disc?.x ?? 0) - (rims[3 * i] ?? 0), (disc?.y ?? 0) - (rims[3 * i + 1] ?? 0))
    expect(away).toBeCloseTo(rims[3 * i + 2] as number, 9)
  }
})

test('six steps are drawn from center to center', () => {
  const spec = specOf('layers-between')
  const circles = coordinatesOf(circlesOf(spec).map(([x = 0, y = 0, r = 0]) => ({ x, y, r })))
  const [from = -1, to = -1] = spec.stepsBetween ?? []
  const diagram = library.compute(circles)
  expect([...diagram.neighbors(from)]).toContain(to)
  expect(stepsBetween(library, circles, from, to)).toHaveLength(7)
})

describe('wrong diagrams for the judge', () => {
  const { circles = [] } = specOf('corrupt')
  const right = library.compute(circles)
  const flaws = [
    'vertexMisplaced',
    'vertexWithoutDisc',
    'edgeOutOfOrder',
    'cellNotClosed',
    'adjacency',
    'eulerCount',
    'hiddenWithoutHider',
  ]

  it('are one for each check', () => {
    expect(library.certify(right).certified).toBe(true)
    expect(CORRUPTIONS.map((corruption) => library.certify(corruption.make(right, library) ?? right).flaw)).toEqual(
      flaws,
    )
    // As they are where a reader has dragged a circle.
    const random = seededRandom(5)
    for (let n = 0; n < 10; n++) {
      const k = 3 * (n % 5)
      const dragged = Float64Array.from(right.circles)
      dragged.set([(dragged[k] as number) + random() - 0.5, (dragged[k + 1] as number) + random() - 0.5], k)
      const diagram = library.compute(dragged)
      const found = CORRUPTIONS.map((corruption) => library.certify(corruption.make(diagram, library) ?? diagram).flaw)
      expect(found, `${n}`).toEqual(diagram.hidden.length > 0 ? flaws : [...flaws.slice(0, -1), 'none'])
    }
    for (const check of ['Vertices', 'Edges', 'Cells', 'Counts', 'Hidden circles']) {
      expect(CORRUPTIONS.some(({ about }) => about.startsWith(`${check}:`))).toBe(true)
    }
  })
})
