// SPDX-License-Identifier: GPL-3.0-or-later
// The course package, unpacked into a page with a stub of the SCORM 1.2 interface of learning management systems.
import { readFileSync } from 'node:fs'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import type { Page } from '@playwright/test'
import { strFromU8, unzipSync } from 'fflate'
import { encodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { framesOf } from './frames.ts'
import { expect, test } from './page.ts'

const CIRCLES = Float64Array.of(0, 0, 2, 10, 0, 2, 5, 10, 2, 9, 6, 1, 5, 4, 0.5)
const TYPES: Readonly<Record<string, string>> = { html: 'text/html', js: 'text/javascript', xml: 'text/xml' }
/** The page of a learning management system with the package in a frame. It keeps values while it is open. */
const SYSTEM = `<!doctype html><html lang="en"><title>Course</title><script>
  const values = { 'cmi.core.lesson_status': 'not attempted' }, calls = []
  const call = (name) => (calls.push(name), 'true')
  var API = {
    LMSInitialize: () => call('initialize'),
    LMSGetValue: (name) => values[name] ?? '',
    LMSSetValue: (name, value) => ((values[name] = value), call(name)),
    LMSCommit: () => call('commit'),
    LMSFinish: () => call('finish'),
  }
</script><iframe title="Lesson" src="lesson/index.html" width="700" height="520"></iframe></html>`

test.use({
  link: await encodeLink({
    circles: CIRCLES,
    question: 'Give the smallest circle three edges.',
    title: 'Three & more',
    check: { cell: 4, edges: 3 },
  }),
})

test('reports "passed" to the system once the check is met, and goes on where it was', async ({ app, page }) => {
  await page.getByRole('button', { name: 'Share', exact: true }).click()
  const [saved] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'SCORM file' }).click(),
  ])
  expect(saved.suggestedFilename()).toBe('question-scorm.zip')
  const files = unzipSync(readFileSync(await saved.path()))
  expect(Object.keys(files).sort()).toEqual(['course.js', 'element.js', 'imsmanifest.xml', 'index.html'])
  const manifest = strFromU8(files['imsmanifest.xml'] as Uint8Array)
  const about = await page.evaluate((text) => {
    const xml = new DOMParser().parseFromString(text, 'text/xml')
    const resource = xml.querySelector('resource')
    return {
      version: xml.querySelector('schemaversion')?.textContent,
      title: xml.querySelector('item > title')?.textContent,
      type: resource?.getAttributeNS('http://www.adlnet.org/xsd/adlcp_rootv1p2', 'scormtype'),
      files: Array.from(resource?.querySelectorAll('file') ?? [], (file) => file.getAttribute('href')),
      start: resource?.getAttribute('href'),
    }
  }, manifest)
  expect(about).toEqual({
    version: '1.2',
    title: 'Three & more',
    type: 'sco',
    files: ['index.html', 'element.js', 'course.js'],
    start: 'index.html',
  })
  await app.page.close()

  const server = createServer(({ url = '/' }, response) => {
    const file = files[url.replace('/lesson/', '')]
    const type = TYPES[url.split('.').at(-1) as string] ?? 'text/html'
    response.setHeader('Content-Type', type).end(file ?? SYSTEM)
  })
  await new Promise<void>((resolve) => server.listen(0, resolve))
  const other = await app.page.context().newPage()
  const problems: string[] = []
  other.on('pageerror', ({ message }) => problems.push(message))
  other.on('console', (message) => message.type() === 'error' && problems.push(message.text()))
  await other.goto(`http://localhost:${(server.address() as AddressInfo).port}/`)
  const lesson = other.frameLocator('iframe')
  await expect(lesson.getByText('Give the smallest circle three edges.')).toBeVisible()
  await expect(lesson.getByRole('status')).toHaveText('Not solved yet')
  await soon(() => circlesOf(other)).toBe(CIRCLES.length)
  const value = (name: string) => other.evaluate((name) => (values as Record<string, string>)[name], name)
  expect(await value('cmi.core.lesson_status')).toBe('incomplete')
  await lesson.locator('circle-voronoi').evaluate((figure: HTMLElementTagNameMap['circle-voronoi']) => {
    figure.circles = [
      [0, 0, 2],
      [10, 0, 2],
      [5, 10, 2],
      [9, 6, 1],
      [9, 3, 0.5],
    ]
  })
  await expect(lesson.getByRole('status')).toHaveText('Solved')
  await soon(() => value('cmi.core.lesson_status')).toBe('passed')
  expect(await value('cmi.core.score.raw')).toBe('100')
  // Opens another lesson, then this one again.
  const frame = other.locator('iframe')
  const openAgain = async (finished: number) => {
    await frame.evaluate((element: HTMLIFrameElement) => {
      element.src = 'about:blank'
    })
    await soon(() => other.evaluate(() => calls.filter((name) => name === 'finish').length)).toBe(finished)
    await frame.evaluate((element: HTMLIFrameElement) => {
      element.src = 'lesson/index.html'
    })
  }
  await openAgain(1)
  expect(await value('cmi.core.session_time')).toMatch(/^\d{4}:\d\d:\d\d\.\d\d$/)
  await expect(lesson.getByRole('status')).toHaveText('Solved')
  await lesson.getByRole('button', { name: 'Start over' }).click()
  await expect(lesson.getByRole('status')).toHaveText('Not solved yet')
  expect(await value('cmi.core.lesson_status')).toBe('passed')
  // Data that another program has left in the system are ignored.
  await other.evaluate(() => Object.defineProperty(values, 'cmi.suspend_data', { value: 'v9.none', writable: false }))
  await openAgain(2)
  await expect(lesson.getByRole('status')).toHaveText('Not solved yet')
  await lesson.locator('circle-voronoi').evaluate((figure: HTMLElementTagNameMap['circle-voronoi']) => figure.toSVG())
  await framesOf(other, 2)
  expect(problems).toEqual([])
  server.close()
})

declare const values: Readonly<Record<string, string>>
declare const calls: readonly string[]

const circlesOf = (page: Page) =>
  page
    .frameLocator('iframe')
    .locator('circle-voronoi')
    .evaluate((figure: HTMLElementTagNameMap['circle-voronoi']) => figure.circles.length)
