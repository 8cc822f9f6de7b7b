// SPDX-License-Identifier: GPL-3.0-or-later
import { checkMemory, shown } from './check.ts'
import { CircleVoronoiError } from './errors.ts'
import { missingNumber } from './missing-number.ts'
import type { Circle, Float64s } from './types.ts'

/**
 * A circle, given as an object or as an array of x, y and r.
 *
 * @category Loading
 */
export type CircleLike = Circle | ArrayLike<number>

/**
 * Circles, given as one typed array with x, y, r of each, or as any iterable.
 *
 * @category Loading
 */
export type Circles = Float64Array | Float32Array | Iterable<CircleLike>

/**
 * A function that finds a number in a datum, as in d3-delaunay.
 *
 * @category Loading
 */
export type Accessor<Datum> = (datum: Datum, index: number, data: Iterable<Datum>) => number

/**
 * Options for data that are not circles: functions that find x, y and r in a datum. No function is needed for data with
 * numbers `x`, `y` and `r`, or for arrays `[x, y, r]`.
 *
 * @category Loading
 */
export type Accessors<Datum> = {
  readonly [Name in keyof Circle as Datum extends ArrayLike<number> | Pick<Circle, Name>
    ? never
    : Name]: Accessor<Datum>
} & { readonly [Name in keyof Circle]?: Accessor<Datum> | undefined }

/**
 * A copy of the circles as x, y, r of each. `areOptions`: whether the caller passes its options, so that errors may advise
 * to give a function.
 *
 * @throws CircleVoronoiError `badInput`. Types are checked here, because embind would convert any value. Errors of the
 *   functions are passed on.
 */
export function coordinatesOf<Datum>(
  circles: Circles | Iterable<Datum>,
  accessors?: { readonly [Name in keyof Circle]?: Accessor<Datum> | undefined },
  areOptions = accessors !== undefined,
): Float64s {
  checkMemory(circles, 'The circles', 'their array')
  const functions = accessors && [accessors.x, accessors.y, accessors.r]
  const isRead = functions?.some((find) => find !== undefined)
  if (!isRead && (circles instanceof Float64Array || circles instanceof Float32Array)) {
    if (circles.length % 3 !== 0) refuse(`Three numbers per circle are needed, but there are ${circles.length}.`)
    return new Float64Array(circles)
  }
  return coordinatesFrom(circles as Iterable<Datum>, functions, areOptions)
}

function coordinatesFrom<Datum>(
  data: Iterable<Datum>,
  functions: readonly (Accessor<Datum> | undefined)[] = [],
  areOptions: boolean,
): Float64s {
  const [fx = circleX, fy = circleY, fr = circleRadius] = functions
  if (
    typeof (data as Partial<Iterable<Datum>> | null | undefined)?.[Symbol.iterator] !== 'function' ||
    typeof data === 'string'
  ) {
    refuse(`The circles are neither a typed array nor a list, but ${shown(data)}.`)
  }
  const numbers: number[] = []
  let i = 0
  for (const datum of data) {
    const [x, y, r]: readonly unknown[] = [fx(datum, i, data), fy(datum, i, data), fr(datum, i, data)]
    if (typeof x !== 'number' || typeof y !== 'number' || typeof r !== 'number') {
      refuse(missingNumber(`Circle ${i}`, CIRCLE_NAMES, [x, y, r], datum, areOptions ? functions : undefined), i)
    }
    numbers.push(x, y, r)
    i += 1
  }
  return new Float64Array(numbers)
}

/** The names of the numbers of a circle. */
export const CIRCLE_NAMES = ['x', 'y', 'r'] as const

/** The default accessors, for objects and arrays. For other values they return `undefined`, which is refused. */
export function circleX(circle: unknown): number {
  return part(circle, 0, 'x')
}
export function circleY(circle: unknown): number {
  return part(circle, 1, 'y')
}
export function circleRadius(circle: unknown): number {
  return part(circle, 2, 'r')
}

function part(circle: unknown, k: number, name: keyof Circle): number {
  const named = (circle as Circle | null | undefined)?.[name]
  // An object with the name is not read as an array, even if it has a `length`: data may have a key `length`.
  if (named !== undefined || typeof circle !== 'object' || circle === null || !('length' in circle))
    return named as number
  return (circle as ArrayLike<number>)[k] as number
}

function refuse(message: string, circle?: number): never {
  throw new CircleVoronoiError('badInput', message, { circle })
}
