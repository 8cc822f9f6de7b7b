// SPDX-License-Identifier: GPL-3.0-or-later
// The tutorial's own figures show correct diagrams.

import { describe, expect, it, test } from 'vitest'
import { loadFigureCircles } from '../../scripts/texts/figure-circles.mjs'
import { readBook } from '../../scripts/texts/tutorial.mjs'
import type { Circle, Point } from '../../web/lib/index.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { loadSphere } from '../../web/lib/sphere.ts'
import { CORRUPTIONS } from '../../web/tutorial/corruptions.ts'
import { areaOf, areasIn, frameIn, heightOver, stiffnessIn, weighted } from '../../web/tutorial/drawn/areas.ts'
import { seenFromLargest } from '../../web/tutorial/drawn/globe-plane.ts'
import { frontOf, grow, tellMoment } from '../../web/tutorial/drawn/growing.ts'
import { KINDS, type KindName } from '../../web/tutorial/drawn/kinds.ts'
import { stepsOf } from '../../web/tutorial/drawn/newton.ts'
import { coordinatesOf, distance, nearest, Pen, type Scene } from '../../web/tutorial/drawn/scene.ts'
import { distanceTo } from '../../web/tutorial/drawn/sphere.ts'
import { panelsOf, THREE_SHARES } from '../../web/tutorial/drawn/weight-plane.ts'
import { type DrawnSpec, sceneOf } from '../../web/tutorial/drawn.ts'
import { shrunkenRims, stepsBetween } from '../../web/tutorial/extras.ts'
import { library, seededRandom } from './library.ts'
import { box as boxRing } from './shapes.ts'
import { tuple } from './tuples.ts'

const circlesOf = await loadFigureCircles()
const regions = await loadRegions()
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

describe('a point on a border', () => {
  const { grip } = KINDS.hyperbola
  const scene = drawnScene('why-hyperbola')
  const [a, b] = scene.circles as readonly [Circle, Circle]

  it.each([0, 0.2, 0.5, 0.93, 1])(
    'is equally far from both circles at %d, also when it is dragged beside the border',
    (value) => {
      const place = grip?.at(scene, value) as Point
      expect(distance(a, place)).toBeCloseTo(distance(b, place), 9)
      expect(grip?.valueAt(scene, place)).toBeCloseTo(value, 3)
      // It snaps to the nearest place of the border.
      const beside = { x: place.x + 0.4, y: place.y + 0.3 }
      const nearest = grip?.at(scene, grip.valueAt(scene, beside)) as Point
      const away = ({ x, y }: Point) => Math.hypot(x - beside.x, y - beside.y)
      for (let k = 0; k <= 500; k++) expect(away(nearest)).toBeLessThan(away(grip?.at(scene, k / 500) as Point) + 1e-3)
    },
  )

  it('has distances to the centers that differ by the difference of the radii', () => {
    for (const value of [0, 0.4, 0.8]) {
      const { told } = KINDS.hyperbola.draw(scene, value, library)
      const [, to = '', from = '', far = ''] =
        /(\d+\.\d) − (\d+\.\d) = (\d) = radius of a − radius of b = 3 − 1\.$/.exec(told) ?? []
      expect(Number(to) - Number(from)).toBeCloseTo(Number(far), 9)
    }
  })

  it('is nowhere if one circle contains the other', () => {
    const { told, content } = KINDS.hyperbola.draw({ ...scene, circles: [a, { ...a, r: 1 }] }, 0.5, library)
    expect(told).toMatch(/^One circle lies inside the other/)
    expect(content).not.toContain('ghost')
  })
})

test('each rule of the judge that can be broken names the change that it notices', () => {
  for (const { at, text } of specOf('corrupt').rulesShown ?? []) {
    const [, rule] = /^\*\*(.+?)\.\*\*/.exec(text) ?? []
    if (at !== undefined) expect(CORRUPTIONS[at]?.about).toMatch(new RegExp(`^${rule}: `))
  }
})

test.each(drawn)('%s is drawn at each place of its slider, with words', (name, kind) => {
  const scene = drawnScene(name)
  const { last } = KINDS[kind].range(scene, library, regions)
  expect(last).toBeGreaterThan(0)
  for (const value of [0, last / 3, Math.floor(last / 2), last]) {
    const { content, told } = KINDS[kind].draw(scene, value, library, regions)
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

  it('has an event for each of the rules in chapter 3, in their order', () => {
    const rules = specOf('growing-discs').rulesShown ?? []
    expect(rules.map(({ at }) => moments[at as number]?.what)).toEqual(['begin', 'notEmpty', 'used', 'vertex', 'stale'])
  })

  it('takes the discs in the order of their radii', () => {
    const radii = moments.slice(1, -1).map(({ r }) => r)
    expect(radii).toEqual([...radii].sort((one, other) => one - other))
  })

  it('needs no samples', () => {
    expect(trace.at(trace.length).samples).toHaveLength(0)
    expect(told.join(' ')).not.toMatch(/sample|Delaunay|foot/)
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
    // A negative value means clockwise, on the right.
    expect(b.x * front.y - b.y * front.x).toBeLessThan(0)
  }
  expect(frontOf(a, b, least - 0.1)).toBeUndefined()
  expect(frontOf(a, { ...a }, 5)).toBeUndefined()
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
    const [, f = '', bound = ''] = /f is (−?[\d.]+)\. .* would be (−?[\d.]+)\.$/.exec(told) ?? []
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

describe('circles on a globe', async () => {
  const { computeSphere } = await loadSphere()

  it('keep all cells when their radii become smaller by the same angle', () => {
    const scene = drawnScene('globe-radii')
    const { last } = KINDS['globe-radii'].range(scene, library)
    const cellsAt = (value: number) =>
      KINDS['globe-radii'].draw(scene, value, library).content.match(/<path class="cell rows c\d" d="[^"]*"/g)
    expect(cellsAt(0)).toHaveLength(6)
    for (const value of [last / 3, last / 2, last]) expect(cellsAt(value)).toEqual(cellsAt(0))
  })

  it('have the empty discs of the plane that an eye at the largest one sees', () => {
    const random = seededRandom(3)
    const scenes = [
      drawnScene('globe-plane'),
      ...Array.from(
        { length: 40 },
        (_, k): Scene => ({
          ...drawnScene('globe-plane'),
          circles: Array.from({ length: 3 + (k % 8) }, () => ({
            x: -1.1 + 1.6 * (random() - 0.5),
            y: 1.6 * (random() - 0.5),
            r: 0.3 * random(),
          })),
        }),
      ),
    ]
    for (const scene of scenes) {
      const { caps, eye, names, discs, diagram } = seenFromLargest(scene, library)
      for (const { circles, onGlobe } of discs) {
        const distances = caps.map((cap) => distanceTo(cap, onGlobe.center))
        for (const k of circles) expect(distances[names[k] as number]).toBeCloseTo(onGlobe.r, 9)
        expect(Math.min(...distances)).toBeGreaterThan(onGlobe.r - 1e-9)
      }
      // The vertices of the sphere: those of the plane, and one with the eye for each pair on the hull.
      const degrees = (angle: number) => (angle * 180) / Math.PI
      const places = caps.map(({ center: [x, y, z], r }) => [degrees(Math.atan2(y, x)), degrees(Math.asin(z)), r])
      const { vertexCaps } = computeSphere(places, { radius: 1, weights: true })
      const triples = Array.from({ length: vertexCaps.length / 3 }, (_, v) =>
        [...vertexCaps.subarray(3 * v, 3 * v + 3)].sort((a, b) => a - b).join(),
      )
      const inPlane = discs.map(({ circles }) =>
        circles
          .map((k) => names[k] as number)
          .sort((a, b) => a - b)
          .join(),
      )
      expect(triples.filter((triple) => !triple.split(',').includes(`${eye}`)).sort()).toEqual(inPlane.sort())
      const pairs = diagram.hull.length < 2 ? 0 : diagram.hull.length
      expect(triples).toHaveLength(discs.length + pairs)
    }
  })
})

describe('given areas', () => {
  const BOX = { minX: -7, minY: -6, maxX: 7, maxY: 6 }
  const sites = [
    { x: -4, y: 2, r: 0 },
    { x: 3, y: 3, r: 0 },
    { x: 1, y: -4, r: 0 },
    { x: -1, y: 0.5, r: 0 },
  ]
  const goals = [0.1, 0.2, 0.3, 0.4]

  it('the slope of the hill is the area that a cell lacks', () => {
    const height = heightOver(BOX, sites, goals)
    for (const weights of [
      [0, 0, 0, 0],
      [1, -0.5, 0.7, 0.2],
    ]) {
      const areas = areasIn(BOX, weighted(sites, weights, library))
      for (const i of sites.keys()) {
        const at = (by: number) => height(weights.map((weight, k) => (k === i ? weight + by : weight)))
        const slope = (at(0.05) - at(-0.05)) / 0.1
        expect(slope).toBeCloseTo((goals[i] as number) - (areas[i] as number) / areaOf(BOX), 2)
      }
    }
  })

  it('what one cell gains its neighbors lose, across springs that pull both ways alike', () => {
    const stiffness = stiffnessIn(BOX, sites, [0.4, 0, 0.3, 0], library)
    for (const [i, row] of stiffness.entries()) {
      expect(row.reduce((sum, h) => sum + h, 0)).toBeCloseTo(0, 5)
      for (const [j, h] of row.entries()) {
        expect(h).toBeCloseTo(stiffness[j]?.[i] as number, 5)
        if (i === j) expect(h).toBeGreaterThan(0)
        else expect(h).toBeLessThan(1e-6)
      }
    }
  })

  it('the map says when all three areas are right: at the weights that the library finds', () => {
    const scene = drawnScene('by-hand')
    const { box, map } = panelsOf(new Pen(scene))
    const region = regions.region([boxRing(box.minX, box.minY, box.maxX, box.maxY)])
    const { weights } = regions.fitAreas(scene.circles, [...THREE_SHARES], { region, shares: true })
    const [w0, w1, w2] = tuple(weights, 0, 3)
    const right = { x: (map.minX + map.maxX) / 2 + w1 - w0, y: (map.minY + map.maxY) / 2 + w2 - w0 }
    expect(right.x).toBeLessThan(map.maxX)
    expect(right.y).toBeLessThan(map.maxY)
    const told = (point: typeof right) => KINDS['weight-plane'].draw({ ...scene, point }, 0, library).told
    expect(told(right)).toBe(
      'Well done. Every cell has its area: cell 0 has 20 % (goal: 20 %), cell 1 has 30 % (goal: 30 %) and cell 2 has 50 % (goal: 50 %).',
    )
    expect(told({ x: right.x + 1, y: right.y })).toMatch(/^Cell 0 has \d+ % \(goal: 20 %\)/)
    // One right area is not enough.
    const line = Array.from({ length: 201 }, (_, k) =>
      told({ x: map.minX + (k / 200) * (map.maxX - map.minX), y: right.y + 3 }),
    )
    expect(line.some((text) => /has 50 % \(goal: 50 %\)/.test(text))).toBe(true)
    expect(line.filter((text) => text.startsWith('Well done'))).toEqual([])
    // Beyond the map its border counts.
    for (const [x, y] of [
      [-1e3, 1e3],
      [1e3, -1e3],
    ] as const) {
      const corner = { x: x < 0 ? map.minX : map.maxX, y: y < 0 ? map.minY : map.maxY }
      expect(told({ x, y })).toBe(told(corner))
    }
    // Contour lines lie around that point.
    const { content } = KINDS['weight-plane'].draw({ ...scene, point: right }, 1, library)
    const [, d = ''] = /class="contour" d="([^"]*)"/.exec(content) ?? []
    const points = [...d.matchAll(/[ML]([\d.-]+),([\d.-]+)/g)].map(([, x, y]) => ({ x: Number(x), y: Number(y) }))
    expect(Math.min(...points.map(({ x }) => x))).toBeLessThan(right.x)
    expect(Math.max(...points.map(({ x }) => x))).toBeGreaterThan(right.x)
    expect(Math.min(...points.map(({ y }) => y))).toBeLessThan(right.y)
    expect(Math.max(...points.map(({ y }) => y))).toBeGreaterThan(right.y)
    // Each place of the slider adds lines around the former ones, and another view has the lines in its own map.
    const contoursAt = (value: number, view = scene.view) =>
      /class="contour" d="([^"]*)"/.exec(KINDS['weight-plane'].draw({ ...scene, view }, value, library).content)?.[1]
    const contours = contoursAt(3) as string
    expect(contours.startsWith(contoursAt(2) as string)).toBe(true)
    expect(contours.length).toBeGreaterThan(contoursAt(2)?.length as number)
    const [x, y, width] = scene.view
    const countIn = (d: string | undefined) => d?.match(/M/g)?.length
    expect(countIn(contoursAt(3, [x, y, 1.25 * width]))).not.toBe(countIn(contours))
    expect(contoursAt(3)).toBe(contours)
  })

  it('the curve of two weights rises while the second cell lacks area, and its top is where both are right', () => {
    const scene = drawnScene('two-weights')
    const { last } = KINDS['two-weights'].range(scene, library)
    const tellings = Array.from(
      { length: 200 },
      (_, k) => KINDS['two-weights'].draw(scene, (last * k) / 199, library).told,
    )
    const kinds = tellings.map((told) => /(rises|is 0|falls)/.exec(told)?.[1])
    expect(new Set(kinds)).toEqual(new Set(['rises', 'is 0', 'falls']))
    expect(kinds.lastIndexOf('rises')).toBeLessThan(kinds.indexOf('is 0'))
    expect(kinds.lastIndexOf('is 0')).toBeLessThan(kinds.indexOf('falls'))
  })

  it('Newton’s steps are those of the library, and the last ones double the digits', () => {
    const scene = drawnScene('newton')
    const { last } = KINDS.newton.range(scene, library, regions)
    const { steps } = stepsOf(scene.circles, frameIn(new Pen(scene)), regions)
    expect(steps).toHaveLength(last + 1)
    const errors = steps.map(({ error }) => error)
    expect(errors[0]).toBeGreaterThan(0.5)
    expect(errors[last]).toBeLessThan(1e-9)
    const [before, after] = errors.slice(-3) as [number, number]
    expect(Math.log(after) / Math.log(before)).toBeGreaterThan(1.6)
    // Between two steps the sentence is about the earlier one, and areas change steadily.
    const at = (value: number) => KINDS.newton.draw(scene, value, library, regions)
    expect([at(0.7).told, at(1.7).told]).toEqual([at(0).told, at(1).told])
    const errorsAt = (value: number) => [...at(value).content.matchAll(/([+−±])(\d+) %/g)].map(([text]) => text)
    expect(errorsAt(0.999)).toEqual(errorsAt(1))
    const { content, told } = at(last)
    expect(content.match(/±0 %/g)).toHaveLength(scene.circles.length)
    expect(told).toMatch(/^After step (\d+) of \1 the worst cell is off by about 10⁻/)
  })

  it('sites that cannot be fitted say why', () => {
    const scene = drawnScene('newton')
    const [first] = scene.circles
    if (first === undefined) throw new Error('There are sites.')
    const twice = { ...scene, circles: [first, first, ...scene.circles.slice(2)] }
    expect(KINDS.newton.draw(twice, 0, library, regions).told).toBe('Site 1 has the same position as site 0.')
  })

  it('market areas fill the country, and at the right end towns inside a larger one serve nobody', () => {
    const scene = drawnScene('market-areas')
    const told = (value: number) => KINDS.market.draw(scene, value, library, regions).told
    expect(told(0)).not.toContain('nobody')
    const inside = scene.circles.flatMap(({ x, y, r }, i) =>
      scene.circles.some((other) => other.r > r && Math.hypot(other.x - x, other.y - y) <= 2 * (other.r - r))
        ? [i]
        : [],
    )
    expect(inside.length).toBeGreaterThan(0)
    expect(told(2)).toContain(`${inside.length === 1 ? 'Town' : 'Towns'} ${inside.join(' and ')} serve`)
  })
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
    // Circles in positions that a reader might drag them to.
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
