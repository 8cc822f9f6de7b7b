// SPDX-License-Identifier: GPL-3.0-or-later
// Only its types are checked.
import {
  type Certificate,
  type Diagram,
  ERROR_CODES,
  type ErrorCode,
  loadCircleVoronoi,
  type Stage,
} from 'circle-voronoi'
import { loadComparison } from 'circle-voronoi/comparison'
import { type CircleVoronoiWorker, createWorker } from 'circle-voronoi/worker'

const library = await loadCircleVoronoi({ wasm: new URL('https://example.org/circle-voronoi.wasm') })
const diagram: Diagram = library.compute([{ x: 0, y: 0, r: 1 }], { method: 'flip' })
export const certificate: Certificate = library.certify(diagram)
export const path: string = diagram.render()
export const neighbors: Int32Array = diagram.neighbors(0)
export const code: ErrorCode | undefined = ERROR_CODES[0]
export const power: Diagram = (await loadComparison(library)).computeComparison([], 'power')

const worker: CircleVoronoiWorker = createWorker({ wasm: new Uint8Array(8) })
export const later: Diagram = await worker.computeAsync(new Float64Array(3), {
  signal: AbortSignal.timeout(1000),
  progress: (stage: Stage, done: number) => `${stage} ${done}`,
})
worker.dispose()

// @ts-expect-error: no such method
library.compute([], { method: 'magic' })
// @ts-expect-error: a circle has a radius
library.compute([{ x: 0, y: 0 }])
// @ts-expect-error: there is no such option
createWorker({ url: '' })
