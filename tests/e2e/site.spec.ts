// SPDX-License-Identifier: GPL-3.0-or-later
// The built site: in any folder of any server, compressed, offline, and during a deployment.
import { cpSync, existsSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs'
import { createServer, type Server } from 'node:http'
import type { AddressInfo } from 'node:net'
import { tmpdir } from 'node:os'
import { fileURLToPath } from 'node:url'
import { expect, type Page, test } from '@playwright/test'
import sirv from 'sirv'
import { writeServiceWorker } from '../../scripts/site.mjs'
import { CHROMIUM } from '../chromium.ts'
import { soon } from '../soon.ts'
import { App, dataSet, test as testOfApp } from './page.ts'

test.use({ launchOptions: CHROMIUM })
testOfApp.use({ launchOptions: CHROMIUM })

const SITE = fileURLToPath(new URL('../../dist/site', import.meta.url))
const FOLDER = '/some/sub/path/'
const INTRODUCTION = dataSet('introduction')
/** Limit for the transferred bytes until the first diagram. */
const MOST_BYTES = 279_000
/** The connection that Lighthouse simulates: round-trip time in milliseconds, and bytes per second. */
const SLOW_4G = { latency: 150, throughput: (1.6 * 2 ** 20) / 8 }
/** Limits in milliseconds on this connection until the first text, and until circles can be dragged. */
const READABLE = 1000
const LIVE = 2500

/** Serves files below `FOLDER` like a plain server. */
async function serve(files: string): Promise<{ server: Server; url: string }> {
  const send = sirv(files, { dev: true, etag: true })
  const server = createServer((request, response) => {
    const notFound = () => {
      response.statusCode = 404
      response.end()
    }
    if (!request.url?.startsWith(FOLDER)) return notFound()
    request.url = request.url.slice(FOLDER.length - 1)
    send(request, response, notFound)
  })
  await new Promise<void>((resolve) => server.listen(0, 'localhost', resolve))
  return { server, url: `http://localhost:${(server.address() as AddressInfo).port}${FOLDER}` }
}

async function stop(server: Server): Promise<void> {
  server.closeAllConnections()
  await new Promise((resolve) => server.close(resolve))
}

/** Opens the page at an address, and waits until it works offline. */
async function kept(page: Page, url: string): Promise<App> {
  const app = new App(page)
  await page.goto(url)
  await expect(app.status).toHaveText(/^8 circles/)
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready
    if (navigator.serviceWorker.controller !== null) return
    await new Promise((resolve) => navigator.serviceWorker.addEventListener('controllerchange', resolve))
  })
  return app
}

async function openFile({ page }: App, name: string, text: string): Promise<void> {
  const files = page.getByRole('button', { name: 'Files' })
  if ((await files.getAttribute('aria-expanded')) === 'false') await files.click()
  await page.getByLabel('Open …').setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) })
}

test.describe('kept by the browser', () => {
  test.use({ serviceWorkers: 'allow' })

  test('works in a folder, and there without its server', async ({ page }) => {
    const errors: string[] = []
    page.on('pageerror', (error) => errors.push(error.message))
    page.on('console', (message) => message.type() !== 'log' && errors.push(message.text()))
    const { server, url } = await serve(SITE)
    let app: App
    try {
      app = await kept(page, url)
    } finally {
      await stop(server)
    }
    expect(await page.request.get(url).catch(() => undefined)).toBeUndefined()
    await page.reload()
    await expect(app.status).toHaveText(/^8 circles/)
    await app.choose('Introduction')
    await app.select(INTRODUCTION, 4)
    await page.keyboard.press('Delete')
    await expect(app.status).toContainText('13 circles')
    // Parts that are loaded on demand: readers and writers, charts, power diagrams.
    await openFile(app, 'three.csv', '0,0,1\n6,0,1\n0,8,1\n')
    await expect(app.status).toContainText('3 circles')
    await app.openPanel('Numbers')
    await expect(page.locator('#numbers .chart canvas').first()).toBeVisible()
    await app.openPanel('Layers')
    const picture = await app.canvas.screenshot()
    await page.getByLabel('Power diagram').check()
    await soon(async () => picture.equals(await app.canvas.screenshot())).toBe(false)
    // The tutorial and its search.
    await page.goto(`${url}tutorial/`)
    await page.getByRole('main').getByRole('link', { name: 'Which circle is nearest?' }).click()
    // The interactive figures of the tutorial and of the element.
    await expect(page.locator('svg.drawn .handle').first()).toBeVisible()
    await page.locator('circle-voronoi').first().scrollIntoViewIfNeeded()
    await expect(page.locator('circle-voronoi').first().getByRole('application')).toHaveAccessibleDescription(
      /^5 circles/,
    )
    await page.getByLabel('Search').fill('hyperbola')
    await expect(page.locator('.found a').first()).toBeVisible()
    expect(errors).toEqual([])
  })

  test('a page keeps its version while the next one takes its place', async ({ page }) => {
    const folder = mkdtempSync(`${tmpdir()}/site-`)
    cpSync(SITE, folder, { recursive: true })
    const { server, url } = await serve(folder)
    try {
      const app = await kept(page, url)
      // The next version renames a part that this page has not loaded yet.
      const name = (pattern: RegExp) => readdirSync(`${folder}/assets`).find((name) => pattern.test(name)) as string
      const thread = name(/^files-thread-.*\.js$/)
      const replace = (path: string, before: string, after: string) => {
        const text = readFileSync(path, 'utf8')
        expect(text).toContain(before)
        writeFileSync(path, text.replaceAll(before, after))
      }
      // Renames the file and the files that refer to it.
      const rename = (before: string) => {
        const after = before.replace(/\.js$/, '-next.js')
        renameSync(`${folder}/assets/${before}`, `${folder}/assets/${after}`)
        for (const path of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
          // Skips files that have been renamed already.
          if (!/\.(html|js)$/.test(path) || !existsSync(`${folder}/${path}`)) continue
          if (!readFileSync(`${folder}/${path}`, 'utf8').includes(before)) continue
          replace(`${folder}/${path}`, before, after)
          if (/^assets\/.*(?<!-next)\.js$/.test(path)) rename(path.slice('assets/'.length))
        }
      }
      rename(thread)
      replace(`${folder}/index.html`, '<title>', '<title>Next: ')
      await writeServiceWorker(folder)
      await page.evaluate(async () => {
        const changed = new Promise((resolve) => navigator.serviceWorker.addEventListener('controllerchange', resolve))
        await (await navigator.serviceWorker.ready).update()
        await changed
      })
      await openFile(app, 'three.csv', '0,0,1\n6,0,1\n0,8,1\n')
      await expect(app.status).toContainText('3 circles')
      expect(await page.title()).not.toContain('Next')
      await page.reload()
      await expect(page).toHaveTitle(/^Next/)
      await expect(app.status).toContainText('edges')
      // The page opens the panel again that was open.
      await expect(page.getByLabel('Open …')).toBeVisible()
      await openFile(app, 'two.csv', '0,0,1\n6,0,1\n')
      await expect(app.status).toContainText('2 circles')

      // A partly deployed version, with a file that differs from its list, changes nothing.
      replace(`${folder}/index.html`, '<title>', '<title>After ')
      await writeServiceWorker(folder)
      replace(`${folder}/index.html`, '<title>After ', '<title>Half ')
      await page.evaluate(async () => {
        const registration = await navigator.serviceWorker.ready
        const installing = new Promise<ServiceWorker>((resolve) => {
          registration.addEventListener('updatefound', () => resolve(registration.installing as ServiceWorker))
        })
        await registration.update()
        const worker = await installing
        if (worker.state === 'redundant') return
        await new Promise<void>((resolve) => {
          worker.addEventListener('statechange', () => worker.state === 'redundant' && resolve())
        })
      })
      await page.reload()
      await expect(page).toHaveTitle(/^Next/)
    } finally {
      await stop(server)
      rmSync(folder, { recursive: true, force: true })
    }
  })
})

test('a figure on another page has all its modules in its one file', async ({ page }) => {
  const answers: string[] = []
  page.on('response', (response) => {
    const [, module] = /lib\/generated\/(.*)$/.exec(response.url()) ?? []
    if (module !== undefined) answers.push(`${response.status()} ${module}`)
  })
  const { server, url } = await serve(SITE)
  try {
    const lesson = new URL('/lessons/first/', url).href
    await page.route(lesson, (route) =>
      route.fulfill({
        contentType: 'text/html',
        body: `<!doctype html><html lang="en"><title>Lesson</title><link rel="icon" href="data:,">
          <script type="module" src="${FOLDER}element.js"></script>
          <circle-voronoi circles="[[1, 2, 0], [5, 1, 0], [4, 6, 0]]" areas="1 2 4"
            region="POLYGON ((0 0, 9 1, 8 7, 3 8, 0 5), (3 3, 4 3, 4 4))"></circle-voronoi>
          <circle-voronoi circles="[[1, 2, 1], [5, 1, 0], [4, 6, 0]]" layers="power"></circle-voronoi>`,
      }),
    )
    await page.goto(lesson)
    const shown = page.locator('circle-voronoi').evaluateAll((elements: HTMLElementTagNameMap['circle-voronoi'][]) =>
      Promise.all(
        elements.map(async (element) => {
          await element.toSVG()
          return [...element.circles].filter((_, k) => k % 3 === 2)
        }),
      ),
    )
    const [weights, radii] = await shown
    // Radii are the fitted weights.
    expect(weights?.[2]).toBeGreaterThan(0.1)
    expect(radii).toEqual([1, 0, 0])
    expect(answers).toEqual([])
  } finally {
    await stop(server)
  }
})

testOfApp('the first diagram needs few bytes, and all of them are sent compressed', async ({ app }) => {
  const sent = await app.page.evaluate(() =>
    [...performance.getEntriesByType('navigation'), ...performance.getEntriesByType('resource')].map((entry) => {
      const { name, encodedBodySize, decodedBodySize } = entry as PerformanceResourceTiming
      return { name: name.replace(/[?#].*/, ''), encodedBodySize, decodedBodySize }
    }),
  )
  const files = new Map(sent.filter(({ encodedBodySize }) => encodedBodySize > 0).map((file) => [file.name, file]))
  const names = [...files.keys()].join(' ')
  for (const part of [/index-[\w-]+\.js/, /start-thread-[\w-]+\.js/, /circle-voronoi-[\w-]+\.wasm/, /bronzefilter/]) {
    expect(names).toMatch(part)
  }
  const large = [...files.values()].filter(({ decodedBodySize }) => decodedBodySize >= 1000)
  for (const { name, encodedBodySize, decodedBodySize } of large) {
    expect(encodedBodySize, name).toBeLessThan(0.6 * decodedBodySize)
  }
  const bytes = [...files.values()].reduce((sum, { encodedBodySize }) => sum + encodedBodySize, 0)
  expect(bytes).toBeLessThan(MOST_BYTES)
})

test('on a slow line the first chapter can be read within a second, and its first figure lives within two and a half', async ({
  page,
}) => {
  const session = await page.context().newCDPSession(page)
  await session.send('Network.enable')
  /** For each file the length of the chain of files before it, itself included, and whether it blocks the text. */
  const files = new Map<string, { depth: number; holdsUp: boolean }>()
  session.on('Network.requestWillBeSent', ({ request: { url }, initiator, type }) => {
    const askers = [initiator.url ?? '', ...(initiator.stack?.callFrames ?? []).map((frame) => frame.url)]
    const before = type === 'Document' ? [0] : [1, ...askers.map((asker) => files.get(asker)?.depth ?? 1)]
    files.set(url, { depth: Math.max(...before) + 1, holdsUp: type === 'Document' || type === 'Stylesheet' })
  })
  await page.goto('/tutorial/01-nearest-circle.html')
  await page
    .locator('circle-voronoi')
    .first()
    .evaluate(async (element: HTMLElementTagNameMap['circle-voronoi']) => {
      element.scrollIntoView()
      await element.ready
      await element.updateComplete
    })
  /** The transfer time of some files on this connection, in milliseconds. */
  const timeOf = async (isNeeded: (file: { holdsUp: boolean }) => boolean) => {
    const needed = [...files].filter(([, file]) => isNeeded(file))
    const answers = await Promise.all(
      needed.map(([url]) => page.request.head(url, { headers: { 'accept-encoding': 'br' } })),
    )
    const bytes = answers.map((answer) => Number(answer.headers()['content-length']))
    const depth = Math.max(...needed.map(([, file]) => file.depth))
    return depth * SLOW_4G.latency + (1000 * bytes.reduce((sum, each) => sum + each, 0)) / SLOW_4G.throughput
  }
  const [readable, live] = [await timeOf(({ holdsUp }) => holdsUp), await timeOf(() => true)]
  expect(readable).toBeGreaterThan(2 * SLOW_4G.latency)
  expect(readable).toBeLessThan(READABLE)
  expect(live).toBeGreaterThan(readable)
  expect(live).toBeLessThan(LIVE)
})
