import { expect, it } from 'vitest'
import { loadFiles } from '../../web/lib/files.ts'
import {
  CircleVoronoiError,
  clearestPath,
  closestPair,
  convexHull,
  Diagram,
  type DiagramData,
  DiagramSnapshot,
  edgeCurve,
  fromJSON,
  largestEmptyDiscCenteredIn,
  largestEmptyDiscCenteredInHull,
  largestEmptyDiscInside,
  type Metric,
  mergeVertices,
  type SnapshotData,
} from '../../web/lib/index.ts'
import { loadMetrics } from '../../web/lib/metrics.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { library, seededRandom } from './library.ts'
import { ring } from './shapes.ts'

const { region } = await loadRegions()
const { compute } = await loadMetrics({ library })
const files = await loadFiles()

const hall = region([ring(10, 10, 90, 20, 80, 90, 20, 80), ring(40, 40, 60, 40, 50, 60)])
const ARRAYS = [
  'circles',
  'vertices',
  'vertexCircles',
  'edges',
  'hidden',
  'hull',
  'nextSide',
  'vertexSides',
  'firstSide',
] as const
const INDICES = [-2, -1, 1, 2 ** 31 - 1]
const NUMBERS = [0, 1e300, Number.POSITIVE_INFINITY, Number.NaN]
const bounds = [10, 10, 90, 80] as const
const p = { x: 20, y: 30 }
const q = { x: 70, y: 60 }

const CALLS: Record<string, (diagram: Diagram) => unknown> = {
  areasInRegion: (d) => d.cellAreas({ region: hall }),
  cellsInRegion: (d) => [0, 3, 7].map((i) => d.cellArea(i, { region: hall })),
  polygonsInRegion: (d) => [...d.cellPolygons({ region: hall })],
  pathsInRegion: (d) => d.render({ region: hall }) + d.cellPath(2, { region: hall }) + d.edgePath(2, { region: hall }),
  nearInRegion: (d) => d.cellAreas({ region: hall, maxDistance: 4 }),
  neighborsInRegion: (d) => d.neighbors(1, { region: hall }),
  hullInRegion: (d) => d.hullPolygon({ region: hall }),
  areas: (d) => d.cellAreas({ bounds }),
  near: (d) => d.cellAreas({ bounds, maxDistance: 4 }),
  centroids: (d) => d.cellCentroids({ bounds }),
  perimeters: (d) => d.cellPerimeters(),
  polygons: (d) => [...d.cellPolygons()],
  paths: (d) => d.render() + d.cellPath(3) + d.edgePath(3, { maxDistance: 3 }) + d.renderCircles() + d.renderDual(),
  hulls: (d) => [convexHull(d), d.renderHull(), d.hullPolygon()],
  cells: (d) => d.circles.slice(0, 20).map((_, i) => d.cell(i)?.sides.length ?? 0),
  neighbors: (d) => [d.neighbors(2), d.neighbors(2, { bounds })],
  contains: (d) => [d.contains(4, 30, 30), d.contains(0, 1, 1)],
  find: (d) => [d.find(30, 30), d.find(1, 2, 5), d.findAll([3, 4, 50, 60])],
  halfedges: (d) => d.halfedges,
  json: (d) => fromJSON(JSON.stringify(d)),
  certify: (d) => library.certify(d),
  finalCells: (d) => library.finalCells(d, { box: { minX: 0, minY: 0, maxX: 100, maxY: 100 }, maxRadius: 1 }),
  edit: (d) => library.edit(d).dispose(),
  files: (d) => (['json', 'csv', 'svg', 'geojson', 'wkt'] as const).map((format) => files.writeDiagram(d, { format })),
  filesInRegion: (d) => files.writeDiagram(d, { format: 'wkt', region: hall }),
  merge: (d) => mergeVertices(d),
  mergeMuch: (d) => mergeVertices(d, 30),
  pair: (d) => closestPair(d),
  path: (d) => clearestPath(d, p, q),
  discIn: (d) => largestEmptyDiscCenteredIn(d, { bounds }),
  discInRegion: (d) => largestEmptyDiscCenteredIn(d, { region: hall }),
  discInHull: (d) => largestEmptyDiscCenteredInHull(d),
  discInside: (d) => largestEmptyDiscInside(d, { bounds }),
  curves: (d) => [edgeCurve(d, 0), edgeCurve(d, 5)],
}

/** Changes that a program may make to an array. */
function* changesOf(array: Float64Array | Int32Array, random: () => number) {
  const place = () => Math.floor(random() * array.length)
  const copy = (change: (copy: Float64Array | Int32Array) => unknown) => {
    const changed = array.slice()
    change(changed)
    return changed
  }
  for (const value of array instanceof Int32Array ? INDICES : NUMBERS) {
    yield [`all ${value}`, copy((list) => list.fill(value))] as const
    yield [`one ${value}`, copy((list) => list.fill(value, array.length >> 1, (array.length >> 1) + 1))] as const
  }
  yield ['reversed', copy((list) => list.reverse())] as const
  yield ['turned', copy((list) => list.set([...array.slice(1), ...array.slice(0, 1)]))] as const
  for (let k = 0; k < 2 && array.length > 0; k++) {
    const [i, j] = [place(), place()]
    yield [
      `${i} and ${j} swapped`,
      copy((list) => list.set([array[i] ?? 0], j) ?? list.set([array[j] ?? 0], i)),
    ] as const
  }
  yield ['empty', array.slice(0, 0)] as const
  yield ['half', array.slice(0, 12 * Math.floor(array.length / 24))] as const
}

function outcomeOf(run: () => unknown): string {
  try {
    run()
    return 'a result'
  } catch (error) {
    if (error instanceof CircleVoronoiError && error.code !== 'internal') return 'an error'
    return (error as Error).stack ?? String(error)
  }
}

const METRICS: readonly Metric[] = ['circles', 'centers', 'power']

it.each(METRICS)('changed arrays of the metric %s are a result or an error', (metric) => {
  const random = seededRandom(11)
  const circles = Float64Array.from({ length: 60 }, (_, k) => (k % 3 === 2 ? 4 * random() : 100 * random()))
  const whole = metric === 'circles' ? library.compute(circles) : compute(circles, { metric })
  const right = new Map(Object.entries(CALLS).map(([name, call]) => [name, outcomeOf(() => call(new Diagram(whole)))]))
  const wrong: string[] = []
  for (const name of ARRAYS) {
    for (const [change, array] of changesOf(whole[name], random)) {
      const data: DiagramData = { ...whole, [name]: array }
      for (const [call, run] of Object.entries(CALLS)) {
        const outcome = outcomeOf(() => run(new Diagram(data)))
        if (outcome !== 'a result' && outcome !== 'an error') wrong.push(`${name}, ${change}: ${call}: ${outcome}`)
      }
    }
  }
  expect(wrong).toEqual([])
  for (const [name, call] of Object.entries(CALLS)) {
    expect(
      outcomeOf(() => call(new Diagram(whole))),
      `${name} afterwards`,
    ).toBe(right.get(name))
  }
})

it('the arrays of a snapshot that an edit is applied to are a result or an error', () => {
  const random = seededRandom(5)
  const circles = Float64Array.from({ length: 60 }, (_, k) => (k % 3 === 2 ? 4 * random() : 100 * random()))
  const wrong: string[] = []
  for (const name of ARRAYS) {
    const editor = library.edit(circles)
    for (const [change, array] of changesOf(editor.snapshot()[name], random)) {
      const data: SnapshotData = { ...editor.snapshot(), [name]: array }
      const diagram = new DiagramSnapshot(data)
      const outcome = outcomeOf(() => {
        diagram.apply(editor.insert({ x: 100 * random(), y: 100 * random(), r: 20 * random() }))
        diagram.apply(editor.remove(3 + Math.floor(20 * random())))
      })
      const isPlain = outcome === 'a result' || outcome === 'an error'
      if (!isPlain && !outcome.includes('no circle')) wrong.push(`${name}, ${change}: ${outcome}`)
    }
    editor.dispose()
  }
  expect(wrong).toEqual([])
})
