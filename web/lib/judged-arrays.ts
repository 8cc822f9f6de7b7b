// SPDX-License-Identifier: GPL-3.0-or-later
import type { DiagramData } from './diagram-data.ts'
import { CircleVoronoiError } from './errors.ts'

/**
 * What of a diagram is judged.
 *
 * @category Loading
 */
export type Verifiable = Omit<DiagramData, 'metric' | 'weights' | 'certificate' | 'stats'> & {
  readonly weights?: boolean | undefined
}

/**
 * The arrays of a diagram as the core takes them: embind would convert whatever it is given.
 *
 * @throws CircleVoronoiError `badInput`, if one has another type or length
 */
export function judgedArrays({ weights = false, circles, ...arrays }: Verifiable) {
  const { vertices, vertexCircles, edges, hidden, hull, nextSide, vertexSides, firstSide } = arrays
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

function checkArray(
  name: string,
  array: unknown,
  type: Float64ArrayConstructor | Int32ArrayConstructor,
  size: number,
): void {
  if (array instanceof type && array.length % size === 0) return
  throw new CircleVoronoiError('badInput', -1, `${name} is no ${type.name} of ${size} numbers each.`)
}
