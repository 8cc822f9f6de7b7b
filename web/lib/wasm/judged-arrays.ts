// SPDX-License-Identifier: GPL-3.0-or-later
import { checkMemory, checkMetric, shown } from '../base/check.ts'
import { CircleVoronoiError } from '../base/errors.ts'
import type { DiagramData, Metric } from '../base/types.ts'

/**
 * The parts of a diagram that `certify` reads.
 *
 * @category Loading
 */
export type Verifiable = Omit<DiagramData, 'metric' | 'weights' | 'certificate' | 'stats'> & {
  /** Default: `circles`. A power diagram needs the `certify` of `loadMetrics`. */
  readonly metric?: Metric | undefined
  readonly weights?: boolean | undefined
}

/**
 * Returns the arrays of a diagram for the core. Types are checked here, because embind would convert any value.
 *
 * @throws CircleVoronoiError `badInput`, if an array or `weights` has the wrong type, or an array the wrong length
 */
export function judgedArrays(diagram: Verifiable) {
  // A value that is not an object has no arrays.
  const { weights = false, circles, ...arrays }: Verifiable = Object(diagram)
  const { vertices, vertexCircles, edges, hidden, hull, nextSide, vertexSides, firstSide } = arrays
  if (typeof weights !== 'boolean') refuse(`weights is not true or false, but ${shown(weights)}.`)
  checkArray('circles', circles, Float64Array, 3)
  checkArray('vertices', vertices, Float64Array, 3)
  checkArray('vertexCircles', vertexCircles, Int32Array, 3)
  checkArray('edges', edges, Int32Array, 4)
  checkArray('hidden', hidden, Int32Array, 2)
  checkArray('hull', hull, Int32Array, 1)
  checkArray('nextSide', nextSide, Int32Array, 2)
  checkArray('vertexSides', vertexSides, Int32Array, 3)
  checkArray('firstSide', firstSide, Int32Array, 1)
  return { weights, circles, vertices, vertexCircles, edges, hidden, hull, nextSide, vertexSides, firstSide }
}

/**
 * Returns the arrays of a diagram for the core, which knows the metric `circles` only: centers are circles of radius 0.
 *
 * @throws CircleVoronoiError `badInput`, as `judgedArrays`, or if the diagram is a power diagram
 */
export function judgedCircles(diagram: Verifiable, caller: string) {
  const arrays = judgedArrays(diagram)
  const { metric = 'circles' } = diagram
  checkMetric({ metric }, caller, 'circles', 'centers')
  if (metric === 'circles') return arrays
  return { ...arrays, weights: false, circles: arrays.circles.map((value, k) => (k % 3 === 2 ? 0 : value)) }
}

function checkArray(
  name: string,
  array: unknown,
  type: Float64ArrayConstructor | Int32ArrayConstructor,
  size: number,
): void {
  checkMemory(array, 'The diagram', name)
  if (array instanceof type && array.length % size === 0) return
  refuse(`${name} is no ${type.name} of ${size} numbers each.`)
}

function refuse(message: string): never {
  throw new CircleVoronoiError('badInput', message)
}
