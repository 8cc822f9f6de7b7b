// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run picture`: pictures of the page for the README (docs/page-light.jpg, docs/page-dark.jpg), of the examples
// (docs/examples), of the recipes (docs/cookbook) and of the first page (docs/three-circles.svg).
import { withBuiltPage } from './built-page.mjs'
import { pictureRecipes } from './picture-recipes.mjs'
import { main, ROOT } from './run.mjs'
import { pictureOf, readGallery } from './texts/gallery.mjs'

/** The circle in the middle, which is selected, and a place for the pointer beside it. */
const SELECTED = { x: 661, y: 404 }
const ASIDE = { x: 640, y: 30 }

await main(() =>
  withBuiltPage(async (browser, address) => {
    for (const colorScheme of ['light', 'dark']) {
      const page = await browser.newPage({
        viewport: { width: 1280, height: 800 },
        deviceScaleFactor: 1.5,
        colorScheme,
        reducedMotion: 'reduce',
      })
      await page.goto(address)
      await page.getByRole('status').getByText('14 edges').waitFor()
      await page.mouse.click(SELECTED.x, SELECTED.y)
      await page.getByRole('region', { name: 'Selected circle', exact: true }).waitFor()
      await page.mouse.move(ASIDE.x, ASIDE.y)
      await page.locator('#figure[aria-busy="false"]').waitFor()
      await page.screenshot({ path: `${ROOT}docs/page-${colorScheme}.jpg`, type: 'jpeg', quality: 88 })
      await page.close()
    }
    for (const { folder } of readGallery().filter(({ isLive }) => isLive)) {
      // The size in the documentation.
      const page = await browser.newPage({ viewport: { width: 736, height: 589 } })
      await page.goto(`${address}examples/${folder}/`, { waitUntil: 'networkidle' })
      for (const frame of page.frames()) await frame.evaluate(settled)
      await page.screenshot({ path: `${ROOT}docs/${pictureOf(folder)}`, type: 'jpeg', quality: 70 })
      await page.close()
    }
    await pictureRecipes(browser)
  }),
)

/** Runs in a page. Waits until its first figure is painted, or its frames are counted. */
async function settled() {
  /** @type {Iterable<Element & { ready?: Promise<void>, updateComplete?: Promise<void> }>} */
  const figures = [...document.querySelectorAll('circle-voronoi')].slice(0, 1)
  for (const figure of figures) {
    await figure.ready
    await figure.updateComplete
  }
  while (document.querySelector('output')?.textContent === 'loading') await new Promise(requestAnimationFrame)
}
