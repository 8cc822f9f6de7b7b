// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { CircleVoronoiError } from '../../web/lib/index.ts'
import { library } from './library.ts'

const { compute, edit } = library

type Compute = (data: unknown, options?: object) => { readonly circles: Float64Array }

/** The error about data that are not circles. */
function problem(act: () => unknown): CircleVoronoiError {
  try {
    act()
  } catch (error) {
    expect(error).toBeInstanceOf(CircleVoronoiError)
    return error as CircleVoronoiError
  }
  throw new Error('There is no error.')
}

/** Computes with the option that the message advises. */
function advised(data: unknown, { message }: CircleVoronoiError): number[] {
  const [, advice] = /Pass a function: (\{.*\})\.$/.exec(message) ?? []
  expect(advice, message).toBeDefined()
  return [...(compute as unknown as Compute)(data, new Function(`return ${advice}`)()).circles]
}

const DATA: readonly (readonly [what: string, datum: unknown, found: string, circle: readonly number[]])[] = [
  ['a radius of another name', { x: 1, y: 2, radius: 3, name: 'A' }, 'radius', [1, 2, 3]],
  ['a radius as text', { x: 1, y: 2, r: '3.5' }, '"3.5"', [1, 2, 3.5]],
  ['a date', { x: new Date(86_400_000), y: 2, r: 3 }, 'Date', [86_400_000, 2, 3]],
  ['a text in an array', [1, '2', 3], '"2"', [1, 2, 3]],
  ['a point', [1, 2], '2 items', [1, 2, 0]],
]

describe('the error about a missing number', () => {
  it.each(DATA)('names %s, and its advice works', (_, datum, found, circle) => {
    const data = [[0, 0, 0], datum]
    // The first datum has another form, which the advice is not about.
    const error = problem(() => (compute as unknown as Compute)(data))
    expect(error).toMatchObject({ code: 'badInput', circle: 1 })
    expect(error.message).toContain(found)
    expect(advised([datum], error)).toEqual(circle)
  })

  it('lists the names that there are if it is not clear which one is meant', () => {
    const { message } = problem(() => (compute as unknown as Compute)([{ lat: 47, lon: 8, size: 3 }]))
    for (const name of ['x', 'lat', 'lon', 'size']) expect(message).toMatch(new RegExp(`\\b${name}\\b`))
    expect(message).not.toContain('=>')
  })

  it.each([null, undefined, 5, 'x', Symbol.iterator])('shows %s in place of a circle', (datum) => {
    expect(problem(() => (compute as unknown as Compute)([datum])).message).toContain(String(datum))
  })

  it('shows what a function returned', () => {
    const options = { x: () => 1, y: () => 2, r: ({ size }: { size: unknown }) => size }
    const { message } = problem(() => (compute as unknown as Compute)([{ size: '7' }], options))
    expect(message).toContain('"7"')
    expect(message).not.toContain('=>')
  })

  it('advises no function where none can be given', () => {
    const editor = edit([[0, 0, 1]])
    const { message } = problem(() => editor.insert({ x: 1, y: 2, radius: 3 } as never))
    expect(message).toContain('radius')
    expect(message).not.toContain('=>')
  })
})
