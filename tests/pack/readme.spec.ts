// SPDX-License-Identifier: GPL-3.0-or-later
// The code for JavaScript and for pages in the documentation, run as a reader would.
import { existsSync, rmSync } from 'node:fs'
import { basename } from 'node:path'
import { expect, test } from '@playwright/test'
import { blocksRunBy } from '../readme/blocks.mjs'
import { Project } from './project.ts'
import { INLINE_POLICY, serve } from './static-server.ts'

const BLOCKS = blocksRunBy('tests/pack/readme.spec.ts')
const inLanguage = (name: string) => BLOCKS.filter(({ language }) => language === name)
/** Where the documentation of the element has the package; and what it shows is of a page that has the element. */
const ELSEWHERE = 'https://example.com/circle-voronoi/'
const ELEMENT = '<script type="module" src="node_modules/circle-voronoi/dist/element/index.js"></script>\n'

let project: Project
test.beforeAll(() => {
  project = new Project()
})
test.afterAll(() => project.remove())

test('all of it is run', () => {
  expect(new Set(BLOCKS.map(({ language }) => language))).toEqual(new Set(['sh', 'js', 'html']))
  expect(inLanguage('sh')).toHaveLength(1)
})

test('install', () => {
  const [pack, install] = (inLanguage('sh')[0]?.code ?? '').split('\n')
  expect(pack).toMatch(/^npm pack +# .*: builds ([\w.-]+\.tgz)$/)
  expect(pack).toContain(basename(project.tarball))
  rmSync(project.path('node_modules'), { recursive: true })
  project.run('sh', '-c', `npm_config_offline=true ${install}`)
  expect(existsSync(project.path('node_modules/circle-voronoi/package.json'))).toBe(true)
})

for (const [i, { file, code, line }] of inLanguage('js').entries()) {
  test(`${file}:${line}, in Node`, () => {
    // What it prints stands behind each call, as a comment.
    const expected = [...code.matchAll(/^console\.log\(.*\) \/\/ (.*)$/gm)].map(([, text]) => `${text}\n`)
    expect(expected).not.toHaveLength(0)
    project.write(`readme-${i}.js`, code)
    expect(project.run(process.execPath, `readme-${i}.js`)).toBe(expected.join(''))
  })
}

for (const { file, code, line } of inLanguage('html')) {
  test(`${file}:${line}, in a page`, async ({ page }) => {
    const own = code.includes('<script') ? code.replace(ELSEWHERE, 'node_modules/circle-voronoi/') : ELEMENT + code
    project.write('index.html', `<!doctype html>\n${own}`)
    project.write('circles.csv', 'x,y,r\n0,0,2\n10,0,1\n5,8,1.5\n')
    const complaints: string[] = []
    page.on('pageerror', (error) => complaints.push(error.message))
    // That its pixels are read often is of this test's making.
    const isOurs = (text: string) => text.includes('willReadFrequently')
    page.on('console', (message) => isOurs(message.text()) || complaints.push(message.text()))
    const server = await serve(project.folder, INLINE_POLICY)
    try {
      await page.goto(server.address)
      await expect
        .poll(() => page.locator('canvas').first().evaluate(inkOf), { message: complaints.join() })
        .toBeGreaterThan(500)
      expect(complaints).toEqual([])
    } finally {
      await server.close()
    }
  })
}

/** How many pixels of a canvas are drawn on. */
function inkOf(canvas: Element): number {
  const { width, height } = canvas as HTMLCanvasElement
  const context = (canvas as HTMLCanvasElement).getContext('2d') as CanvasRenderingContext2D
  const { data } = context.getImageData(0, 0, width, height)
  return data.filter((value, i) => i % 4 === 3 && value > 0).length
}
