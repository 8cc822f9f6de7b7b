// SPDX-License-Identifier: GPL-3.0-or-later
// The embedded page in foreign pages: its size, the messages in both directions, and the question of a link.
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { expect, type Frame, type Page, test } from '@playwright/test'
import { embedCode } from '../../web/app/files/saving.ts'
import type { FrameMessage } from '../../web/element/frame-types.ts'
import { encodeLink, type LinkInput } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'

const CIRCLES = [
  [0, 0, 2],
  [10, 0, 2],
  [5, 10, 2],
  [9, 6, 1],
  [5, 4, 0.5],
]
const QUESTION: LinkInput = {
  circles: CIRCLES,
  title: 'Three neighbors',
  question: 'Move the smallest circle until its cell has three edges.',
  check: { cell: 4, edges: 3 },
}
/** A solution: the smallest circle is where its cell has three edges. */
const SOLVED = [...CIRCLES.slice(0, 4), [9, 3, 0.5]]

/** Serves a page of another origin that records its messages, and opens it. */
async function openHost(page: Page, body: string): Promise<void> {
  const html = `<!doctype html><html lang="en"><meta name="viewport" content="width=device-width"><title>Host</title>
    <script>
      const told = []
      addEventListener('message', ({ data, source, origin }) => told.push({ data, origin, isFrame: source === frames[0] }))
    </script>
    ${body}</html>`
  const server = createServer((_, response) => response.setHeader('Content-Type', 'text/html').end(html))
  await new Promise<void>((resolve) => server.listen(0, resolve))
  page.once('close', () => server.close())
  await page.goto(`http://localhost:${(server.address() as AddressInfo).port}`)
}

const addressOf = async (baseURL: string | undefined, state: LinkInput) =>
  `${baseURL}/embed.html#${await encodeLink(state)}`
const lastOf = (page: Page) => page.evaluate(() => told.at(-1)?.data)
declare const told: readonly { readonly data: FrameMessage; readonly origin: string; readonly isFrame: boolean }[]
const framed = (page: Page) => page.frames()[1] as Frame
const ask = (page: Page, message: unknown) =>
  page.evaluate((message) => window.frames[0]?.postMessage(message, '*'), message)

test('the embed code is as wide as its place, in the proportion of a figure, also where styles are removed', async ({
  page,
  baseURL,
}) => {
  const code = embedCode(await addressOf(baseURL, { circles: CIRCLES }), 'Discs & "cells" <1>')
  await openHost(page, `<style>body { margin: 0 }</style><div id="styled">${code}</div><div id="plain">${code}</div>`)
  const [frame, plain] = [page.locator('#styled iframe'), page.locator('#plain iframe')]
  await expect(frame).toHaveAttribute('title', 'Discs & "cells" <1>')
  await expect(frame).toHaveAttribute('loading', 'lazy')
  // Some editors of learning platforms remove styles.
  await plain.evaluate((element) => element.removeAttribute('style'))
  for (const width of [1000, 390]) {
    await page.setViewportSize({ width, height: 800 })
    const box = await frame.boundingBox()
    expect(box?.width).toBe(width)
    expect(box?.height).toBeCloseTo((width * 2) / 3, 0)
    expect((await plain.boundingBox())?.width).toBeCloseTo(width + 4, -1)
  }
  await page.setViewportSize({ width: 1600, height: 600 })
  expect((await frame.boundingBox())?.height).toBeCloseTo(540, 0)
})

test('tells its parent the height at which everything is seen, whatever height it has', async ({ page, baseURL }) => {
  await openHost(
    page,
    `<iframe title="Frame" src="${await addressOf(baseURL, QUESTION)}" style="width: 100%; height: 100px; border: 0"></iframe>`,
  )
  const frame = page.locator('iframe')
  await soon(async () => (await lastOf(page))?.met).toBe(false)
  for (const width of [1000, 390]) {
    await page.setViewportSize({ width, height: 800 })
    const texts = framed(page).locator('#texts')
    const inner = width - 16
    await soon(async () => (await lastOf(page))?.height).toBe(
      Math.ceil(((await texts.boundingBox())?.height ?? 0) + (inner * 2) / 3),
    )
    // The height is stable once the frame has it.
    const height = (await lastOf(page))?.height as number
    await frame.evaluate((element, height) => {
      element.style.height = `${height}px`
    }, height)
    const figure = await framed(page).locator('circle-voronoi').boundingBox()
    expect((figure?.height as number) / (figure?.width as number)).toBeCloseTo(2 / 3, 1)
    expect((await lastOf(page))?.height).toBe(height)
    expect(await framed(page).evaluate(() => document.querySelector('main')?.scrollHeight)).toBe(height)
  }
  // All circles are still visible.
  expect((await lastOf(page))?.state?.view).toBeUndefined()
  const all = await page.evaluate(() => told.map(({ origin, isFrame, data }) => [origin, isFrame, data.type]))
  for (const each of all) expect(each).toEqual([baseURL, true, 'circle-voronoi'])
})

test('tells its circles, whether they meet the check, and the answer, as they change', async ({ page, baseURL }) => {
  await openHost(
    page,
    `<iframe title="Frame" src="${await addressOf(baseURL, QUESTION)}" width="600" height="400"></iframe>`,
  )
  await soon(async () => (await lastOf(page))?.met).toBe(false)
  expect((await lastOf(page))?.state?.circles).toEqual(CIRCLES)
  const frame = framed(page)
  await expect(frame.getByText('Move the smallest circle until its cell has three edges.')).toBeVisible()
  await expect(frame.getByRole('heading', { name: 'Three neighbors' })).toBeVisible()
  await expect(frame.getByRole('status')).toHaveText('Not solved yet')
  await expect(frame.getByRole('button', { name: 'Start over' })).toBeHidden()
  await frame.evaluate((circles) => {
    const figure = document.querySelector('circle-voronoi') as HTMLElementTagNameMap['circle-voronoi']
    figure.circles = circles
  }, SOLVED)
  await soon(async () => (await lastOf(page))?.met).toBe(true)
  const { state, answer, error } = (await lastOf(page)) as FrameMessage
  expect(state?.circles).toEqual(SOLVED)
  expect(JSON.parse(answer)).toEqual({ circles: SOLVED, check: true })
  expect(error).toBeUndefined()
  // Each message pairs the circles with the check of the same moment.
  const pairs = await page.evaluate(() => told.map(({ data }) => [data.state?.circles[4]?.[0], data.met]))
  for (const [x, met] of pairs) expect(met, String(pairs)).toBe(x === undefined ? undefined : x === 9)
  await expect(frame.getByRole('status')).toHaveText('Solved')
  await frame.getByRole('button', { name: 'Start over' }).click()
  await soon(async () => (await lastOf(page))?.met).toBe(false)
  expect((await lastOf(page))?.state?.circles).toEqual(CIRCLES)
  await expect(frame.getByRole('button', { name: 'Start over' })).toBeHidden()
})

test('takes a state or a link from its parent alone, and says what is wrong with others', async ({ page, baseURL }) => {
  const address = await addressOf(baseURL, { circles: CIRCLES })
  await openHost(page, `<iframe title="Frame" src="${address}" width="600" height="400"></iframe>`)
  const circles = async () => (await lastOf(page))?.state?.circles
  await soon(circles).toEqual(CIRCLES)
  expect((await lastOf(page))?.met).toBeUndefined()
  await ask(page, { type: 'circle-voronoi', state: { circles: SOLVED } })
  await soon(circles).toEqual(SOLVED)
  // A partial state changes only its parts.
  await ask(page, { type: 'circle-voronoi', state: { check: { cell: 4, edges: 3 }, layers: { hull: true } } })
  await soon(async () => (await lastOf(page))?.met).toBe(true)
  expect((await lastOf(page))?.state).toMatchObject({ circles: SOLVED, layers: { hull: true } })
  await ask(page, { type: 'circle-voronoi', state: address })
  await soon(circles).toEqual(CIRCLES)
  for (const [state, reason] of [
    [{ circles: [[0, 0, -1]] }, 'circle 0 has a negative radius'],
    [{ view: 5 }, 'the view is invalid'],
    ['v1.AAAA', 'a part of it is missing or wrong'],
    [7, 'The state of a link must be an object, not 7.'],
    [{ check: { cell: 9, edges: 3 } }, 'circle 9'],
  ] as const) {
    await ask(page, { type: 'circle-voronoi', state })
    await soon(async () => (await lastOf(page))?.error).toContain(reason)
    expect(await circles()).toEqual(CIRCLES)
  }
  // A request without a state returns the current state.
  const count = await page.evaluate(() => told.length)
  await ask(page, { type: 'circle-voronoi' })
  await soon(() => page.evaluate(() => told.length)).toBe(count + 1)
  // Invalid requests, and requests from other windows, are ignored.
  for (const data of [null, 'circle-voronoi', { state: { circles: SOLVED } }]) await ask(page, data)
  await framed(page).evaluate((circles) => {
    window.postMessage({ type: 'circle-voronoi', state: { circles } }, '*')
  }, SOLVED)
  await ask(page, { type: 'circle-voronoi' })
  await soon(() => page.evaluate(() => told.length)).toBe(count + 2)
  expect(await circles()).toEqual(CIRCLES)
})

test('asks a question in German, with a name for screen readers, of readers who may only look', async ({ page }) => {
  const link = await encodeLink({
    ...QUESTION,
    title: 'Drei Nachbarn',
    question: 'Wie viele Kanten hat die Zelle?',
    readonly: true,
    alt: 'Fünf Kreise',
    lang: 'de',
  })
  await page.goto(`/embed.html#${link}`)
  await expect(page.locator('html')).toHaveAttribute('lang', 'de')
  await expect(page).toHaveTitle('Drei Nachbarn')
  await expect(page.getByRole('status')).toHaveText('Noch nicht gelöst')
  await expect(page.getByRole('application', { name: 'Fünf Kreise' })).toBeVisible()
  await expect(page.getByRole('button', { name: 'Verkleinern' })).toBeVisible()
  await expect(page.getByRole('button', { name: 'Kreis hinzufügen' })).toHaveCount(0)
  // The next link of the same page has no question.
  const plain = await encodeLink({ circles: CIRCLES })
  await page.evaluate((link) => {
    location.hash = link
  }, plain)
  await expect(page.getByRole('button', { name: 'Add a circle' })).toBeVisible()
  await expect(page).toHaveTitle('Voronoi diagram of circles')
  await expect(page.getByRole('status')).toBeHidden()
  await expect(page.getByRole('link', { name: 'Open' })).toBeVisible()
})

test('the host script of the example sizes its frame and submits the answer', async ({ page }) => {
  await page.goto('/examples/element/question-frame/')
  const frame = page.locator('iframe')
  const height = async () => (await frame.boundingBox())?.height
  const width = ((await frame.boundingBox())?.width ?? 0) as number
  await soon(height).toBeGreaterThan((width * 2) / 3 + 20)
  const submit = page.getByRole('button', { name: 'Submit' })
  await expect(submit).toBeDisabled()
  await page.evaluate((circles) => {
    window.frames[0]?.postMessage({ type: 'circle-voronoi', state: { circles, check: { cell: 4, edges: 3 } } }, '*')
  }, SOLVED)
  await expect(submit).toBeEnabled()
  await submit.click()
  await expect(page).toHaveURL(/\?answer=/)
  const answer = new URL(page.url()).searchParams.get('answer') as string
  expect(JSON.parse(answer)).toEqual({ circles: SOLVED, check: true })
})
