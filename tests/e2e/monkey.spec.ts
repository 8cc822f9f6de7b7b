// SPDX-License-Identifier: GPL-3.0-or-later
// Random actions in the page. `npm run monkey` runs more actions.
import { writeFileSync } from 'node:fs'
import type { CDPSession, JSHandle, Page } from '@playwright/test'
import { Monkey } from './monkey.ts'
import { App, expect as expectSoon, test } from './page.ts'
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

/** Summarizes the visible state, to detect changes. */
function shown({ page }: App): Promise<string> {
  return page.evaluate(async () => {
    const hashes = [...document.querySelectorAll<HTMLCanvasElement>('#figure canvas')].map(async (canvas) => {
      const copy = new OffscreenCanvas(canvas.width, canvas.height)
      const context = copy.getContext('2d', { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D
      context.drawImage(canvas, 0, 0)
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height)
      return String(new Uint8Array(await crypto.subtle.digest('SHA-256', data)))
    })
    const status = document.querySelector('#status')?.textContent
    return [status, location.href, ...(await Promise.all(hashes))].join()
  })
}

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
    last = await shown(app)
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
  const before = await painted(app.page)
  await paintAnew(app)
  await expectSame(app, before, await painted(app.page))
}

/** Expects that a new thread, which gets the state of the view, paints the same picture. */
async function expectSameInNewThread(app: App): Promise<void> {
  await paintAnew(app)
  const before = await painted(app.page)
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
  await expectSame(app, before, await painted(app.page))
}

async function expectSame({ page }: App, before: Painted, after: Painted): Promise<void> {
  const difference = await page.evaluate(differenceOf, [before, after] as const)
  if (difference.squares > 0) {
    console.log(page.url())
    for (const [name, picture] of Object.entries({ before, after })) {
      const path = test.info().outputPath(`${name}.png`)
      writeFileSync(path, Buffer.from(await page.evaluate(pngOf, picture)))
      console.log(path)
    }
  }
  expect(difference).toEqual({ squares: 0 })
}

async function pngOf(picture: ImageData): Promise<number[]> {
  const canvas = new OffscreenCanvas(picture.width, picture.height)
  canvas.getContext('2d')?.putImageData(picture, 0, 0)
  return [...new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer())]
}

type Painted = JSHandle<ImageData>

function painted(page: Page): Promise<Painted> {
  return page.evaluateHandle(() => {
    const canvas = document.querySelector('#figure canvas') as HTMLCanvasElement
    const copy = new OffscreenCanvas(canvas.width, canvas.height)
    const context = copy.getContext('2d', { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D
    context.drawImage(canvas, 0, 0)
    return context.getImageData(0, 0, canvas.width, canvas.height)
  })
}

/**
 * The number and places of tiles that differ. Clipping changes the chords of lines by up to a tenth of a pixel, so that
 * single pixels may differ.
 */
function differenceOf([one, other]: readonly [ImageData, ImageData]) {
  const side = 3
  const most = 24 * side * side
  if (one.width !== other.width || one.height !== other.height) return { squares: Number.POSITIVE_INFINITY }
  let squares = 0
  let [left, top, right, bottom] = [one.width, one.height, 0, 0]
  for (let y = 0; y + side <= one.height; y += side) {
    for (let x = 0; x + side <= one.width; x += side) {
      const sums = [0, 0, 0]
      for (let k = 0; k < side * side; k++) {
        const first = 4 * ((y + Math.floor(k / side)) * one.width + x + (k % side))
        for (const c of [0, 1, 2]) {
          sums[c] = (sums[c] as number) + (one.data[first + c] as number) - (other.data[first + c] as number)
        }
      }
      if (sums.every((sum) => Math.abs(sum) <= most)) continue
      squares += 1
      ;[left, top, right, bottom] = [Math.min(left, x), Math.min(top, y), Math.max(right, x), Math.max(bottom, y)]
    }
  }
  return squares === 0 ? { squares } : { squares, left, top, right, bottom }
}

async function fold(page: Page, name: string, isOpen: boolean): Promise<void> {
  const button = page.getByRole('button', { name, exact: true, includeHidden: true })
  if ((await button.getAttribute('aria-expanded')) !== String(isOpen)) {
    await button.evaluate((button: HTMLButtonElement) => button.click())
  }
}

/** Heap sizes of the page and of the painting thread, with the same few circles and after garbage collection. */
async function heaps(app: App, session: CDPSession): Promise<{ page: number; thread: number; nodes: number }> {
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
    // Prevents navigation and dragging by the browser.
    const stay = () => {
      const isLink = ({ target }: Event) => (target as Element).closest('a') !== null
      document.addEventListener('click', (event) => isLink(event) && event.preventDefault(), { capture: true })
      document.addEventListener('dragstart', (event) => event.preventDefault(), { capture: true })
    }
    await page.addInitScript(stay)
    await page.evaluate(stay)
    const monkey = new Monkey(app, session, SEED)
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
