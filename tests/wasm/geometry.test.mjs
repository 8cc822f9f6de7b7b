// SPDX-License-Identifier: GPL-3.0-or-later
// The geometry in TypeScript against that of the native program, on every fixture: areas and neighbours of cells from its
// GeoJSON, curves of edges and cells, hull and dual from its SVG; and of some at extreme scales.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { after, describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import {
  area,
  clip,
  cubicBeziers,
  edgeCurve,
  exportBox,
  hull,
  loadCircleVoronoi,
  neighborPairs,
  outline,
  polyline,
} from '../../dist/lib/index.js'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const NATIVE = `${ROOT}build/native/circle-voronoi`
const LARGEST_OUTPUT = 2 ** 28

const library = await loadCircleVoronoi()
const fixtures = readdirSync(`${ROOT}tests/fixtures`)
  .filter((name) => name.endsWith('.csv'))
  .map((name) => ({ name, file: `${ROOT}tests/fixtures/${name}` }))

const folder = mkdtempSync(`${tmpdir()}/circle-voronoi-`)
after(() => rmSync(folder, { recursive: true }))
/** The circles of a fixture, 2^exponent times as large. */
const scaled = ['waka.csv', 'missed-antipodal-disc-mixed-6.csv'].flatMap((fixture) =>
  [-900, -400, 400].map((exponent) => {
    const name = `2^${exponent} times ${fixture}`
    const file = `${folder}/${exponent}-${fixture}`
    const rows = JSON.parse(native(`${ROOT}tests/fixtures/${fixture}`, 'json')).circles.map((circle) =>
      Object.values(circle).map((value) => value * 2 ** exponent),
    )
    writeFileSync(file, rows.map((row) => `${row.join(',')}\n`).join(''))
    return { name, file }
  }),
)

for (const { name, file } of [...fixtures, ...scaled]) {
  describe(name, () => {
    const circles = JSON.parse(native(file, 'json')).circles
    const diagram = library.compute(circles)
    const box = exportBox(diagram.circles)
    const size = Math.max(box.maxX - box.minX, box.maxY - box.minY)
    const near = (one, other, tolerance, message) =>
      assert.ok(Math.abs(one - other) <= tolerance, `${message}: ${one} and ${other}`)

    it('has the cells of the GeoJSON', () => {
      const { features } = JSON.parse(native(file, 'geojson'))
      assert.equal(features.length, circles.length)
      for (const { properties, geometry } of features) {
        const i = properties.circle
        const parts = outline(diagram, i, box)
        assert.deepEqual([...diagram.neighbors(i)], properties.neighbors)
        near(area(parts), properties.area, 1e-13 * size * size, `area of cell ${i}`)
        // A cell that rounding leaves no area has no polygon.
        assert.ok(geometry === null ? area(parts) <= 1e-12 * size * size : parts.length > 0)
      }
    })

    it('has the curves of the SVG', () => {
      const paths = elements(native(file, 'svg'), 'edges', 'path')
      // Drawings are rounded, which their tolerance allows for.
      const powers = Array.from({ length: 45 }, (_, k) => Number(`1e${k - 22}`))
      const step = powers.findLast((power) => power <= 1e-6 * size) ?? 0
      const tolerance = 1e-5 * size - step
      const drawn = new Map(paths.map((path) => [Number(path['data-edge']), numbersOf(path.d)]))
      for (let e = 0; e < diagram.edges.length / 4; e++) {
        const pieces = clip(edgeCurve(diagram, e), box)
        const numbers = pieces.flatMap((piece) => {
          const { start, end, bisector } = piece
          if (bisector.a === 0 || polyline(piece, tolerance).length === 2) return [start.x, start.y, end.x, end.y]
          const cubics = cubicBeziers(piece, tolerance)
          return [start, ...cubics.flatMap(({ control1, control2, end: last }) => [control1, control2, last])].flatMap(
            ({ x, y }) => [x, y],
          )
        })
        const expected = drawn.get(e) ?? []
        assert.equal(numbers.length, expected.length, `edge ${e}`)
        numbers.forEach((number, k) => {
          near(number, expected[k], step + 1e-12 * size, `number ${k} of edge ${e}`)
        })
      }
    })

    it('has the hull and the dual of the SVG', () => {
      const svg = native(file, 'svg')
      assert.equal(elements(svg, 'dual', 'line').length, neighborPairs(diagram).length / 2)
      const [path] = elements(svg, 'hull', 'path')
      const { arcs } = hull(diagram)
      const points = arcs.flatMap(({ start, end }) => [start.x, start.y, end.x, end.y])
      // Of each arc: where it begins, two radii, three flags, where it ends.
      const expected = path === undefined ? [] : numbersOf(path.d).filter((_, k) => k % 9 < 2 || k % 9 > 6)
      assert.equal(arcs.length > 1 ? points.length : 0, expected.length)
      expected.forEach((number, k) => {
        near(points[k], number, 1e-12 * size, `number ${k} of the hull`)
      })
    })
  })
}

function native(file, format) {
  const args = ['compute', file, '--format', format]
  return execFileSync(NATIVE, args, { maxBuffer: LARGEST_OUTPUT, encoding: 'utf8' })
}

/** The attributes of the elements of one name in a group of the SVG. */
function elements(svg, group, name) {
  const [, content] = svg.match(new RegExp(`<g id="${group}"[^>]*>\n([^]*?)</g>`))
  return [...content.matchAll(new RegExp(`<${name} ([^>]*)/>`, 'g'))].map(([, attributes]) =>
    Object.fromEntries([...attributes.matchAll(/([\w-]+)="([^"]*)"/g)].map(([, key, value]) => [key, value])),
  )
}

function numbersOf(d) {
  return [...d.matchAll(/-?[\d.]+(e[+-]?\d+)?/g)].map(([text]) => Number(text))
}
