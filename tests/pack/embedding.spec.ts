// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the code of docs/embedding.md like a reader.
import { cpSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from '@playwright/test'
import { embedCode } from '../../web/app/files/saving.ts'
import { blocksRunBy } from '../readme/blocks.mjs'
import { soon } from '../soon.ts'
import { Project, ROOT } from './project.mjs'
import { INLINE_POLICY, serve } from './static-server.ts'

const BLOCKS = blocksRunBy('tests/pack/embedding.spec.ts')
const below = (heading: string) => BLOCKS.filter(({ headings }) => headings.at(-1) === heading).map(({ code }) => code)

let project: Project
test.beforeAll(() => {
  project = new Project()
})
test.afterAll(() => project.remove())

test('a script in Node writes the link of a question', () => {
  const [code] = below('Questions in a frame') as [string]
  project.write('question.js', code)
  expect(project.run(process.execPath, 'question.js')).toBe('v1.\n')
})

test('the commands and the script of the section about pictures draw', () => {
  const [commands, code] = below('As a picture') as [string, string]
  const [first, second] = commands.trim().split('\n') as [string, string]
  project.run('sh', '-c', first)
  expect(readFileSync(project.path('figure.svg'), 'utf8')).toMatch(/^<svg.* width="720" height="480"/)
  project.write('circles.csv', 'x,y,r\n0,0,2\n10,0,1\n5,8,1.5\n')
  project.run('sh', '-c', second)
  expect(readFileSync(project.path('figure.svg'), 'utf8')).toMatch(/^<svg.* width="900" height="600"/)
  project.write('picture.js', code)
  expect(project.run(process.execPath, 'picture.js')).toBe('<svg\n')
})

test('the script of the page around a frame is that of the example', () => {
  const [code] = below('A frame that talks to its page') as [string]
  expect(readFileSync(join(ROOT, 'examples/element/question-frame/host.js'), 'utf8')).toContain(code)
})

test('the lines for Quarto are a live figure in a page', async ({ page }) => {
  const [lines] = below('Quarto') as [string]
  project.write(
    'quarto.html',
    `<!doctype html><html lang="en"><title>Quarto</title><link rel="icon" href="data:,">${lines}</html>`,
  )
  cpSync(join(ROOT, 'dist/element/classic.js'), project.path('classic.js'))
  const server = await serve(project.folder, `${INLINE_POLICY}; worker-src blob:`)
  await page.goto(`${server.address}quarto.html`)
  const figure = page.locator('circle-voronoi')
  await soon(() => figure.evaluate((element: HTMLElementTagNameMap['circle-voronoi']) => element.circles?.length)).toBe(
    9,
  )
  expect(await figure.evaluate((element: HTMLElementTagNameMap['circle-voronoi']) => element.toSVG())).toContain(
    'clipPath',
  )
  await server.close()
})

test('the lines for Moodle and WordPress are those that the playground writes', () => {
  const [lines] = below('Moodle, WordPress and other systems') as [string]
  const [, address = ''] = /src="([^"]+)"/.exec(lines) ?? []
  expect(lines.trim()).toBe(embedCode(address))
})
