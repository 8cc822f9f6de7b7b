// SPDX-License-Identifier: GPL-3.0-or-later
// Round trips of every format, in JavaScript and through the native program, which must read and write the same bytes.
import { execFileSync } from 'node:child_process'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { loadFiles } from '../../web/lib/files.ts'
import { fromJSON } from '../../web/lib/index.ts'
import { anyCircles } from '../web/arbitrary-circles.ts'
import { library } from '../web/library.ts'

const PROGRAM = new URL('../../build/native/circle-voronoi', import.meta.url).pathname

const files = await loadFiles()

function native(args: readonly string[], input: string): string {
  return execFileSync(PROGRAM, args, { input, encoding: 'utf8', maxBuffer: 2 ** 26 })
}

/** Every finite number that a circle may have. */
const anyNumber = fc.double({ min: -7.9e28, max: 7.9e28, noNaN: true })
const anyRadius = fc.double({ min: 0, max: 7.9e28, noNaN: true })
const anyNumbers = fc
  .array(fc.tuple(anyNumber, anyNumber, anyRadius), { minLength: 1, maxLength: 20 })
  .map((list) => Float64Array.from(list.flat()))
  .filter((numbers) => isLargeEnough(numbers))

function isLargeEnough(numbers: Float64Array): boolean {
  return numbers.every((value) => value === 0) || numbers.some((value) => Math.abs(value) >= 2 ** -56)
}

type Ring = readonly string[]

/** The rings of each circle's cell. Points are text `x y`, and the first one is repeated at the end. */
const readers: Record<'geojson' | 'geojsonl' | 'wkt' | 'obj', (text: string) => Ring[][]> = {
  geojson: (text) => ringsOfFeatures(text.slice(text.indexOf('\n') + 1, text.lastIndexOf('\n]}')).split(',\n')),
  geojsonl: (text) => ringsOfFeatures(text.trimEnd().split('\n')),
  wkt: (text) =>
    text
      .trimEnd()
      .split('\n')
      .map((line) => [...line.matchAll(/\(([^()]+)\)/g)].map(([, points]) => (points as string).split(', '))),
  obj: (text) => {
    const points = ['']
    const cells: Ring[][] = []
    for (const line of text.split('\n')) {
      if (line.startsWith('v ')) points.push(line.slice(2, line.lastIndexOf(' ')))
      if (line.startsWith('g ')) cells.push([])
      if (line.startsWith('f ')) {
        const ring = line
          .slice(2)
          .split(' ')
          .map((k) => points[Number(k)] as string)
        cells.at(-1)?.push([...ring, ring[0] as string])
      }
    }
    return cells
  },
}

/** Keeps numbers as text, so that none is rounded. */
function ringsOfFeatures(features: readonly string[]): Ring[][] {
  return features.map((feature) => {
    const geometry = feature.slice(feature.indexOf('"geometry":'))
    const rings = geometry.match(/(?<=\[)(\[[^[\]]+\],?)+(?=\])/g) ?? []
    return rings.map((ring) => [...ring.matchAll(/\[([^,]+),([^\]]+)\]/g)].map(([, x, y]) => `${x} ${y}`))
  })
}

describe('circles are read as they were written', () => {
  for (const format of ['csv', 'json', 'geojson'] as const) {
    it(`as ${format}, to the bit`, () => {
      fc.assert(
        fc.property(anyNumbers, (circles) => {
          const text = files.writeCircles(circles, { format })
          expect(files.readCircles(text)).toEqual(circles)
          // Converts in the other direction and back with the native program.
          const there = native(['convert', '-', '--format', format], files.writeCircles(circles, { format: 'json' }))
          expect(there).toBe(text)
        }),
      )
    })
  }
})

describe('a diagram is read as it was written', () => {
  it('as json, to the bit', () => {
    fc.assert(
      fc.property(anyCircles, (circles) => {
        const diagram = library.compute(circles)
        const text = files.writeDiagram(diagram)
        expect({ ...files.readDiagram(text) }).toEqual({ ...diagram })
        expect({ ...fromJSON(text), certificate: diagram.certificate }).toEqual({ ...diagram })
        expect(native(['convert', '-', '--format', 'json'], text)).toBe(text)
      }),
      { numRuns: 50 },
    )
  })

  it('as csv, its vertices and edges, to the bit', () => {
    fc.assert(
      fc.property(anyCircles, (circles) => {
        const diagram = library.compute(circles)
        const rows = files
          .writeDiagram(diagram, { format: 'csv' })
          .trimEnd()
          .split('\n')
          .slice(1)
          .map((line) => line.split(','))
        const numbersOf = (type: string, columns: readonly number[]) =>
          rows.filter(([first]) => first === type).flatMap((row) => columns.map((k) => Number(row[k])))
        expect(numbersOf('vertex', [2, 3, 4])).toEqual([...diagram.vertices])
        expect(numbersOf('vertex', [5, 6, 7])).toEqual([...diagram.vertexCircles])
        expect(numbersOf('edge', [5, 6, 8, 9])).toEqual([...diagram.edges])
      }),
    )
  })
})

it('what is drawn has the same points in each format, and the same bytes from the native program', () => {
  const maxDistance = fc.option(fc.double({ min: 0.01, max: 30, noNaN: true }), { nil: undefined })
  const tolerance = fc.option(fc.double({ min: 1e-3, max: 1, noNaN: true }), { nil: undefined })
  const digits = fc.option(fc.integer({ min: 0, max: 9 }), { nil: undefined })
  fc.assert(
    fc.property(anyCircles, maxDistance, tolerance, digits, (circles, maxDistance, tolerance, digits) => {
      const diagram = library.compute(circles)
      const options = { maxDistance, tolerance, digits }
      const args = [
        ...(maxDistance === undefined ? [] : ['--max-distance', `${maxDistance}`]),
        ...(tolerance === undefined ? [] : ['--tolerance', `${tolerance}`]),
        ...(digits === undefined ? [] : ['--digits', `${digits}`]),
      ]
      const json = files.writeDiagram(diagram)
      const rings = Object.entries(readers).map(([format, read]) => {
        const text = files.writeDiagram(diagram, { ...options, format: format as keyof typeof readers })
        expect(native(['convert', '-', '--format', format, ...args], json)).toBe(text)
        return read(text)
      })
      for (const other of rings) expect(other).toEqual(rings[0])
      expect(rings[0]).toHaveLength(circles.length / 3)
      expect(rings[0]?.flat(2).length).toBeGreaterThan(3)
      const drawing = files.writeDiagram(diagram, { ...options, format: 'svg' })
      expect(native(['convert', '-', '--format', 'svg', ...args], json)).toBe(drawing)
    }),
    { numRuns: 40 },
  )
})
