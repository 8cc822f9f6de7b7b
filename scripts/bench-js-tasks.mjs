// SPDX-License-Identifier: GPL-3.0-or-later
// The tasks of `npm run bench:js`, in Node and in a page.
import { Delaunay } from 'd3-delaunay'

const TURNS = 7
/** Short tasks are repeated until they take this long, in milliseconds. */
const ENOUGH = 50
/** More cells or edges would only take longer. */
const MOST_PATHS = 100_000
/** d3-delaunay walks through a good part of all circles between distant queries. */
const MOST_WALKS = 10_000

/**
 * Returns a row for each task and size. The package and d3-delaunay take turns; the ratio is the median over the turns.
 */
export function benchJs(library, sizes) {
  return sizes.flatMap((size) => tasksOf(library, size).map((task) => measured(task, size)))
}

/**
 * Returns a row for each function of a diagram that exists in C++, too: its time in TypeScript in microseconds, and the
 * time of a call into WebAssembly that receives the diagram, traverses it once and returns a number for each part
 * (`finalCells`).
 */
export function benchTwins(library, geometry, size) {
  const { circles, diagram, bounds, random } = inputOf(library, size)
  const side = bounds[2]
  const [minX, minY, maxX, maxY] = bounds
  let next = 0
  const one = () => next++ % size
  const anywhere = () => ({ x: side * random(), y: side * random() })
  const places = Float64Array.from(circles, () => side * random())
  const known = { box: { minX, minY, maxX, maxY }, maxRadius: 1 }
  const tasks = {
    'a call with the diagram': () => library.finalCells(diagram, known),
    'edgeCurve of one': () => geometry.edgeCurve(diagram, one()),
    'neighbors of one': () => diagram.neighbors(one()),
    'find one': () => diagram.find(side * random(), side * random()),
    'contains of one': () => diagram.contains(one(), 1, 1),
    'cellPath of one': () => diagram.cellPath(one(), { bounds }),
    'cellArea of one': () => diagram.cellArea(one(), { bounds }),
    convexHull: () => geometry.convexHull(diagram),
    'findAll, 1.5 places a circle': () => diagram.findAll(places),
    closestPair: () => geometry.closestPair(diagram),
    mergeVertices: () => geometry.mergeVertices(diagram),
    largestEmptyDiscCenteredIn: () => geometry.largestEmptyDiscCenteredIn(diagram, { bounds }),
    largestEmptyDiscCenteredInHull: () => geometry.largestEmptyDiscCenteredInHull(diagram),
    largestEmptyDiscInside: () => geometry.largestEmptyDiscInside(diagram, { bounds }),
    clearestPath: () => geometry.clearestPath(diagram, anywhere(), anywhere()),
    cellAreas: () => diagram.cellAreas({ bounds }),
    render: () => diagram.render({ bounds }),
  }
  const turns = Array.from({ length: TURNS }, () => Object.values(tasks).map(millisecondsOf))
  return Object.keys(tasks).map((task, k) => ({
    task,
    microseconds: Number((1000 * median(turns.map((times) => times[k]))).toPrecision(3)),
    calls: Number(median(turns.map((times) => times[k] / times[0])).toPrecision(2)),
  }))
}

/** The measured functions of the package and of d3-delaunay. */
function tasksOf(library, size) {
  const { circles, diagram, bounds, random } = inputOf(library, size)
  const side = bounds[2]
  const points = Float64Array.from({ length: 2 * size }, (_, k) => circles[3 * (k >> 1) + (k & 1)])
  const voronoi = new Delaunay(points).voronoi(bounds)
  const count = Math.ceil(side)
  const raster = Float64Array.from({ length: 2 * count * count }, (_, k) =>
    k & 1 ? Math.floor((k >> 1) / count) + 0.5 : ((k >> 1) % count) + 0.5,
  )
  const anywhere = Float64Array.from({ length: Math.min(raster.length, 2 * MOST_WALKS) }, () => side * random())
  const findChained = (find) => (where) => {
    let last = 0
    let sum = 0
    for (let k = 0; k < where.length; k += 2) sum += last = find(where[k], where[k + 1], last)
    return sum
  }
  const ours = findChained((x, y, hint) => diagram.find(x, y, hint))
  const theirs = findChained((x, y, hint) => voronoi.delaunay.find(x, y, hint))
  const eachCell = (path) => () => {
    let length = 0
    for (let i = 0; i < Math.min(size, MOST_PATHS); i++) length += path(i)?.length ?? 0
    return length
  }
  return [
    { task: 'compute', ours: () => library.compute(circles), theirs: () => new Delaunay(points).voronoi(bounds) },
    {
      task: 'cellPath of each',
      ours: eachCell((i) => diagram.cellPath(i, { bounds })),
      theirs: eachCell((i) => voronoi.renderCell(i)),
    },
    {
      task: 'cellPolygon of each',
      ours: eachCell((i) => diagram.cellPolygon(i, { bounds })),
      theirs: eachCell((i) => voronoi.cellPolygon(i)),
    },
    { task: 'render', ours: () => diagram.render({ bounds }), theirs: () => voronoi.render() },
    { task: 'find in raster order, chained', ours: () => ours(raster), theirs: () => theirs(raster) },
    { task: 'find anywhere', ours: () => ours(anywhere), theirs: () => theirs(anywhere) },
  ]
}

/** Circles spread evenly over a square, with about one unit of area each. Some overlap. */
function inputOf(library, size) {
  const random = randomNumbers(1)
  const side = Math.sqrt(size)
  const circles = Float64Array.from({ length: 3 * size }, (_, k) => (k % 3 === 2 ? 0.3 * random() : side * random()))
  return { circles, diagram: library.compute(circles), bounds: [0, 0, side, side], random }
}

function measured({ task, ours, theirs }, size) {
  /** @type {Record<'ours' | 'theirs', number[]>} */
  const times = { ours: [], theirs: [] }
  for (let turn = 0; turn < TURNS; turn++) {
    times.ours.push(millisecondsOf(ours))
    times.theirs.push(millisecondsOf(theirs))
  }
  const ratio = median(times.ours.map((time, turn) => time / times.theirs[turn]))
  return {
    task,
    n: size,
    'ours, ms': Number(median(times.ours).toPrecision(3)),
    'd3-delaunay, ms': Number(median(times.theirs).toPrecision(3)),
    ratio: Number(ratio.toFixed(2)),
  }
}

function millisecondsOf(run) {
  let count = 0
  const start = performance.now()
  do {
    run()
    count += 1
  } while (performance.now() - start < ENOUGH)
  return (performance.now() - start) / count
}

function median(values) {
  return [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)]
}

function randomNumbers(seed) {
  let state = seed
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0
    return state / 2 ** 32
  }
}
