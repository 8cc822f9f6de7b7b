// SPDX-License-Identifier: GPL-3.0-or-later
// Only type-checked.
import {
  type Certificate,
  type ComputedDiagram,
  Diagram,
  type DiagramFile,
  type DiagramSnapshot,
  ERROR_CODES,
  type ErrorCode,
  fromJSON,
  loadCircleVoronoi,
  type PathSink,
  type Stage,
} from 'circle-voronoi'
import { loadFiles } from 'circle-voronoi/files'
import { decodeLink, encodeLink, type LinkState } from 'circle-voronoi/link'
import { loadMetrics, type Metrics } from 'circle-voronoi/metrics'
import { type CircleVoronoiWorker, createWorker } from 'circle-voronoi/worker'

const library = await loadCircleVoronoi({ wasm: new URL('https://example.org/circle-voronoi.wasm') })
const diagram: Diagram = library.compute([{ x: 0, y: 0, r: 1 }], { method: 'flip' })
export const certificate: Certificate = library.certify(diagram)
export const path: string = diagram.render()
export const neighbors: Int32Array = diagram.neighbors(0)
export const code: ErrorCode | undefined = ERROR_CODES[0]
const metrics: Metrics = await loadMetrics({ library })
export const power: ComputedDiagram = metrics.compute([], { metric: 'power', weights: true })
export const ordinary: Diagram = metrics.compute([{ at: 1 }], {
  metric: 'centers',
  x: ({ at }) => at,
  y: () => 0,
  r: () => 0,
})

// Uses every option.
const { bounds, ...rest } = { bounds: [0, 0, 1, 1] as const, tolerance: 0.1 }
export const texts: string[] = [
  diagram.render({ bounds, ...rest, digits: 3 }),
  diagram.cellPath(0, { bounds: { minX: 0, minY: 0, maxX: 1, maxY: 1 } }),
  diagram.edgePath(0, { tolerance: 0.1 }),
  diagram.renderBounds({ bounds }),
  diagram.renderCircles({ digits: 2 }),
  diagram.renderDual(),
  diagram.renderHull({}),
]
declare const context: PathSink
diagram.render({ context, bounds, tolerance: 0.1 })
diagram.renderCircles({ context })
export const polygon: [number, number][] | undefined = diagram.cellPolygon(0, { bounds, tolerance: 0.1 })
export const polygons: number[] = [...diagram.cellPolygons({ bounds })].map(({ index }) => index)
export const hullPolygon = diagram.hullPolygon({ tolerance: 0.1 })
export const measures: number[] = [diagram.cellArea(0, { bounds }), diagram.cellPerimeter(0), ...diagram.cellAreas()]
export const centroid: { x: number; y: number } | undefined = diagram.cellCentroid(0, { bounds })
export const dual: readonly Int32Array[] = [diagram.triangles, diagram.halfedges]
library.compute([[0, 0, 1]], {
  method: 'touching-disc',
  candidates: 'dynamic',
  samples: 1,
  resample: true,
  progress: (stage: Stage, done: number) => `${stage} ${done}`,
})
library.compute(new Set([new Float32Array(3)]))
library.compute([{ city: 'a', size: 2 }], { x: ({ size }) => size, y: (_, i) => i, r: () => 1, weights: true })
library.compute([{ x: 0, y: 0 }], { r: ({ x }) => x })
library.compute([[0, 0]], { r: () => 1 })
export const updated: ComputedDiagram = library.compute([[0, 0, 1]]).update()
export const followed: DiagramSnapshot = library.edit([[0, 0, 1]]).snapshot()
export const file: DiagramFile = diagram.toJSON()

// Transfers a diagram to another thread and back without a copy.
declare function postMessage(message: unknown, transfer: ArrayBuffer[]): void
postMessage(diagram, [diagram.vertices.buffer, diagram.edges.buffer])
export const received: Diagram = new Diagram(structuredClone(diagram, { transfer: [diagram.circles.buffer] }))
export const reads: Diagram[] = [fromJSON(JSON.stringify(diagram)), fromJSON(file), new Diagram(diagram)]
const files = await loadFiles()
export const circlesRead: Float64Array = files.readCircles(new Uint8Array(), { name: 'circles.csv' })
export const written: string[] = [
  files.writeCircles(circlesRead, { format: 'geojson' }),
  files.writeDiagram(files.readDiagram('{}'), { format: 'svg', bounds: [0, 0, 1, 1], tolerance: 0.1 }),
]
export const link: LinkState = await decodeLink(
  await encodeLink({ circles: [[0, 0, 1]], edits: [{ kind: 'remove', id: 0 }], view: { x: 0, y: 0, span: 1 } }),
)
// The memory of a diagram is transferable.
export const buffers: ArrayBuffer[] = [diagram.vertices.buffer, diagram.edges.buffer]

const worker: CircleVoronoiWorker = createWorker({ wasm: new Uint8Array(8) })
export const later: Diagram = await worker.compute(new Float64Array(3), {
  signal: AbortSignal.timeout(1000),
  metric: 'power',
  weights: true,
  progress: (stage: Stage, done: number) => `${stage} ${done}`,
})
worker.dispose()

// @ts-expect-error: no such method
library.compute([], { method: 'magic' })
// @ts-expect-error: the library alone has one metric
library.compute([], { metric: 'power' })
// @ts-expect-error: no such metric
metrics.compute([], { metric: 'magic' })
// @ts-expect-error: a circle has a radius
library.compute([{ x: 0, y: 0 }])
// @ts-expect-error: there is no such option
createWorker({ url: '' })
// @ts-expect-error: a context is an option
diagram.render(context)
// @ts-expect-error: digits are for text, not for a context
diagram.render({ context, digits: 3 })
// @ts-expect-error: a datum without x, y and r needs functions that find them
library.compute([{ city: 'a' }], { x: () => 1, y: () => 2 })
// @ts-expect-error: only diagrams that compute made can be computed again
new Diagram(diagram).update()
// @ts-expect-error: only snapshots follow an editor
diagram.indexOf(0)
