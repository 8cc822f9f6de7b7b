// SPDX-License-Identifier: GPL-3.0-or-later
// Functions take n log n steps, also where one circle has many neighbors: README.md lists their costs.
import './steps.ts'
import { describe, it } from 'vitest'
import { loadFiles } from '../../web/lib/files.ts'
import {
  type BoundsOptions,
  type Change,
  type Circle,
  type ComputedDiagram,
  ConvexPolygon,
  circleAt,
  clearestPath,
  clipCurve,
  closestPair,
  convexHull,
  cubicBeziers,
  type DiagramEditor,
  edgeAt,
  edgeCurve,
  fromJSON,
  largestEmptyDiscCenteredIn,
  largestEmptyDiscCenteredInHull,
  largestEmptyDiscInside,
  mergeVertices,
  outlineArea,
  outlineCentroid,
  outlinePerimeter,
  polyline,
  rationalBezier,
  vertexAt,
} from '../../web/lib/index.ts'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { loadMetrics } from '../../web/lib/metrics.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { expectGrowth, type FamilyName, type Prepare } from './growth.ts'
import { library, seededRandom } from './library.ts'
import { boxAround } from './oracle.ts'

const metrics = await loadMetrics({ library })
const files = await loadFiles()
const { region } = await loadRegions()

const ALL: readonly FamilyName[] = ['uniform', 'hub', 'wheel', 'strips', 'comb']
/** Families whose hull has few circles, because a change of the hull takes the time of the whole hull. */
const SMALL_HULL: readonly FamilyName[] = ['uniform', 'wheel', 'comb']

/** The work on a diagram, which is not counted itself. */
function ofDiagram(use: (diagram: ComputedDiagram) => unknown): Prepare {
  return (circles) => {
    const diagram = library.compute(circles)
    return () => use(diagram)
  }
}

/** The work on each of the circles of a diagram, or its edges or vertices. */
function ofEach(parts: 'circles' | 'edges' | 'vertices', use: (diagram: ComputedDiagram, i: number) => unknown) {
  return ofDiagram((diagram) => {
    const count = diagram[parts].length / (parts === 'edges' ? 4 : 3)
    for (let i = 0; i < count; i++) use(diagram, i)
  })
}

/** Returns a box around the middle half of the circles. */
function middleOf(circles: Float64Array): [number, number, number, number] {
  const { minX, minY, maxX, maxY } = boxAround(circles, 0)
  const at = (from: number, to: number, share: number) => from + share * (to - from)
  return [at(minX, maxX, 0.26), at(minY, maxY, 0.251), at(minX, maxX, 0.76), at(minY, maxY, 0.751)]
}

function triangleIn(circles: Float64Array): { x: number; y: number }[] {
  const [minX, minY, maxX, maxY] = middleOf(circles)
  return [
    { x: minX, y: minY },
    { x: maxX, y: minY },
    { x: (minX + maxX) / 2, y: maxY },
  ]
}

/** A share of the size of the input. */
function distanceFor(circles: Float64Array): number {
  const [minX, minY, maxX, maxY] = middleOf(circles)
  return 0.1 * Math.min(maxX - minX, maxY - minY)
}

/** Limits of cells for some circles. */
const LIMITS: readonly (readonly [name: string, limits: (circles: Float64Array) => BoundsOptions])[] = [
  ['all circles', () => ({})],
  ['a box', (circles) => ({ bounds: middleOf(circles) })],
  ['a polygon', (circles) => ({ bounds: ConvexPolygon.from(triangleIn(circles)) })],
  ['a distance', (circles) => ({ maxDistance: distanceFor(circles) })],
  ['a region', (circles) => ({ region: region([triangleIn(circles).map(({ x, y }) => [x, y])]) })],
]

/** Points on the way from the first circle, which is the large one of the hub, to each other one. */
function pointsBetween(circles: Float64Array, shares: readonly number[] = [0.1, 0.9, 1]): number[] {
  const first = circleAt(circles, 0)
  const points: number[] = []
  for (let i = 0; i < circles.length / 3; i++) {
    const { x, y } = circleAt(circles, i)
    for (const share of shares) points.push(first.x + share * (x - first.x), first.y + share * (y - first.y))
  }
  return points
}

/** Functions of a diagram with the families on which they are measured. */
type Row = readonly [name: string, prepare: Prepare, families?: readonly FamilyName[]]

function itGrows(rows: readonly Row[]): void {
  for (const [name, prepare, families = ALL] of rows) it(name, () => expectGrowth(prepare, families))
}

describe.each(LIMITS)('n log n steps within %s are enough for', (_, limitsFor) => {
  const within = (use: (diagram: ComputedDiagram, limits: BoundsOptions) => unknown): Prepare => {
    return (circles) => {
      const diagram = library.compute(circles)
      const limits = limitsFor(circles)
      return () => use(diagram, limits)
    }
  }
  const ofCells = (use: (diagram: ComputedDiagram, i: number, limits: BoundsOptions) => unknown) =>
    within((diagram, limits) => {
      for (let i = 0; i < diagram.circles.length / 3; i++) use(diagram, i, limits)
    })
  itGrows([
    ['neighbors of each circle', ofCells((diagram, i, limits) => diagram.neighbors(i, limits))],
    ['cellArea of each circle', ofCells((diagram, i, limits) => diagram.cellArea(i, limits))],
    ['cellPath of each circle', ofCells((diagram, i, limits) => diagram.cellPath(i, limits))],
    ['cellAreas', within((diagram, limits) => diagram.cellAreas(limits))],
    ['render, renderBounds', within((diagram, limits) => [diagram.render(limits), diagram.renderBounds(limits)])],
    [
      'cellPolygons',
      within((diagram, limits) => Array.from(diagram.cellPolygons(limits as BoundsOptions & { region: undefined }))),
    ],
  ])
})

describe('n log n steps are enough for', () => {
  const ofFinder: Prepare = ofDiagram((diagram) => {
    const points = pointsBetween(diagram.circles)
    for (let k = 0; k < points.length; k += 2) diagram.find(points[k] as number, points[k + 1] as number)
    diagram.findAll(points)
  })
  itGrows([
    [
      'compute',
      (circles) => () => library.compute(Array.from({ length: circles.length / 3 }, (_, i) => circleAt(circles, i))),
    ],
    ['update', ofDiagram((diagram) => diagram.update())],
    ['find, findAll', ofFinder],
    [
      'find in a power diagram',
      (circles) => {
        // These circles have the cells of the points, and their centers lie outside their cells.
        const shifted = circles.map((value, k) => {
          const x = circles[k - (k % 3)] as number
          return [x + 20, value, Math.sqrt(40 * x + 500)][k % 3] as number
        })
        const power = metrics.compute(shifted, { metric: 'power' })
        return () => power.findAll(pointsBetween(circles, [0.1, 0.4]))
      },
      ['hub'],
    ],
    [
      'contains',
      ofEach('circles', (diagram, i) =>
        diagram.contains(i, circleAt(diagram.circles, i).x, circleAt(diagram.circles, i).y),
      ),
    ],
    ['cell', ofEach('circles', (diagram, i) => diagram.cell(i))],
    ['edgePath', ofEach('edges', (diagram, e) => diagram.edgePath(e))],
    ['halfedges', ofDiagram((diagram) => diagram.halfedges)],
    ['renderCircles, renderDual', ofDiagram((diagram) => [diagram.renderCircles(), diagram.renderDual()])],
    [
      'convexHull, renderHull, hullPolygon',
      ofDiagram((diagram) => [convexHull(diagram), diagram.renderHull(), diagram.hullPolygon()]),
    ],
    ['toJSON, fromJSON', ofDiagram((diagram) => [fromJSON(diagram.toJSON()), fromJSON(JSON.stringify(diagram))])],
    [
      'circleAt, vertexAt, edgeAt',
      ofEach('vertices', (diagram, i) => [vertexAt(diagram, i), edgeAt(diagram, i), circleAt(diagram.circles, 0)]),
    ],
    [
      'curves',
      ofEach('edges', (diagram, e) => {
        for (const arc of clipCurve(edgeCurve(diagram, e), { bounds: [-15, -15, 15, 15] })) {
          rationalBezier(arc)
          polyline(arc, 1e-3)
          cubicBeziers(arc, 1e-3)
        }
      }),
    ],
    [
      'cellOutline and its measures',
      ofEach('circles', (diagram, i) => {
        const outline = diagram.cellOutline(i)
        return [outlineArea(outline), outlineCentroid(outline), outlinePerimeter(outline)]
      }),
    ],
    [
      'cellCentroid, cellPerimeter',
      ofEach('circles', (diagram, i) => [diagram.cellCentroid(i), diagram.cellPerimeter(i)]),
    ],
    ['cellCentroids, cellPerimeters', ofDiagram((diagram) => [diagram.cellCentroids(), diagram.cellPerimeters()])],
    ['closestPair', ofDiagram(closestPair)],
    ['mergeVertices', ofDiagram((diagram) => mergeVertices(diagram))],
    ['largestEmptyDiscCenteredInHull', ofDiagram((diagram) => largestEmptyDiscCenteredInHull(diagram))],
    [
      'largestEmptyDiscCenteredIn',
      ofDiagram((diagram) => largestEmptyDiscCenteredIn(diagram, { bounds: middleOf(diagram.circles) })),
    ],
    [
      'largestEmptyDiscInside',
      ofDiagram((diagram) => largestEmptyDiscInside(diagram, { bounds: middleOf(diagram.circles) })),
    ],
    ['clearestPath', ofDiagram((diagram) => clearestPath(diagram, { x: 0.1, y: 0.2 }, { x: 11, y: 0.3 }))],
    [
      'clearestPath in bounds',
      ofDiagram((diagram) => {
        const [minX, minY, maxX, maxY] = middleOf(diagram.circles)
        return clearestPath(diagram, { x: minX, y: minY }, { x: maxX, y: maxY }, { bounds: [minX, minY, maxX, maxY] })
      }),
    ],
    [
      'Trace.event, Trace.at',
      (circles) => {
        const trace = library.trace(circles, { method: 'flip' })
        return () => {
          for (let k = 0; k < trace.length; k++) trace.event(k)
          trace.at(trace.length)
        }
      },
    ],
    [
      'computePeriodic and its queries',
      (circles) => () => {
        const { minX, minY, maxX, maxY } = boxAround(circles, 0.05)
        const periodic = library.computePeriodic(circles, { a: [maxX - minX, 0], b: [0, maxY - minY] })
        const points = pointsBetween(circles)
        for (let k = 0; k < points.length; k += 2) periodic.find(points[k] as number, points[k + 1] as number)
        for (let i = 0; i < periodic.circleCount; i++) periodic.neighbors(i)
        periodic.contactsCsv()
      },
      // Images of long rows are many.
      ['uniform', 'hub', 'strips'],
    ],
    [
      'readers and writers of circles',
      (circles) => {
        const properties = Array.from({ length: circles.length / 3 }, (_, i) => `{"name": "${i}"}`)
        const attributes = { properties, ids: [], heights: [], collection: '' }
        return () => files.readCircleFile(files.writeCircles(circles, { format: 'geojson', attributes }))
      },
    ],
    ['readers and writers of diagrams', ofDiagram((diagram) => files.readDiagram(files.writeDiagram(diagram)))],
    [
      'region',
      (circles) => () =>
        region([
          Array.from({ length: circles.length / 3 }, (_, k) => {
            const angle = ((6 * k) / circles.length) * Math.PI
            return [Math.cos(angle), Math.sin(angle)] as const
          }),
        ]),
    ],
    [
      'links',
      (circles) => async () => {
        const count = circles.length / 3
        const names = Array.from({ length: count }, (_, i) => `${i}`)
        const edits = names.map((_, id) => ({ kind: 'remove', id }) as const)
        await decodeLink(await encodeLink({ circles, names, edits }))
      },
    ],
  ])
})

describe('steps in proportion to the changes are enough to follow an editor, and to find points between the edits', () => {
  /** The circles of a diagram in a random order. */
  const shuffled = (circles: Float64Array): Circle[] => {
    const random = seededRandom(1)
    return Array.from({ length: circles.length / 3 }, (_, i) => ({ circle: circleAt(circles, i), key: random() }))
      .sort((one, other) => one.key - other.key)
      .map(({ circle }) => circle)
  }
  /** Whether a circle is not one of the many points or random circles. */
  const isLarge = ({ r }: Circle) => r === 10
  /** Edits the first circles of an input, a share of them, and counts the steps of a diagram that follows. */
  const following = (share: number, edit: (editor: DiagramEditor, circles: readonly Circle[]) => void): Prepare => {
    return (given) => {
      const circles = shuffled(given)
      const editor = library.edit(circles.slice(0, share * circles.length))
      const snapshot = editor.snapshot()
      const changes: Change[] = []
      editor.onchange = (change) => changes.push(change)
      edit(editor, circles)
      // The first search takes linear time.
      snapshot.find(0, 0)
      return () => {
        changes.forEach((change, k) => {
          snapshot.apply(change)
          const { x, y } = circles[k] as Circle
          snapshot.find(0.9 * x, 0.9 * y)
          snapshot.find(x, y)
        })
      }
    }
  }
  itGrows([
    [
      'insert',
      following(0.5, (editor, circles) => {
        for (const circle of circles.slice(circles.length / 2)) editor.insert(circle)
      }),
      SMALL_HULL,
    ],
    [
      'remove',
      following(1, (editor, circles) => {
        for (let id = 0; id < circles.length; id += 2) if (!isLarge(circles[id] as Circle)) editor.remove(id)
      }),
      SMALL_HULL,
    ],
    [
      'replace',
      following(1, (editor, circles) => {
        circles.forEach((circle, id) => {
          if (!isLarge(circle)) editor.replace(id, { ...circle, x: circle.x * (1 + 1e-5) })
        })
      }),
      SMALL_HULL,
    ],
  ])
})
