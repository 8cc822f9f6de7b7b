// SPDX-License-Identifier: GPL-3.0-or-later
// Each value that a page may give is used as intended or refused in one sentence.
import { describe, expect, it } from 'vitest'
import { checkedAreas } from '../../web/element/attributes.ts'
import { checkedLayers, checkLayers, DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { SvgDrawing } from '../../web/view/painter/svg-drawing.ts'
import { shownValue } from '../../web/view/refusal.ts'
import { readRegion } from '../../web/view/region-text.ts'
import { untyped } from './errors.ts'
import { library } from './library.ts'

describe('circles of data', () => {
  it('may have a key length', () => {
    const rivers = [
      { x: 0, y: 0, r: 1, length: 12 },
      { x: 6, y: 0, r: 1, length: 3 },
    ]
    expect(library.compute(rivers).circles).toEqual(Float64Array.of(0, 0, 1, 6, 0, 1))
  })
})

describe('layers of data', () => {
  const layer = { id: 'a', color: 'red', points: Float64Array.of(1, 2) }

  it('have an id, a color and numbers', () => {
    expect(checkedLayers({ data: [layer] }).data).toEqual([layer])
    expect(checkedLayers({ data: [{ ...layer, points: untyped([1, 2]) }] }).data).toEqual([layer])
    const wrong = [
      { ...layer, color: undefined },
      { ...layer, color: 7 },
      { ...layer, id: {} },
      { ...layer, points: [1n, 2n] },
      { ...layer, discs: BigInt64Array.of(1n) },
      { ...layer, segments: new DataView(new ArrayBuffer(8)) },
      { ...layer, segments: ['1'] },
    ]
    for (const data of wrong) {
      expect(() => checkedLayers({ data: untyped([data]) }), shownValue(data)).toThrow(/data/)
      expect(() => checkLayers({ ...DEFAULT_LAYERS, data: untyped([data]) })).toThrow(/data/)
    }
  })

  it('are copies, without anything that no thread takes', () => {
    const { data } = checkedLayers({ data: untyped([{ ...layer, act: () => 0 }]) })
    expect(data).toEqual([layer])
    expect(data[0]?.points).not.toBe(layer.points)
    const column = { name: 'n', values: Float64Array.of(1), categories: ['A'] }
    const checked = checkedLayers({ column })
    column.values[0] = 2
    column.categories[0] = 'B'
    expect(checked.column).toEqual({ name: 'n', values: Float64Array.of(1), categories: ['A'] })
    expect(Object.isFrozen(DEFAULT_LAYERS) && Object.isFrozen(DEFAULT_LAYERS.data)).toBe(true)
  })

  it('refuse integers of any size with a sentence', () => {
    for (const given of [
      { nearZero: 1n },
      { maxDistance: 1n },
      { sampleCount: 1n },
      { path: { from: { x: 1n, y: 0 } } },
    ]) {
      expect(() => checkedLayers(untyped(given))).toThrow(expect.objectContaining({ name: 'CircleVoronoiError' }))
    }
  })
})

it('areas of an element are those that were set, whatever becomes of the list', () => {
  const areas = [1, 2]
  const checked = checkedAreas(areas)
  areas[0] = 9
  expect(checked).toEqual([1, 2])
})

it('any value can stand in a sentence', () => {
  const circular: Record<string, unknown> = {}
  circular.self = circular
  expect(shownValue(circular)).toBe('[object Object]')
  expect(shownValue(1n)).toBe('"1n"')
  expect(shownValue({ a: [2n] })).toBe('{"a":["2n"]}')
  expect(shownValue(undefined)).toBe('undefined')
  expect(shownValue(Symbol('a'))).toBe('symbol')
  expect(shownValue('x'.repeat(38))).toBe(`"${'x'.repeat(38)}"`)
  expect(shownValue('x'.repeat(39))).toBe(`"${'x'.repeat(39)}…`)
  expect(
    shownValue({
      toJSON() {
        throw new Error()
      },
    }),
  ).toBe('[object Object]')
})

it('no color and no text is markup in a drawing', () => {
  const drawing = new SvgDrawing()
  const path = drawing.path()
  path.moveTo(0, 0)
  path.lineTo(1, 1)
  const evil = `"/><script>alert('1')</script><a b="&`
  drawing.cover(evil)
  drawing.fill(path, evil)
  drawing.stroke(path, evil, 1)
  drawing.write('<b>&', 0, 0, 9, evil, evil)
  const text = String(drawing)
  expect(text).not.toMatch(/<script|<a |<b>/)
  expect(text.match(/</g)).toHaveLength(5)
  expect(text).toContain('&quot;/&#62;&#60;script&#62;')
})

it('a region with much white space at its end is read at once', () => {
  const square = 'POLYGON ((0 0, 9 0, 9 9, 0 9))'
  const spaces = ' '.repeat(200_000)
  // A quadratic algorithm would take minutes here.
  expect(readRegion(`${spaces}SRID=4326; ${square}${spaces};${spaces}`)).toEqual(readRegion(square))
  expect(() => readRegion(`${square}${spaces}x`)).toThrow(/POLYGON/)
  expect(() => readRegion(`POLYGON ${'('.repeat(100_000)}${spaces}`)).toThrow(/POLYGON/)
})
