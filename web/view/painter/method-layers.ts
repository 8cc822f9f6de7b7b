// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../lib/diagram-data.ts'
import type { CircleVoronoi } from '../../lib/index.ts'
import { type Layers, METHOD_LAYERS, type MethodLayer, MOST_TRACED } from '../layers.ts'

/** What a layer of the method shows: lists as of `DataLayer`. */
export interface MethodData {
  readonly name: MethodLayer
  readonly points?: Float64Array
  readonly segments?: Float64Array
  readonly discs?: Float64Array
}

/** Whether the layers show something of the method, of so many circles. */
export function isTraced(layers: Layers, circles: number): boolean {
  return circles <= MOST_TRACED && METHOD_LAYERS.some((name) => layers[name])
}

/** What the touching disc method makes of circles, with its dynamic samples. */
export function methodData(
  library: CircleVoronoi,
  { circles }: { readonly circles: Float64Array },
): readonly MethodData[] {
  const trace = library.trace(circles)
  const { samples, sampleEdges, antipodalDiscs, directedEdges } = trace.at(trace.length)
  const discOf = (event: number) => [...trace.discs.subarray(3 * event, 3 * event + 3)]
  const pointOf = (event: number) => discOf(event).slice(0, 2)
  const sampleOf = (number: number) => pointOf(at(samples, number))
  const centerOf = (circle: number) => [at(circles, 3 * circle), at(circles, 3 * circle + 1)]
  const list = (events: Int32Array, numbersOf: (event: number) => readonly number[]) =>
    Float64Array.from([...events].flatMap(numbersOf))
  return [
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
}
