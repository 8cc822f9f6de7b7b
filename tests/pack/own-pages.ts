// SPDX-License-Identifier: GPL-3.0-or-later
// Pages that the tests of one file write, with the element of the package.
import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { type Page, test } from '@playwright/test'
import { ROOT } from './project.mjs'
import { type Server, serve } from './static-server.ts'

interface OwnPages {
  /** The folder of the pages, from the root of the project. */
  readonly folder: string
  /** Opens a page with this body and the element's module. */
  visit(page: Page, body: string): Promise<void>
  /** Opens such a page and waits until its figures are drawn. */
  open(page: Page, body: string): Promise<void>
}

/** Serves pages to the tests of a file. Each worker has a folder of its own. */
export function ownPages(name: string): OwnPages {
  const folder = `build/${name}-${process.env.TEST_PARALLEL_INDEX}`
  let server: Server
  test.beforeAll(async () => {
    server = await serve(ROOT, "default-src 'self' data: 'wasm-unsafe-eval' 'unsafe-inline'")
  })
  test.afterAll(() => server.close())

  async function visit(page: Page, body: string): Promise<void> {
    mkdirSync(join(ROOT, folder), { recursive: true })
    writeFileSync(
      join(ROOT, folder, 'index.html'),
      `<!doctype html><html lang="en"><title>Page</title><link rel="icon" href="data:,">
      <script type="module" src="/dist/element/index.js"></script>${body}`,
    )
    await page.goto(`${server.address}${folder}/index.html`)
  }

  async function open(page: Page, body: string): Promise<void> {
    await visit(page, body)
    const figures = page.locator('circle-voronoi')
    await figures.first().waitFor({ state: 'attached' })
    await figures.evaluateAll(async (elements) => {
      for (const element of elements as HTMLElementTagNameMap['circle-voronoi'][]) {
        await element.ready
        await element.updateComplete
      }
    })
  }

  return { folder, visit, open }
}
