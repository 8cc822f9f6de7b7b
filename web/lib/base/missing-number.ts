// SPDX-License-Identifier: GPL-3.0-or-later
import { isRecord, listed, shown } from './check.ts'

/**
 * Returns a sentence about the first of several values that is not a number: what was found in its place, and what helps.
 *
 * @param thing the name of the datum, which begins the sentence
 * @param functions the function that the caller gave for each value; `undefined` where none can be given
 */
export function missingNumber(
  thing: string,
  names: readonly string[],
  values: readonly unknown[],
  datum: unknown,
  functions?: readonly unknown[],
): string {
  const k = values.findIndex((value) => typeof value !== 'number')
  const [name, value] = [names[k] as string, values[k]]
  if (functions?.[k] !== undefined) return `${thing}: the function ${name} returned ${shown(value)}, not a number.`
  const help = (found: string) => (functions === undefined ? '' : ` Pass a function: { ${name}: ${found} }.`)
  if (typeof datum !== 'object' || datum === null) {
    return `${thing} is ${shown(datum)}, not an object or an array with ${listed(names)}.`
  }
  if (value !== undefined) {
    const place = name in datum ? `d.${name}` : `d[${k}]`
    const isConvertible = (typeof value === 'string' || value instanceof Date) && Number.isFinite(Number(value))
    const advice = isConvertible ? help(`(d) => Number(${place})`) : ''
    return `${thing}: ${name} is ${shown(value)}, not a number.${advice}`
  }
  if (!isRecord(datum)) {
    const { length } = datum as ArrayLike<unknown>
    const advice = length === names.length - 1 ? help('() => 0') : ''
    return `${thing}: ${name} is missing, because the array has ${length} items.${advice}`
  }
  const others = Object.keys(datum).filter((key) => !names.includes(key))
  const numbers = others.filter((key) => typeof datum[key] === 'number')
  const advice = numbers.length === 1 ? help(`(d) => d.${numbers[0]}`) : ''
  const found = others.length === 0 ? '' : `; other names are ${listed(others.slice(0, MOST_NAMES))}`
  return `${thing}: ${name} is missing${found}.${advice}`
}

/** The largest number of names that a sentence lists. */
const MOST_NAMES = 8
