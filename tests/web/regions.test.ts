import { describe, expect, it, vi } from 'vitest'
import { distanceFrom } from '../../web/lib/base/metric.ts'
import {
  type Circles,
  CircleVoronoiError,
  circleAt,
  convexHull,
  Diagram,
  type ErrorCode,
  largestEmptyDiscCenteredIn,
  type Outline,
  outlineArea,
  type PathSink,
} from '../../web/lib/index.ts'
import { loadMetrics } from '../../web/lib/metrics.ts'
import type { RegionModule } from '../../web/lib/regions/region.ts'
import { type FitStep, loadRegions, Region, type RegionShape } from '../../web/lib/regions.ts'
import { untyped } from './errors.ts'
import { library, seededRandom } from './library.ts'
import { box, ring } from './shapes.ts'

const { region, fitAreas } = await loadRegions()

const HALL = [box(0, 0, 9, 9), box(3, 3, 6, 6)] as const
const hall = region(HALL)

function circles(count: number, seed: number, size = 9): [number, number, number][] {
  const random = seededRandom(seed)
  return Array.from({ length: count }, () => [size * random(), size * random(), (size / 20) * random()])
}

const sum = (values: Iterable<number>) => Array.from(values).reduce((total, value) => total + value, 0)

/** Twice the signed area of a closed ring. */
const twice = (ring: readonly (readonly number[])[]) =>
  sum(ring.slice(1).map(([x = 0, y = 0], k) => (ring[k]?.[0] ?? 0) * y - x * (ring[k]?.[1] ?? 0)))

describe('a region', () => {
  it('is made of rings or GeoJSON in any orientation, closed or not', () => {
    const [outer, hole] = HALL.map((ring) => [...ring, ring[0]].reverse())
    const polygon = { type: 'Polygon', coordinates: [outer, hole] } as RegionShape
    const shapes: RegionShape[] = [
      HALL,
      [...HALL].reverse(),
      HALL.map((ring) => ring.map(([x, y]) => ({ x, y }))),
      polygon,
      { type: 'MultiPolygon', coordinates: [[outer, hole]] } as RegionShape,
      { type: 'Feature', geometry: polygon } as RegionShape,
      {
        type: 'FeatureCollection',
        features: [
          { type: 'Feature', geometry: null },
          { type: 'Feature', geometry: polygon },
        ],
      } as RegionShape,
      { type: 'GeometryCollection', geometries: [polygon] } as RegionShape,
    ]
    for (const shape of shapes) {
      const { area, perimeter, box, points, ringOffsets, polygonOffsets } = region(shape)
      expect({ area, perimeter, box }).toEqual({ area: 72, perimeter: 48, box: { minX: 0, minY: 0, maxX: 9, maxY: 9 } })
      expect([points.length, [...ringOffsets], [...polygonOffsets]]).toEqual([16, [0, 4, 8], [0, 2]])
    }
    expect([hall.contains(1, 1), hall.contains(4, 4), hall.contains(3, 4), hall.contains(10, 1)]).toEqual([
      true,
      false,
      true,
      false,
    ])
  })

  it('refuses what is none, and says where its sides cross', () => {
    const refused = (code: ErrorCode) => expect.objectContaining({ code })
    expect(() => region([ring(0, 0, 2, 2, 2, 0, 0, 2)])).toThrow(
      expect.objectContaining({ code: 'badOption', message: expect.stringContaining('(1, 1)') }),
    )
    for (const shape of [
      [],
      undefined,
      { type: 'Point', coordinates: [0, 0] },
      { type: 'MultiPolygon' },
      { type: 'FeatureCollection' },
      [ring(0, 0, 1, 0, untyped('a'), 1)],
      [ring(0, 0, 1, 0, Number.NaN, 1)],
      [ring(0, 0, 1, 0)],
      [5],
    ])
      expect(() => region(untyped(shape)), JSON.stringify(shape)).toThrow(refused('badOption'))
  })
})

describe('a diagram in a region', () => {
  it('has areas that sum to that of the region, and centroids, perimeters and outlines to match', () => {
    const diagram = library.compute(circles(60, 1))
    const areas = diagram.cellAreas({ region: hall })
    expect(Math.abs(sum(areas) - 72)).toBeLessThan(72e-12)
    const centroids = diagram.cellCentroids({ region: hall })
    const perimeters = diagram.cellPerimeters({ region: hall })
    for (let i = 0; i < 60; i++) {
      const outline = diagram.cellOutline(i, { region: hall })
      expect(outlineArea(outline)).toBeCloseTo(areas[i] as number, 12)
      expect(diagram.cellArea(i, { region: hall })).toBeCloseTo(areas[i] as number, 12)
      if (outline.length === 0) continue
      const { x, y } = diagram.cellCentroid(i, { region: hall }) ?? { x: Number.NaN, y: Number.NaN }
      expect(x).toBeCloseTo(centroids[2 * i] as number, 10)
      expect(y).toBeCloseTo(centroids[2 * i + 1] as number, 10)
      expect(diagram.cellPerimeter(i, { region: hall })).toBeCloseTo(perimeters[i] as number, 10)
      for (const loop of outline) {
        for (const { side, regionSide, r } of loop) {
          expect([side !== -1, regionSide !== -1, r > 0].filter(Boolean)).toHaveLength(1)
        }
      }
    }
  })

  it('has the areas of bounds where the region is their box', () => {
    const diagram = library.compute(circles(80, 2))
    const square = region([box(1, 1, 7, 8)])
    const inBounds = diagram.cellAreas({ bounds: [1, 1, 7, 8] })
    diagram.cellAreas({ region: square }).forEach((area, i) => {
      expect(area).toBeCloseTo(inBounds[i] as number, 11)
    })
    const near = diagram.cellAreas({ bounds: [1, 1, 7, 8], maxDistance: 0.3 })
    diagram.cellAreas({ region: square, maxDistance: 0.3 }).forEach((area, i) => {
      expect(area).toBeCloseTo(near[i] as number, 11)
    })
  })

  it('has multipolygons whose rings share their points, and neighbors inside', () => {
    const diagram = library.compute(circles(40, 3))
    const polygons = [...diagram.cellPolygons({ region: hall, tolerance: 1e-4 })]
    const rings = polygons.flatMap((polygon) => polygon.flat())
    // Another tolerance gives other points.
    const coarse = [...diagram.cellPolygons({ region: hall, tolerance: 0.1 })].flatMap((polygon) => polygon.flat())
    expect(coarse.flat().length).toBeLessThan(rings.flat().length)
    // Neighbors share points, so errors cancel: the sum is the region's area up to rounding.
    expect(sum(rings.map(twice)) / 2).toBeCloseTo(72, 10)
    for (const polygon of polygons) {
      for (const [outer, ...holes] of polygon) {
        expect(twice(outer ?? [])).toBeGreaterThan(0)
        for (const hole of holes) expect(twice(hole)).toBeLessThan(0)
      }
      const { index } = polygon
      expect(diagram.cellPolygon(index, { region: hall, tolerance: 1e-4 })).toEqual([...polygon])
      const inside = new Set(diagram.neighbors(index, { region: hall }))
      const shared = diagram
        .cellOutline(index, { region: hall })
        .flatMap((loop) => loop.map(({ neighbor }) => neighbor))
      expect(inside).toEqual(new Set(shared.filter((neighbor) => neighbor !== -1)))
    }
  })

  it('has neighbors inside bounds, too', () => {
    const diagram = library.compute(Float64Array.of(0, 0, 1, 10, 0, 1, 5, 9, 1))
    expect([...diagram.neighbors(0)].sort()).toEqual([1, 2])
    expect([...diagram.neighbors(0, { bounds: [-1, -9, 11, 0] })]).toEqual([1])
    expect([...diagram.neighbors(0, { maxDistance: 1 })]).toEqual([])
  })

  it('is drawn with edges that end at the border of the region', () => {
    const diagram = library.compute(Float64Array.of(2, 2, 1, 7, 7, 1))
    const square = region([box(0, 0, 9, 8)])
    expect(diagram.render({ region: square, digits: 3 })).toMatch(/^(M1,8L9,0|M9,0L1,8)$/)
    expect(diagram.edgePath(0, { region: square, digits: 3 })).toBe(diagram.render({ region: square, digits: 3 }))
    expect(diagram.renderBounds({ region: square, digits: 0 })).toBe('M0,0L9,0L9,8L0,8Z')
    expect(diagram.cellPath(0, { region: square, digits: 0 })).toMatch(/^M[\dL,]+Z$/)
    expect(
      diagram.cellPath(1, {
        region: region([ring(0, 0, 1, 0, 0, 1)]),
      }),
    ).toBe('')
  })

  it('is that of the circles as they are now', () => {
    const editor = library.edit(Float64Array.of(2, 2, 1, 7, 7, 1))
    const diagram = editor.snapshot()
    const before = diagram.cellArea(0, { region: hall })
    diagram.apply(editor.replace(0, { x: 2, y: 2, r: 2 }))
    expect(diagram.cellArea(0, { region: hall })).toBeGreaterThan(before + 1)
    editor.dispose()
  })

  /** The pieces of an outline in a canonical order. */
  const partsOf = (outline: Outline) =>
    outline
      .flatMap((loop) => loop.map(({ curve: { start }, ...piece }) => JSON.stringify({ start, ...piece, curve: 0 })))
      .sort()

  it('has the cells that an edit has changed clipped alone, with the bits that they have among all', () => {
    const weighted = circles(3000, 9).map(([x, y, r]) => [x, y, r - 0.2] as const)
    const editor = library.edit(weighted, { weights: true })
    const diagram = editor.snapshot()
    const clip = vi.spyOn(hall.module, 'clip')
    const random = seededRandom(10)
    let alone = 0
    for (let step = 0; step < 40; step++) {
      // Half of the points are near the border.
      const x = step % 2 === 0 ? 9 * random() : 3 + 0.05 * random()
      const change = editor.replace(Math.floor(3000 * random()), { x, y: 9 * random(), r: 0.1 * random() - 0.2 })
      const options = { region: hall, maxDistance: step % 4 > 1 ? 0.25 : undefined }
      diagram.apply(change)
      clip.mockClear()
      const changed = Array.from(change.cells, (id) => diagram.indexOf(id)).slice(0, 40)
      const ofAlone = changed.map((i) => ({
        parts: partsOf(diagram.cellOutline(i, options)),
        neighbors: diagram.neighbors(i, options),
      }))
      if (2 * changed.length * 64 <= 3000) {
        expect(clip).not.toHaveBeenCalled()
        alone += changed.length
      }
      const whole = new Diagram(diagram)
      whole.cellAreas(options)
      changed.forEach((i, k) => {
        expect(ofAlone[k]).toEqual({
          parts: partsOf(whole.cellOutline(i, options)),
          neighbors: whole.neighbors(i, options),
        })
      })
    }
    expect(alone).toBeGreaterThan(60)
    clip.mockRestore()
    editor.dispose()
  })

  it('has all cells clipped once many are asked for, with ties too', () => {
    const grid = Array.from({ length: 900 }, (_, k) => [(k % 30) / 3, Math.floor(k / 30) / 3, 0.1] as const)
    for (const data of [circles(900, 11), grid] as Circles[]) {
      const diagram = library.compute(data)
      const clip = vi.spyOn(hall.module, 'clip')
      const areas = Array.from({ length: 900 }, (_, i) => diagram.cellArea(i, { region: hall }))
      expect(clip).toHaveBeenCalledOnce()
      clip.mockRestore()
      diagram.cellAreas({ region: hall }).forEach((area, i) => {
        expect(areas[i]).toBeCloseTo(area, 12)
      })
      expect(sum(areas)).toBeCloseTo(72, 9)
    }
  })

  it('may have weights, or be the ordinary or the power diagram', async () => {
    const bounds = [1, 1, 8, 7] as const
    const square = region([box(...bounds)])
    const { compute } = await loadMetrics({ library })
    const data = circles(120, 12)
    const shifted = data.map(([x, y, r]) => [x, y, r - 0.2] as const)
    const diagrams = [
      library.compute(data),
      library.compute(shifted, { weights: true }),
      compute(data, { metric: 'centers' }),
      compute(data, { metric: 'power' }),
      compute(shifted, { metric: 'power', weights: true }),
    ]
    const inBox = { bounds, tolerance: 1e-5 }
    const inSquare = { region: square, tolerance: 1e-5 }
    for (const diagram of diagrams) {
      const close = (one: ArrayLike<number>, other: ArrayLike<number>) => {
        expect(one).toHaveLength(other.length)
        Array.from(one).forEach((value, k) => {
          // The value is NaN for missing cells.
          const expected = other[k] as number
          expect(Number.isNaN(value) ? 'NaN' : Math.abs(value - expected) < 1e-9).toBe(
            Number.isNaN(expected) ? 'NaN' : true,
          )
        })
      }
      close(diagram.cellAreas({ region: square }), diagram.cellAreas({ bounds }))
      close(diagram.cellCentroids({ region: square }), diagram.cellCentroids({ bounds }))
      close(diagram.cellPerimeters({ region: square }), diagram.cellPerimeters({ bounds }))
      expect(diagram.render(inSquare).match(/M/g)).toHaveLength(diagram.render(inBox).match(/M/g)?.length as number)
      for (let i = 0; i < data.length; i += 7) {
        expect(diagram.cellArea(i, { region: square })).toBeCloseTo(diagram.cellArea(i, { bounds }), 9)
        expect(new Set(diagram.neighbors(i, { region: square }))).toEqual(new Set(diagram.neighbors(i, { bounds })))
        expect(diagram.cellPath(i, inSquare) === '').toBe(diagram.cellPath(i, inBox) === '')
        const polygon = diagram.cellPolygon(i, inSquare)?.flat() ?? []
        expect(sum(polygon.map(twice)) / 2).toBeCloseTo(diagram.cellArea(i, { bounds }), 3)
      }
      for (let e = 0; e < diagram.edges.length / 4; e += 5) {
        expect(diagram.edgePath(e, inSquare) === '').toBe(diagram.edgePath(e, inBox) === '')
      }
    }
  })

  it('has the largest empty disc with its center inside', () => {
    const square = region([box(1, 1, 7, 8)])
    const random = seededRandom(13)
    for (const data of [circles(2, 14), circles(30, 15), circles(300, 16)]) {
      const diagram = library.compute(data)
      const inBounds = largestEmptyDiscCenteredIn(diagram, { bounds: [1, 1, 7, 8] })
      expect(largestEmptyDiscCenteredIn(diagram, { region: square })?.disc.r).toBeCloseTo(
        inBounds?.disc.r as number,
        11,
      )
      const inHall = largestEmptyDiscCenteredIn(diagram, { region: hall })
      const { x, y, r } = inHall?.disc ?? { x: Number.NaN, y: Number.NaN, r: Number.NaN }
      expect(hall.contains(x, y)).toBe(true)
      expect(distanceFrom(diagram, diagram.find(x, y), x, y)).toBeCloseTo(r, 11)
      for (const i of inHall?.circles ?? []) expect(distanceFrom(diagram, i, x, y)).toBeCloseTo(r, 11)
      for (let k = 0; k < 2000; k++) {
        const [px, py] = [9 * random(), 9 * random()]
        if (hall.contains(px, py)) expect(distanceFrom(diagram, diagram.find(px, py), px, py)).toBeLessThan(r + 1e-11)
      }
    }
    expect(largestEmptyDiscCenteredIn(library.compute([]), { region: hall })).toBeUndefined()
  })

  it('clips the hull', () => {
    const data = circles(40, 18)
    const diagram = library.compute(data)
    const tolerance = 1e-6
    // A region around the hull leaves it whole.
    const around = region([box(-20, -20, 30, 30)])
    const whole = diagram.hullPolygon({ tolerance }) as [number, number][]
    const [[kept = []] = [], ...others] = diagram.hullPolygon({ region: around, tolerance }) ?? []
    expect(others).toEqual([])
    expect(kept[0]).toEqual(kept.at(-1))
    expect(twice(kept)).toBeCloseTo(twice(whole), 9)
    expect(twice(kept) / 2).toBeCloseTo(convexHull(diagram).area, 3)
    // A point is inside the clipped hull if it is inside both.
    const part = diagram.hullPolygon({ region: hall, tolerance }) ?? []
    const isInside = (rings: readonly (readonly (readonly number[])[])[], x: number, y: number) =>
      region(rings as RegionShape).contains(x, y)
    const [inWhole, inPart] = [region([whole]), region({ type: 'MultiPolygon', coordinates: part })]
    const random = seededRandom(19)
    for (let k = 0; k < 3000; k++) {
      const [x, y] = [20 * random() - 5, 20 * random() - 5]
      expect(inPart.contains(x, y)).toBe(inWhole.contains(x, y) && hall.contains(x, y))
    }
    expect(isInside([whole], 4.5, 4.5)).toBe(true)
    // The path has the same points.
    const points: [number, number][] = []
    const context = {
      moveTo: (x: number, y: number) => points.push([x, y]),
      lineTo: (x: number, y: number) => points.push([x, y]),
      closePath: () => {},
    } as unknown as PathSink
    diagram.renderHull({ region: hall, tolerance, context })
    expect(points).toEqual(part.flatMap((rings) => rings.flatMap((ring) => ring.slice(0, -1))))
    expect(diagram.renderHull({ region: hall })).toMatch(/^M.+Z$/)
    // Hulls that miss the region, and hulls without an area.
    const far = library.compute([[50, 50, 1]])
    expect([far.hullPolygon({ region: hall }), far.renderHull({ region: hall })]).toEqual([undefined, ''])
    const disc = library.compute([[1.5, 4, 1]]).hullPolygon({ region: hall, tolerance: 1e-7 })?.[0]?.[0] ?? []
    expect(twice(disc) / 2).toBeCloseTo(Math.PI, 5)
    for (const flat of [[], [1, 1, 0], [1, 1, 0, 2, 2, 0, 4, 4, 0]]) {
      expect(library.compute(Float64Array.from(flat)).hullPolygon({ region: hall })).toBeUndefined()
    }
  })

  it('is freed with its clipped diagrams once they are no longer used', async () => {
    const registries: { free: (address: number) => void; held: Map<number, WeakKey> }[] = []
    vi.stubGlobal(
      'FinalizationRegistry',
      class {
        readonly held = new Map<number, WeakKey>()
        readonly free: (address: number) => void
        constructor(free: (address: number) => void) {
          this.free = free
          registries.push(this)
        }
        register(target: WeakKey, address: number) {
          this.held.set(address, target)
        }
      },
    )
    const own = await loadRegions()
    vi.unstubAllGlobals()
    const [regions, clips] = registries
    const room = own.region(HALL)
    const diagram = library.compute([[1, 1, 1]])
    const clipped = room.module.clip(diagram, undefined)
    expect([...(regions?.held.values() ?? [])]).toEqual([room])
    expect([...(clips?.held.values() ?? [])]).toEqual([clipped])
    // The clipped diagram refers to the region, which is freed after it.
    expect(clipped).toHaveProperty('region', room)
    for (const registry of [clips, regions]) for (const address of registry?.held.keys() ?? []) registry?.free(address)
    // The memory is used again.
    const addresses = new Map([clips, regions].map((registry) => [registry, new Set<number>()]))
    for (let k = 0; k < 50; k++) {
      for (const registry of addresses.keys()) registry?.held.clear()
      own.region(HALL).module.clip(diagram, undefined)
      for (const [registry, all] of addresses) {
        for (const address of registry?.held.keys() ?? []) {
          all.add(address)
          registry?.free(address)
        }
      }
    }
    for (const all of addresses.values()) expect(all.size).toBeLessThan(20)
  })
})

describe('fitted areas', () => {
  const square = region([box(0, 0, 1, 1)])

  it('are proportional to the shares that were asked for, in a certified diagram, and found at once from its weights', () => {
    const random = seededRandom(5)
    const sites = Array.from({ length: 100 }, () => [random(), random()] as const)
    const shares = sites.map(() => 1 + 9 * random())
    const errors: number[] = []
    const fit = fitAreas(sites, shares, { region: square, shares: true, onStep: ({ error }) => errors.push(error) })
    expect(fit.error).toBeLessThan(1e-9)
    expect(errors).toHaveLength(fit.steps + 1)
    expect(Math.min(...fit.weights)).toBe(0)
    expect(library.certify(fit.diagram).certified).toBe(true)
    const areas = fit.diagram.cellAreas({ region: square })
    expect([...areas]).toEqual([...fit.areas])
    shares.forEach((share, i) => {
      expect(areas[i]).toBeCloseTo(share / sum(shares), 10)
    })
    const again = fitAreas(sites, shares, { region: square, shares: true, weights: fit.weights })
    expect([again.steps, [...again.weights]]).toEqual([0, [...fit.weights]])
    const fromRadii = fitAreas(
      sites.map(([x, y], i) => ({ x, y, r: fit.weights[i] as number })),
      Float32Array.from(shares) as never,
      { region: square, shares: true, tolerance: 1e-5 },
    )
    expect([fromRadii.steps, [...fromRadii.weights]]).toEqual([0, [...fit.weights]])
  })

  it('start from the radii of circles, and fit a region with a hole', () => {
    const sites = circles(30, 6)
    const fit = fitAreas(
      sites,
      sites.map(() => 72 / 30),
      { region: hall },
    )
    expect(fit.error).toBeLessThan(1e-9)
    expect(Math.abs(sum(fit.areas) - 72)).toBeLessThan(1e-10)
  })

  it('are refused where they have no answer', () => {
    const fitting = (areas: number[], options: object) => () =>
      fitAreas(
        [
          [0.2, 0.2],
          [0.8, 0.3],
        ],
        areas,
        { region: square, ...options },
      )
    const refused = (code: ErrorCode) => expect.objectContaining({ code })
    expect(fitting([0.5, 0.4], {})).toThrow(refused('badInput'))
    expect(fitting([1], {})).toThrow(refused('badInput'))
    expect(fitting([0.9, 0.1], { maxSteps: 1 })).toThrow(refused('notConverged'))
    expect(fitting([0.5, 0.5], { region: new Region(square, {} as RegionModule) })).toThrow(refused('badOption'))
    const enough = new RangeError('enough')
    const onStep = () => {
      throw enough
    }
    expect(fitting([0.9, 0.1], { onStep })).toThrow(enough)
    // The module counts as many steps.
    expect(fitting([0.5, 0.5], { maxSteps: 2 ** 31 - 1 })().error).toBeLessThan(1e-9)
  })

  it('say what they have reached where they do not converge, with the weights to go on from', () => {
    const sites = circles(50, 31)
    const shares = sites.map((_, i) => 1 + (i % 7))
    let last: FitStep | undefined
    const onStep = (step: FitStep) => {
      last = step
    }
    let caught: unknown
    try {
      fitAreas(sites, shares, { region: hall, shares: true, maxSteps: 3, onStep })
    } catch (error) {
      caught = error
    }
    const { code, message, weights } = caught as CircleVoronoiError
    expect([code, last?.steps]).toEqual(['notConverged', 3])
    expect(weights).toEqual(last?.weights)
    const areas = library.compute(sites.map(([x, y], i) => [x, y, weights?.[i] ?? 0])).cellAreas({ region: hall })
    const errors = shares.map((share, i) => Math.abs(((areas[i] ?? 0) * sum(shares)) / (72 * share) - 1))
    expect(message).toContain(
      `of an area is ${Math.max(...errors)
        .toExponential(1)
        .slice(0, 3)}`,
    )
    expect(fitAreas(sites, shares, { region: hall, shares: true, weights }).error).toBeLessThan(1e-9)
    expect(new CircleVoronoiError('badInput', 'None.').weights).toBeUndefined()
  })

  it('may have their sites moved to the centroids of the cells', () => {
    const random = seededRandom(21)
    const sites = Array.from({ length: 50 }, () => [9 * random(), 9 * random()] as const)
    const shares = sites.map(() => 1 + 9 * random())
    const distance = (relax: number) => {
      const { diagram, areas } = fitAreas(sites, shares, { region: hall, shares: true, relax })
      shares.forEach((share, i) => {
        expect(areas[i]).toBeCloseTo((72 * share) / sum(shares), 7)
      })
      const centroids = diagram.cellCentroids({ region: hall })
      return sum(
        sites.map((_, i) => {
          const { x, y } = circleAt(diagram.circles, i)
          return Math.hypot(x - (centroids[2 * i] as number), y - (centroids[2 * i + 1] as number))
        }),
      )
    }
    expect(distance(30)).toBeLessThan(0.2 * distance(0))
  })

  it('stop before the next step when their signal says so', () => {
    const sites = circles(20, 8)
    const areas = sites.map(() => 72 / 20)
    const controller = new AbortController()
    const told: number[] = []
    const onStep = ({ steps }: { steps: number }) => {
      told.push(steps)
      if (steps === 2) controller.abort(new RangeError('enough'))
    }
    const { signal } = controller
    expect(() => fitAreas(sites, areas, { region: hall, signal, onStep })).toThrow(new RangeError('enough'))
    expect(told).toEqual([0, 1, 2])
    expect(() => fitAreas(sites, areas, { region: hall, signal, onStep })).toThrow(RangeError)
    expect(told).toHaveLength(3)
  })
})
