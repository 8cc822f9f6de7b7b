// SPDX-License-Identifier: GPL-3.0-or-later
// Random actions in the page. `npm run monkey` runs more actions.
import { writeFileSync } from 'node:fs'
import type { CDPSession, Page } from '@playwright/test'
import { Monkey, stay } from './monkey.ts'
import { App, expect as expectSoon, test } from './page.ts'
import { differenceOf, keepPicture, pngOf, shown } from './pictures.ts'
import { heapOf, THREAD, withThread } from './thread-session.ts'

/** Pending actions may take a while. */
const expect = expectSoon.configure({ timeout: 30_000 })
const ACTIONS = Number(process.env.MONKEY_ACTIONS ?? 90)
const SEED = Number(process.env.CIRCLE_VORONOI_SEED ?? 1)
/** The picture is checked after this many actions. */
const CHECKED = 30
/** Allowed growth of heaps in bytes, and of the document in nodes. The history is unlimited. */
const GROWTH = { page: 12e6, thread: 24e6, nodes: 3000 }

test.use({ hasTouch: true, permissions: ['clipboard-read', 'clipboard-write'] })

/**
 * Waits until all requests are done and painted, including fits in their thread and work that the painting thread defers
 * until no edit is in progress.
 */
async function rest(app: App): Promise<void> {
  const threads = async () => {
    const idle = app.page.workers().map((thread) =>
      // The thread may end meanwhile.
      thread.evaluate(() => new Promise((resolve) => setTimeout(resolve, 300))).catch(() => {}),
    )
    await Promise.all(idle)
  }
  let last: string | undefined
  await expect(async () => {
    const before = last
    await threads()
    await expect(app.canvas).toHaveAttribute('aria-busy', 'false', { timeout: 100 })
    last = await shown(app.page)
    expect(last).toBe(before)
  }).toPass({ intervals: [100], timeout: 120_000 })
}

/** Repaints the whole picture in the same grid. */
async function paintAnew(app: App): Promise<void> {
  const toggle = app.page.locator('#layers').getByLabel('Edges', { exact: true })
  for (let k = 0; k < 2; k++) {
    await toggle.evaluate((box: HTMLInputElement) => box.click())
    await rest(app)
  }
}

/** Expects that tiles painted by edits equal a full repaint. */
async function expectPaintedRight(app: App): Promise<void> {
  await rest(app)
  await keepPicture(app.page, 'before')
  await paintAnew(app)
  await expectSame(app)
}

/** Expects that a new thread, which gets the state of the view, paints the same picture. */
async function expectSameInNewThread(app: App): Promise<void> {
  await paintAnew(app)
  await keepPicture(app.page, 'before')
  const next = app.page.waitForEvent('worker')
  // The thread crashes at the next message.
  await app.page.evaluate(() => {
    const { postMessage } = Worker.prototype
    Worker.prototype.postMessage = function () {
      Worker.prototype.postMessage = postMessage
      this.dispatchEvent(new ErrorEvent('error', { message: 'the test has ended it' }))
    }
  })
  await paintAnew(app)
  await next
  await paintAnew(app)
  await expectSame(app)
}

/** Expects that the picture is the one that was kept before. */
async function expectSame({ page }: App): Promise<void> {
  await keepPicture(page, 'after')
  const difference = await differenceOf(page)
  if (difference.squares > 0) {
    console.log(page.url())
    for (const name of ['before', 'after'] as const) {
      const path = test.info().outputPath(`${name}.png`)
      writeFileSync(path, Buffer.from(await pngOf(page, name)))
      console.log(path)
    }
  }
  expect(difference).toEqual({ squares: 0 })
}

async function fold(page: Page, name: string, isOpen: boolean): Promise<void> {
  const button = page.getByRole('button', { name, exact: true, includeHidden: true })
  if ((await button.getAttribute('aria-expanded')) !== String(isOpen)) {
    await button.evaluate((button: HTMLButtonElement) => button.click())
  }
}

/** Heap sizes of the page and of the painting thread, with the same few circles and after garbage collection. */
async function heaps(app: App, session: CDPSession): Promise<{ page: number; thread: number; nodes: number }> {
  // The gallery keeps its pictures, which have thousands of nodes.
  await fold(app.page, 'Gallery', true)
  await expect(app.page.locator('#generate .scene:has(svg)')).not.toHaveCount(0)
  await expect(app.page.locator('#generate .scene:not(:has(svg))')).toHaveCount(0)
  await fold(app.page, 'Layers', true)
  await app.page.getByLabel('Data set').selectOption('introduction')
  await expect(app.status).toContainText('14 circles')
  await rest(app)
  await session.send('HeapProfiler.collectGarbage')
  const { usedSize } = await session.send('Runtime.getHeapUsage')
  const { nodes } = await session.send('Memory.getDOMCounters')
  return { page: usedSize, thread: await withThread(session, THREAD, heapOf), nodes }
}

test(
  `whatever ${ACTIONS} things a monkey does, the page is as a new one would be`,
  { tag: '@long' },
  async ({ app, browser }, info) => {
    test.setTimeout(ACTIONS * 10_000 + 600_000)
    console.log(`CIRCLE_VORONOI_SEED=${SEED}`)
    const { page } = app
    const session = await page.context().newCDPSession(page)
    await page.addInitScript(stay)
    await page.evaluate(stay)
    const monkey = new Monkey(page, SEED, session)
    try {
      await fold(page, 'Layers', true)
      let early: Awaited<ReturnType<typeof heaps>> | undefined
      while (monkey.done.length < ACTIONS) {
        for (let k = 0; k < CHECKED; k++) await monkey.act()
        await fold(page, 'Layers', true)
        await expectPaintedRight(app)
        await expect(page.locator('#problem')).not.toContainText('could not be')
        if (monkey.done.length >= ACTIONS / 4) early ??= await heaps(app, session)
      }
      early ??= await heaps(app, session)
      // Makes sure that there is something to undo.
      for (let k = 0; k < 10; k++) await monkey.act()

      // Shows all circles without highlights. Their colors depend on earlier circles.
      await page.setViewportSize({ width: 1280, height: 800 })
      await page.emulateMedia({ colorScheme: 'light' })
      await fold(page, 'Layers', true)
      await page.locator('#cell-colors').selectOption('none')
      await page.getByRole('button', { name: 'Select and move' }).click()
      await app.canvas.press('Escape')
      await page.getByRole('button', { name: 'Fit', exact: true }).click()
      await expectPaintedRight(app)
      await fold(page, 'Numbers', true)
      await expect(page.locator('#numbers .certificate').first()).toContainText('Proven')
      await fold(page, 'Layers', true)
      await expectSameInNewThread(app)

      // Another page is at rest, too.
      await rest(app)
      const context = await browser.newContext()
      const fresh = new App(await context.newPage())
      await fresh.page.goto(page.url())
      // Ignores the computing time and the rounding of areas.
      const counts = async ({ status }: App) =>
        (await status.textContent())?.replace(/ · [^·]* m?s$/, '').replace(/within [^·]*/, '')
      await expect.poll(() => counts(fresh)).toBe(await counts(app))
      await context.close()

      const late = await heaps(app, session)
      console.log(JSON.stringify({ actions: monkey.done.length, early, late }))
      expect(late.page - early.page).toBeLessThan(GROWTH.page)
      expect(late.thread - early.thread).toBeLessThan(GROWTH.thread)
      expect(late.nodes - early.nodes).toBeLessThan(GROWTH.nodes)
    } finally {
      writeFileSync(info.outputPath('done.txt'), `${monkey.done.join('\n')}\n`)
    }
  },
)
