// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../lib/base/diagram-data.ts'
import type { Diagram } from '../../lib/index.ts'
import type { CircleVoronoi } from '../../lib/wasm/library.ts'
import { type Layers, type MethodLayer, SAMPLES } from '../layers.ts'
import type { MethodFound } from '../protocol.ts'
import { methodOutcome } from './method-outcome.ts'

/** The data of a layer of the method, as in `DataLayer`. */
export interface MethodData {
  readonly name: MethodLayer
  readonly points?: Float64Array
  readonly segments?: Float64Array
  readonly discs?: Float64Array
}

/** The intermediate results of the touching disc method, and the edges that it misses. */
export interface MethodResult {
  readonly data: readonly MethodData[]
  readonly found: MethodFound
  /** Edges of the diagram. */
  readonly missed: ReadonlySet<number>
}

export function methodResult(library: CircleVoronoi, diagram: Diagram, layers: Layers): MethodResult {
  const { circles } = diagram
  const { candidates, sampleCount = SAMPLES[candidates].usual } = layers
  const trace = library.trace(circles, { candidates, samples: sampleCount })
  const { samples, sampleEdges, antipodalDiscs, directedEdges } = trace.at(trace.length)
  const discOf = (event: number) => [...trace.discs.subarray(3 * event, 3 * event + 3)]
  const pointOf = (event: number) => discOf(event).slice(0, 2)
  const sampleOf = (number: number) => pointOf(at(samples, number))
  const centerOf = (circle: number) => [at(circles, 3 * circle), at(circles, 3 * circle + 1)]
  const list = (events: Int32Array, numbersOf: (event: number) => readonly number[]) =>
    Float64Array.from([...events].flatMap(numbersOf))
  const { vertices, edges, missed } = methodOutcome(diagram, trace.diagram)
  const data: readonly MethodData[] = [
    { name: 'samples', points: list(samples, pointOf) },
    {
      name: 'sampleGraph',
      segments: list(sampleEdges, (k) => [
        ...sampleOf(at(trace.numbers, 2 * k)),
        ...sampleOf(at(trace.numbers, 2 * k + 1)),
      ]),
    },
    { name: 'antipodalDiscs', discs: list(antipodalDiscs, discOf) },
    {
      name: 'directedEdges',
      segments: list(directedEdges, (k) => [
        ...centerOf(at(trace.circles, 3 * k)),
        ...centerOf(at(trace.circles, 3 * k + 1)),
      ]),
    },
  ]
  return { data, found: { vertices, edges, samples: samples.length }, missed: new Set(missed) }
}
