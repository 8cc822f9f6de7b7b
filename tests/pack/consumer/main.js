// SPDX-License-Identifier: GPL-3.0-or-later
// Uses the package as its README says, in the same way in Node and in a page.
import { CircleVoronoiError, loadCircleVoronoi } from 'circle-voronoi'
import { loadMetrics } from 'circle-voronoi/metrics'
import { loadRegions } from 'circle-voronoi/regions'
import { createWorker } from 'circle-voronoi/worker'

export const CIRCLES = [
  { x: 0, y: 0, r: 1 },
  { x: 6, y: 0, r: 1 },
  { x: 0, y: 8, r: 1 },
]

/** Enough circles to be canceled before they are done. */
const MANY = Float64Array.from({ length: 300_000 }, (_, i) => Math.sin(i * i)).map((value, i) =>
  i % 3 === 2 ? Math.abs(value) / 1000 : value,
)

/** Returns the results as text. */
export async function use(options, metricsOptions, regionsOptions) {
  const library = await loadCircleVoronoi(options)
  const here = library.compute(CIRCLES)
  const { compute } = await loadMetrics({ library, ...metricsOptions })
  const power = compute(CIRCLES, { metric: 'power' })
  const worker = createWorker(options)
  const stages = []
  const canceled = await canceledIn(worker)
  const there = await worker.compute(CIRCLES, { progress: (stage) => stages.push(stage) })
  const { region } = await loadRegions(regionsOptions)
  const square = region([
    [
      [0, 0],
      [4, 0],
      [4, 4],
      [0, 4],
    ],
  ])
  const powerThere = await worker.compute(CIRCLES, { metric: 'power' })
  const { areas } = await worker.fitAreas(
    [
      [1, 1],
      [3, 2],
    ],
    [1, 3],
    { region: square, shares: true },
  )
  worker.dispose()
  return JSON.stringify({
    vertex: [...here.vertices],
    certified: library.certify(there).certified,
    found: [here.find(5, 1), there.find(1, 7)],
    path: there.render() === here.render(),
    power: [power, powerThere].map(({ vertices }) => [...vertices.slice(0, 2)]),
    stages: stages.includes('certify'),
    canceled,
    areas: Array.from(areas, (area) => area.toFixed(6)),
    code: codeOf(() => library.compute([{ x: 0, y: 0, r: -1 }])),
  })
}

function codeOf(action) {
  try {
    action()
  } catch (error) {
    return error instanceof CircleVoronoiError ? error.code : String(error)
  }
}

async function canceledIn(worker) {
  const controller = new AbortController()
  const progress = () => controller.abort('changed my mind')
  return worker.compute(MANY, { progress, signal: controller.signal }).catch((reason) => reason)
}
