// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it } from 'vitest'
import { circlesOfSvg, tableOfSvg, withLink, withTable } from '../../web/app/files/svg-scene.ts'
import { loadFiles } from '../../web/lib/files.ts'
import { library } from './library.ts'

const CIRCLES = `<circle data-circle="0" cx="0" cy="0" r="2"/>
<circle data-circle="1" class="hidden" cx="0.5" cy="0" r="1"/>
<circle data-circle="2" class="point" cx="9" cy="-1" r="0"/>
`

for (const [name, group] of [
  ['with styles as attributes', '<g class="circles" fill="#d9822b" stroke="#a85a10">'],
  ['with ids, as older ones', '<g id="circles" class="circles">'],
] as const) {
  it(`circles of a drawing of the program: ${name}`, () => {
    const read = circlesOfSvg(`<svg>\n<g class="cells">\n</g>\n${group}\n${CIRCLES}</g>\n</svg>`, 'a.svg')
    expect(read).toEqual({ circles: Float64Array.of(0, 0, 2, 0.5, 0, 1, 9, -1, 0) })
  })
}

it('a periodic drawing, whose lattice is not in it, is refused', () => {
  const text = `<svg>\n<defs>\n<g id="given-12">\n<g class="circles" fill="#d9822b">\n${CIRCLES}</g>\n</g>\n</defs>\n</svg>`
  expect(() => circlesOfSvg(text, 'a.svg')).toThrow(expect.objectContaining({ code: 'badInput' }))
})

it('a drawing without one of its circles is refused', () => {
  const lines = CIRCLES.split('\n')
  for (const others of [lines.toSpliced(1, 1), lines.toSpliced(0, 1)]) {
    const text = `<svg>\n<g class="circles">\n${others.join('\n')}</g>\n</svg>`
    expect(() => circlesOfSvg(text, 'a.svg')).toThrow(expect.objectContaining({ code: 'badInput' }))
  }
})

it('a drawing has its link or its table back, whatever they contain', () => {
  const svg = '<svg xmlns="http://www.w3.org/2000/svg">\n<g/>\n</svg>\n'
  expect(circlesOfSvg(withLink(svg, 'v1.a-b_c'), 'a.svg')).toEqual({ link: 'v1.a-b_c' })
  const csv = 'x,y,r,name\n1,2,3,"$&$\'<a>&#38; &amp; b"\n'
  const drawing = withTable(svg, csv)
  expect(tableOfSvg(drawing)).toBe(csv)
  expect(drawing).not.toMatch(/<a>|&(?!#\d+;|quot;)/)
  expect([tableOfSvg(svg), tableOfSvg(withLink(svg, 'v1.a'))]).toEqual([undefined, undefined])
})

it('are circles in a drawing of the program, also with names', async () => {
  const circles = Float64Array.of(0, 0, 2, 10, 0, 1)
  const { writeDiagram } = await loadFiles()
  const properties = ['{"name":"A > <g>"}', '{}']
  const attributes = { properties, ids: [], heights: [], collection: '' }
  const text = writeDiagram(library.compute(circles), { format: 'svg', attributes })
  expect(text).toContain('</title></circle>')
  expect(circlesOfSvg(text, 'a.svg')).toEqual({ circles })
})
