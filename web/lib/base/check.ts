// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of arguments whose types JavaScript does not enforce. An invalid argument throws an error of one sentence.

import { REGION_LIMIT, REGION_LIMIT_TEXT } from './coordinate-limits.ts'
import { CircleVoronoiError } from './errors.ts'
import type { DiagramData, Metric, Point } from './types.ts'

const DIAGRAM_ARRAYS = [
  'circles',
  'vertices',
  'vertexCircles',
  'edges',
  'hidden',
  'hull',
  'nextSide',
  'vertexSides',
  'firstSide',
] as const

/** @throws CircleVoronoiError `badInput` */
export function refuseInput(message: string): never {
  throw new CircleVoronoiError('badInput', message)
}

/** @throws CircleVoronoiError `badOption` */
export function refuseOption(message: string): never {
  throw new CircleVoronoiError('badOption', message)
}

/**
 * Whether `options` is an object that has only the options in `known`. Options that are `undefined` are ignored.
 *
 * @throws CircleVoronoiError `badOption`
 */
export function checkOptionNames(options: unknown, caller: string, known: readonly string[]): void {
  if (typeof options !== 'object' || options === null || Array.isArray(options)) {
    refuseOption(`The options of ${caller} are not an object.`)
  }
  for (const name of Object.keys(options)) {
    if (!known.includes(name) && (options as Record<string, unknown>)[name] !== undefined) {
      refuseOption(
        `There is no option ${name} of ${caller}; ${known.length === 1 ? 'its only one is' : 'its options are'} ${listed(known)}.`,
      )
    }
  }
}

/**
 * Refuses options of a function that has no options. Further arguments are allowed, because `map` passes them to a
 * callback.
 *
 * @throws CircleVoronoiError `badOption`
 */
export function checkNoOptions([options]: readonly unknown[], caller: string): void {
  if (!isRecord(options)) return
  const [name] = Object.keys(options).filter((name) => options[name] !== undefined)
  if (name !== undefined) refuseOption(`There is no option ${name} of ${caller}, which has none.`)
}

/** @throws CircleVoronoiError `badInput`, if `value` is not a number */
export function checkNumber(value: unknown, caller: string, name: string): void {
  if (typeof value !== 'number') refuseInput(`${caller} takes a number as ${name}, not ${shown(value)}.`)
}

/** @throws CircleVoronoiError `badInput`, if `length` is not a number, or is NaN */
export function checkLength(length: unknown, caller: string, name: string): void {
  if (Number.isNaN(length)) refuseInput(`${caller} takes a number as ${name}, not NaN.`)
  checkNumber(length, caller, name)
}

/** @throws CircleVoronoiError `badInput`, if `value` is not a finite number above 0 */
export function checkAbove0(value: unknown, caller: string, name: string): void {
  if (!(Number.isFinite(value) && (value as number) > 0)) {
    refuseInput(`${caller} takes a finite number above 0 as ${name}, not ${shown(value)}.`)
  }
}

/** @throws CircleVoronoiError `badInput`, if `index` is not one of `count` things */
export function checkIndex(index: unknown, count: number, caller: string, thing: string): void {
  checkNumber(index, caller, `the index of ${thing === 'edge' ? 'an' : 'a'} ${thing}`)
  if (!Number.isInteger(index) || (index as number) < 0 || (index as number) >= count) {
    refuseInput(`${caller}: there is no ${thing} ${index}; the diagram has ${count}.`)
  }
}

/** @throws CircleVoronoiError `badInput`, if `diagram` is not a `Diagram` with methods */
export function checkDiagram(diagram: unknown, caller: string): void {
  if (typeof (diagram as { find?: unknown } | null | undefined)?.find !== 'function') {
    refuseInput(`${caller} takes a Diagram, not ${shown(diagram)}; new Diagram(data) makes one of plain data.`)
  }
  checkData(diagram, caller)
}

/** @throws CircleVoronoiError `badInput`, if `value` has no property `part`, which every `thing` has */
export function checkThing(value: unknown, part: string, caller: string, thing: string): void {
  if (typeof value !== 'object' || value === null || !(part in value)) {
    refuseInput(`${caller} takes ${thing}, not ${shown(value)}.`)
  }
}

/** @throws CircleVoronoiError `badInput`, if `data` is not a diagram, or an array of it has lost its memory */
export function checkData(data: unknown, caller: string): void {
  checkThing(data, 'vertexCircles', caller, 'a diagram')
  for (const array of DIAGRAM_ARRAYS) checkMemory((data as DiagramData)[array], caller, array)
}

/**
 * Refuses an array that has lost its memory: its buffer was transferred, or has become too short. Such an array reads
 * as empty.
 *
 * @throws CircleVoronoiError `badInput`
 */
export function checkMemory(array: unknown, caller: string, name: string): void {
  if (!isTypedArray(array) || array.length > 0) return
  try {
    array.keys()
  } catch (cause) {
    throw new CircleVoronoiError('badInput', `${caller}: the buffer of ${name} was transferred or resized.`, { cause })
  }
}

/** Whether a value is a typed array of any type. */
export function isTypedArray(value: unknown): value is Float64Array {
  return ArrayBuffer.isView(value) && !(value instanceof DataView)
}

/**
 * @throws CircleVoronoiError `badInput`: a program has changed the arrays, so that a walk would leave them or never end
 */
export function refuseArrays(thing: string, index: number): never {
  const message = `The arrays of the diagram do not fit together at ${thing} ${index}. They must not be changed.`
  throw new CircleVoronoiError('badInput', message)
}

/** @throws CircleVoronoiError `nonFinite`: a coordinate is not finite */
export function refuseInfinite(circles: Float64Array): never {
  const circle = Math.floor(circles.findIndex((value) => !Number.isFinite(value)) / 3)
  throw new CircleVoronoiError('nonFinite', `Circle ${circle} has a coordinate that is not a finite number.`, {
    circle,
  })
}

/** @throws CircleVoronoiError `badInput`, if `circles` is not one array with x, y and r of each circle */
export function checkCircles(circles: unknown, caller: string): void {
  if (!(circles instanceof Float64Array)) {
    refuseInput(`${caller} takes a Float64Array of x, y and r for each circle, not ${shown(circles)}.`)
  }
  checkMemory(circles, caller, 'circles')
  if (circles.length % 3 !== 0) {
    refuseInput(`${caller} takes three numbers for each circle, but there are ${circles.length}.`)
  }
}

/** @throws CircleVoronoiError `badInput`, if `curve` does not have two ends */
export function checkBoundedCurve(curve: unknown, caller: string): void {
  checkThing(curve, 'bisector', caller, 'a curve')
  const { start, end } = curve as { start?: unknown; end?: unknown }
  if (start === undefined || end === undefined) {
    refuseInput(`${caller} takes a curve with two ends; clipCurve makes some of one that goes to infinity.`)
  }
}

/** @throws CircleVoronoiError `badInput`, if `outline` is not a list of loops */
export function checkOutline(outline: unknown, caller: string): void {
  if (!(Array.isArray(outline) && outline.every(Array.isArray))) {
    refuseInput(`${caller} takes an outline, a list of closed loops, not ${shown(outline)}.`)
  }
}

/** @throws CircleVoronoiError `badInput`, if `point` is not a finite point */
export function checkPoint(point: unknown, caller: string): asserts point is Point {
  const { x, y }: Partial<Point> = Object(point)
  if (!Number.isFinite(x) || !Number.isFinite(y)) {
    refuseInput(`${caller} takes points { x, y } of finite numbers, not ${shown(point)}.`)
  }
}

/** @throws CircleVoronoiError `badInput`, if a function does not support the metric of a diagram */
export function checkMetric(
  { metric }: Pick<DiagramData, 'metric'>,
  caller: string,
  ...known: readonly Metric[]
): void {
  if (!known.includes(metric)) {
    refuseInput(`${caller} takes a diagram of the metric ${listed(known)}, not of ${metric}.`)
  }
}

/** @throws CircleVoronoiError `badOption`, if `distance` is given and is not a number, or exceeds `REGION_LIMIT` */
export function checkMaxDistance(distance: unknown): void {
  if (distance === undefined) return
  if (typeof distance !== 'number' || !(Math.abs(distance) <= REGION_LIMIT)) {
    refuseOption(`The maximum distance is a number up to ${REGION_LIMIT_TEXT}, not ${shown(distance)}.`)
  }
}

/** @throws CircleVoronoiError `badOption`, if `tolerance` is not finite and above 0 */
export function checkTolerance(tolerance: unknown): asserts tolerance is number {
  if (!(Number.isFinite(tolerance) && (tolerance as number) > 0)) {
    refuseOption(`The tolerance is a finite number above 0, not ${shown(tolerance)}.`)
  }
}

/** @throws CircleVoronoiError `badOption`, if `digits` is given and is not a number of digits */
export function checkDigits(digits: unknown): void {
  if (digits !== undefined && !(Number.isInteger(digits) && (digits as number) >= 0)) {
    refuseOption(`The number of digits is a whole number from 0, not ${shown(digits)}.`)
  }
}

/** Whether a value is an object with named members, like an object in JSON. */
export function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value)
}

/** Returns a value as text for an error message. */
export function shown(value: unknown): string {
  if (typeof value === 'string') return JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}…` : value)
  if (Array.isArray(value)) return 'an array'
  if (typeof value === 'function') return 'a function'
  if (value instanceof Date) return 'a Date'
  return typeof value === 'object' && value !== null ? 'an object' : String(value)
}

/** Returns names as a list in a sentence. */
export function listed(names: readonly string[]): string {
  return names.length < 2 ? names.join() : `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`
}
