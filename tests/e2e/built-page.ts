// SPDX-License-Identifier: GPL-3.0-or-later
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { test as base, expect, type Page } from '@playwright/test'
import { build, type PreviewServer, preview } from 'vite'

/**
 * A test with a page of this folder, built for it. The test fails on any error of the page. `shown` waits until the
 * page is ready.
 */
export function testOf(name: string, shown: (page: Page) => Promise<void>) {
  const root = fileURLToPath(new URL(name, import.meta.url))
  const builds = fileURLToPath(new URL('../../build/pages', import.meta.url))
  return base.extend<{ opened: Page }, { server: PreviewServer }>({
    server: [
      // biome-ignore lint/correctness/noEmptyPattern: Playwright reads from it which fixtures this needs
      async ({}, use) => {
        // Each worker has a folder of its own, because others may build at the same time.
        mkdirSync(builds, { recursive: true })
        const outDir = mkdtempSync(`${builds}/${name}-`)
        const options = { root, configFile: false, logLevel: 'error' } as const
        const built = { outDir, emptyOutDir: true, target: 'es2022', cssTarget: 'chrome123' }
        await build({ ...options, worker: { format: 'es' }, build: built })
        const server = await preview({ ...options, build: { outDir }, preview: { port: 0 } })
        await use(server)
        await server.close()
        rmSync(outDir, { recursive: true })
      },
      { scope: 'worker' },
    ],
    opened: async ({ page, server }, use) => {
      const errors: string[] = []
      page.on('pageerror', (error) => errors.push(error.message))
      page.on('console', (message) => message.type() === 'error' && errors.push(message.text()))
      await page.goto(server.resolvedUrls?.local[0] as string)
      await shown(page)
      await use(page)
      expect(errors).toEqual([])
    },
  })
}
