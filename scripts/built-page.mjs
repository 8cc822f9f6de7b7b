// SPDX-License-Identifier: GPL-3.0-or-later
import { build, ROOT } from './run.mjs'
import { chromiumPath, setup } from './setup.mjs'

/** Builds the page, serves it and calls `use` with a Chromium and the page's address. */
export async function withBuiltPage(use) {
  await setup('tests')
  await build('build')
  // Vite is installed with the npm packages, so the import must wait until setup has run.
  const { preview } = await import('vite')
  const { chromium } = await import('@playwright/test')
  const server = await preview({ root: `${ROOT}web`, configFile: `${ROOT}vite.config.ts`, preview: { port: 0 } })
  const browser = await chromium.launch({
    executablePath: chromiumPath(),
    args: ['--headless', '--no-sandbox', '--disable-gpu'],
  })
  try {
    await use(browser, server.resolvedUrls?.local[0])
  } finally {
    await browser.close()
    await server.close()
  }
}
