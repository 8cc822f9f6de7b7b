// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the documentation's code for pages like a reader.
import { expect, test } from '@playwright/test'
import { blocksRunBy } from '../readme/blocks.mjs'
import { soon } from '../soon.ts'
import { Project } from './project.mjs'
import { INLINE_POLICY, serve } from './static-server.ts'

const BLOCKS = blocksRunBy('tests/pack/readme.spec.ts')
/**
 * The package's address in the documentation of the element. Its fragments belong to a page that has loaded the
 * element.
 */
const ELSEWHERE = 'https://example.com/circle-voronoi/'
const ELEMENT = '<script type="module" src="node_modules/circle-voronoi/dist/element/index.js"></script>\n'

let project: Project
test.beforeAll(() => {
  project = new Project()
})
test.afterAll(() => project.remove())

for (const { file, code, line } of BLOCKS) {
  test(`${file}:${line}, in a page`, async ({ page }) => {
    const own = code.includes('<script') ? code.replace(ELSEWHERE, 'node_modules/circle-voronoi/') : ELEMENT + code
    project.write('index.html', `<!doctype html>\n${own}`)
    project.write('circles.csv', 'x,y,r\n0,0,2\n10,0,1\n5,8,1.5\n')
    const complaints: string[] = []
    page.on('pageerror', (error) => complaints.push(error.message))
    // The warning about frequent reading of pixels is caused by this test.
    const isOurs = (text: string) => text.includes('willReadFrequently')
    page.on('console', (message) => isOurs(message.text()) || complaints.push(message.text()))
    const server = await serve(project.folder, INLINE_POLICY)
    try {
      await page.goto(server.address)
      await soon(() => page.locator('canvas').first().evaluate(inkOf), complaints.join()).toBeGreaterThan(500)
      expect(complaints).toEqual([])
    } finally {
      await server.close()
    }
  })
}

/** The number of non-empty pixels of a canvas. */
function inkOf(canvas: Element): number {
  const { width, height } = canvas as HTMLCanvasElement
  const context = (canvas as HTMLCanvasElement).getContext('2d') as CanvasRenderingContext2D
  const { data } = context.getImageData(0, 0, width, height)
  return data.filter((value, i) => i % 4 === 3 && value > 0).length
}
