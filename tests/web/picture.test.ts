// SPDX-License-Identifier: GPL-3.0-or-later
// The command that draws pictures: its options, its files, and the colors and limits of `renderSVG`.
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { loadCircleVoronoi } from '../../web/lib/index.ts'
import { encodeLink } from '../../web/lib/link.ts'
import { picture, USAGE } from '../../web/picture/command.ts'
import { renderSVG } from '../../web/picture/render.ts'
import { playerColors, themeStyle } from '../../web/picture/theme.ts'
import { stepsOf } from '../../web/player/steps.ts'

const { sheets, converted } = await vi.hoisted(async () => {
  const { readFileSync } = await import('node:fs')
  const read = (path: string) => readFileSync(new URL(`../../web/${path}`, import.meta.url), 'utf8')
  return {
    sheets: { theme: read('view/theme.css'), player: read('player/player.css') },
    converted: [] as unknown[][],
  }
})
vi.mock('../../web/view/theme.css?inline', () => ({ default: sheets.theme }))
vi.mock('../../web/player/player.css?inline', () => ({ default: sheets.player }))
vi.mock('../../web/picture/converters.ts', async (original) => ({
  ...(await original<object>()),
  convert: (...args: unknown[]) => {
    converted.push(args)
    writeFileSync(args[2] as string, 'made')
    if (failure !== undefined) throw failure
    return isInstalled
  },
}))

const CIRCLES = [
  [0, 0, 2],
  [10, 0, 1],
  [5, 8, 1.5],
]
let folder: string
let link: string
let said: { out: string; error: string }
let isInstalled: boolean
let failure: Error | undefined
beforeEach(async () => {
  folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-'))
  link = await encodeLink({ circles: CIRCLES })
  said = { out: '', error: '' }
  isInstalled = true
  failure = undefined
  converted.length = 0
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
  rmSync(folder, { recursive: true })
})

const run = async (...args: string[]) => {
  said = { out: '', error: '' }
  return [await picture(args, 'program'), said.out, said.error]
}
const STATE = { circles: CIRCLES }

it('is written in the size and the colors that are asked for', async () => {
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

it('is a file in the end, or none: PNG and PDF with their scale', async () => {
  const file = (name: string) => join(folder, name)
  expect(await run(link, '-o', file('a.SVG'))).toEqual([0, '', ''])
  expect(readFileSync(file('a.SVG'), 'utf8')).toBe(await renderSVG(STATE))
  for (const [name, options, format, scale] of [
    ['a.png', [], 'png', 2],
    ['a.pdf', ['--scale', '3.5'], 'pdf', 3.5],
    ['b.png', ['--scale', '100'], 'png', 100],
  ] as const) {
    expect(await run(link, '--output', file(name), '--size', '30x20', ...options)).toEqual([0, '', ''])
    expect(converted.at(-1)).toEqual([
      { svg: expect.stringMatching(/^<svg/), width: 30, height: 20, scale },
      format,
      `${file(name)}.part.${format}`,
    ])
    expect(readFileSync(file(name), 'utf8')).toBe('made')
  }
  isInstalled = false
  expect(await run(link, '-o', file('c.png'))).toEqual([1, '', expect.stringContaining('PNG and PDF need')])
  failure = new Error('It broke.')
  expect(await run(link, '-o', file('a.png'))).toEqual([1, '', 'circle-voronoi: It broke.\n'])
  expect(readdirSync(folder).sort()).toEqual(['a.SVG', 'a.pdf', 'a.png', 'b.png'])
  expect(existsSync(file('c.png'))).toBe(false)
})

it.each([
  [['--size', '0x9'], '--size is a width'],
  [['--size', '9x0'], '--size is a width'],
  [['--size', '123456x9'], '--size is a width'],
  [['--size', '9x9x9'], '--size is a width'],
  [['--scale', '0'], '--scale is a number above 0'],
  [['--scale', '101'], '--scale is a number above 0'],
  [['--scale', 'x'], '--scale is a number above 0'],
  [['other'], 'picture takes one link or file'],
  [['-o', 'a'], 'not a file without extension.'],
])('is a mistake of the user with %j', async (args, message) => {
  expect(await run(link, ...args)).toEqual([2, '', expect.stringContaining(message)])
})

it('is read from files, and says which file is wrong', async () => {
  const file = join(folder, 'a.csv')
  writeFileSync(file, `x,y,r\n${CIRCLES.map((circle) => circle.join()).join('\n')}\n`)
  expect(await run(file)).toEqual([0, await renderSVG(STATE), ''])
  writeFileSync(file, '1,2\n')
  const [status, , error] = await run(file)
  expect([status, error]).toEqual([2, expect.stringContaining(file)])
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
  await expect(renderSVG({ ...STATE, areas: 'equal' })).rejects.toThrow(/region/)
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
