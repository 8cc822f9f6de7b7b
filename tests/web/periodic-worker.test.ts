// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic diagrams and fits in a worker, with a thread that answers with the code of real ones.
import { readFileSync } from 'node:fs'
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { type Lattice, PeriodicDiagram } from '../../web/lib/index.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import type { ThreadEvents } from '../../web/lib/threads/thread.ts'
import type { ComputeRequest, FitRequest, Reply, Request, Start } from '../../web/lib/threads/worker-messages.ts'
import { type CircleVoronoiWorker, createWorker } from '../../web/lib/worker.ts'
import { useThreads } from './fake-threads.ts'
import { library } from './library.ts'

const read = (name: string) => readFileSync(new URL(`../../web/lib/generated/${name}.wasm`, import.meta.url))
const { fitAreas } = await loadRegions({ wasm: read('circle-voronoi-regions') })
const BOX: Lattice = { a: [4, 0], b: [1, 3] }
const CIRCLES: [number, number, number][] = [
  [1, 1, 0.5],
  [3, 2, 0.2],
  [9, -4.5, 0.3],
]

vi.mock('../../web/lib/threads/thread.ts', () => import('./fake-threads.ts'))
let worker: CircleVoronoiWorker
let events: ThreadEvents
const requests: Request[] = []

beforeEach(() => {
  requests.length = 0
  useThreads((given) => {
    events = given
    return {
      post: (message: Start | Request) => {
        if (!('module' in message)) requests.push(structuredClone(message))
      },
      keepAlive() {},
      terminate() {},
    }
  })
  worker = createWorker({ wasm: read('circle-voronoi') })
})
afterEach(() => worker.dispose())

async function asked(): Promise<Request> {
  await vi.waitFor(() => expect(requests).toHaveLength(1), { timeout: 40_000 })
  return requests[0] as Request
}

it('computes a periodic diagram as the library does', async () => {
  const progress = vi.fn()
  const promise = worker.computePeriodic(CIRCLES, { a: BOX.a, b: [...BOX.b] }, { progress })
  const { circles, lattice, options, tellsProgress } = (await asked()) as ComputeRequest
  expect({ lattice, options, tellsProgress }).toEqual({ lattice: BOX, options: {}, tellsProgress: true })
  const here = library.computePeriodic(circles, lattice as Lattice)
  events.onReply({ progress: ['certify', 1] })
  events.onReply(structuredClone<Reply>({ periodic: here }))
  const there = await promise
  expect(progress).toHaveBeenCalledWith('certify', 1)
  expect(there).toBeInstanceOf(PeriodicDiagram)
  expect(there.neighbors(0)).toEqual(here.neighbors(0))
  expect(there.cellPath(2)).toBe(here.cellPath(2))
  expect(there.find(-20, 13)).toEqual(here.find(-20, 13))
})

it('fits areas in a box with the module that this thread loaded', async () => {
  const areas = [2, 4, 6]
  const compile = vi.spyOn(WebAssembly, 'compile')
  const promise = worker.fitAreas(CIRCLES, areas, { lattice: BOX, relax: 2 })
  const { fit, region, wasm } = (await asked()) as FitRequest
  expect(region).toBeUndefined()
  expect(wasm).toBeInstanceOf(WebAssembly.Module)
  // The module of the worker alone.
  expect(compile).toHaveBeenCalledOnce()
  compile.mockRestore()
  expect(fit).toMatchObject({ relax: 2, lattice: Float64Array.of(4, 0, 1, 3), areas: Float64Array.from(areas) })
  const here = fitAreas(fit.sites, fit.areas, { lattice: BOX, relax: 2 })
  events.onReply(structuredClone<Reply>({ periodicFit: here }))
  const there = await promise
  expect(there.periodic).toBeInstanceOf(PeriodicDiagram)
  expect(there.weights).toEqual(here.weights)
  expect(there.periodic.cellArea(1)).toBe(here.periodic.cellArea(1))
})
