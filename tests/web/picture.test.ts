import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { loadCircleVoronoi } from '../../web/lib/index.ts'
import { encodeLink } from '../../web/lib/link.ts'
import { picture, USAGE } from '../../web/picture/command.ts'
import { renderSVG } from '../../web/picture/render.ts'
import { playerColors, themeStyle } from '../../web/picture/theme.ts'
import { stepsOf } from '../../web/player/steps.ts'

const CIRCLES = [
  [0, 0, 2],
  [10, 0, 1],
  [5, 8, 1.5],
]
let said: { out: string; error: string }
beforeEach(() => {
  const hear = (stream: NodeJS.WriteStream, name: keyof typeof said) =>
    vi.spyOn(stream, 'write').mockImplementation((text) => {
      said[name] += text
      return true
    })
  hear(process.stdout, 'out')
  hear(process.stderr, 'error')
})
afterEach(() => {
  vi.restoreAllMocks()
})

const run = async (...args: string[]) => {
  said = { out: '', error: '' }
  return [await picture(args, 'program'), said.out, said.error]
}
const STATE = { circles: CIRCLES }

it('is written in the size and the colors that are asked for', async () => {
  const link = await encodeLink(STATE)
  expect(await run(link)).toEqual([0, await renderSVG(STATE), ''])
  expect(await run(link, '--size', '300x200', '--dark')).toEqual([
    0,
    await renderSVG(STATE, { width: 300, height: 200, scheme: 'dark' }),
    '',
  ])
  expect(await renderSVG(STATE)).toMatch(/^<svg[^>]* width="720" height="480"/)
  expect(await renderSVG(STATE, { scheme: 'dark' })).not.toBe(await renderSVG(STATE))
  for (const help of ['-h', '--help']) expect(await run(help)).toEqual([0, USAGE, ''])
})

it.each([
  ['width', 1, 100_000],
  ['height', 1, 100_000],
] as const)('has a %s from %d to %d', async (name, least, most) => {
  for (const side of [least, most]) expect(await renderSVG(STATE, { [name]: side })).toContain(`${name}="${side}"`)
  for (const side of [least - 0.5, most + 1, Number.NaN, '9'])
    await expect(renderSVG(STATE, { [name]: side })).rejects.toThrow(`The option ${name} is a number from`)
})

it('shows the diagram at the last step and beyond, and says what is wrong with its domain', async () => {
  const [whole, first, beyond] = [
    await renderSVG(STATE),
    ...(await Promise.all([0, 1e5].map((step) => renderSVG({ ...STATE, step })))),
  ]
  expect([first === whole, beyond === whole]).toEqual([false, true])
  const steps = await Promise.all(Array.from({ length: 60 }, (_, step) => renderSVG({ ...STATE, step })))
  // The method has steps, and only the last one shows the diagram.
  const last = steps.indexOf(whole)
  expect(last).toBeGreaterThan(9)
  expect(steps.slice(last).every((svg) => svg === whole)).toBe(true)
  expect(stepsOf((await loadCircleVoronoi()).trace(CIRCLES))).toHaveLength(last + 1)
  await expect(renderSVG({ ...STATE, areas: 'equal' })).rejects.toMatchObject({ code: 'badInput' })
})

it('has all colors of the style sheets, others in the dark than in the light', () => {
  for (const colorsOf of [themeStyle, playerColors] as ((scheme: 'light' | 'dark') => object)[]) {
    const [light, dark] = (['light', 'dark'] as const).map((scheme) => Object.values(colorsOf(scheme)).flat())
    for (const color of [...(light ?? []), ...(dark ?? [])])
      expect(String(color)).toMatch(/^rgba?\([\d., ]+\)$|^[\d.]+$/)
    expect(light).not.toEqual(dark)
    expect(light?.length).toBe(dark?.length)
  }
})

it('has a title, and the names of circles as titles of their cells', async () => {
  const titlesIn = (svg: string) => Array.from(svg.matchAll(/<title>([^<]*)<\/title>/g), ([, title]) => title)
  const plain = await renderSVG(STATE)
  expect(plain).toMatch(/^<svg [^>]*role="img"[^>]*>\n<title>Voronoi diagram of 3 circles<\/title>/)
  expect(titlesIn(plain)).toHaveLength(1)
  // The last circle is hidden, and the first one has no name.
  const circles = [...CIRCLES, [0.5, 0, 1]]
  const named = await renderSVG({ circles, names: ['', 'A & <B>', 'C', 'D'] })
  expect(titlesIn(named)).toEqual(['Voronoi diagram of 4 circles', 'A &#38; &#60;B&#62;', 'C'])
  const steps = { circles, names: ['', 'A', 'C', 'D'], step: 3 }
  expect(titlesIn(await renderSVG(steps))).toHaveLength(1)
})

it.each([
  'rebeccapurple',
  'rgb(1, 2, 3)',
  'rgb(10% 20% 30% / 0.5)',
  'rgba(1, 2, 3, 0.5)',
  'hsl(120deg 30% 40%)',
  'hwb(90 10% 10%)',
  '#aBcd',
  'oklch(60% 0.15 50)',
  'color-mix(in srgb, red, blue)',
])('has circles in the CSS color %s', async (color) => {
  const properties = [color, 'no color', 'rgb(1 2)'].map((text) => JSON.stringify({ color: text }))
  const attributes = { properties, ids: ['', '', ''], heights: ['', '', ''], collection: '' }
  const svg = await renderSVG({ circles: CIRCLES, attributes })
  expect(svg).toContain(`="${color}"`)
  expect(svg).not.toContain('no color')
  expect(svg).not.toContain('rgb(1 2)')
})
