// SPDX-License-Identifier: GPL-3.0-or-later
// Fingers on a phone.
import type { Point } from '../../web/lib/index.ts'
import { encodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { framesOf } from './frames.ts'
import { App, dataSet, expect, test } from './page.ts'

const START = dataSet('start')
const START_LINK = await encodeLink({ dataSet: 'start' })

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true })

/** Sends the events of fingers. */
async function fingersOn(app: App) {
  const session = await app.page.context().newCDPSession(app.page)
  return (type: 'touchStart' | 'touchMove' | 'touchEnd', ...points: Point[]) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(({ x, y }, id) => ({ x, y, id })) })
}

test('each circle of the first scene is dragged, also by a finger beside it', async ({ page }) => {
  const app = new App(page)
  await app.open(START_LINK)
  const touch = await fingersOn(app)
  let circles: Float64Array = START
  const camera = app.camera(START)
  for (let i = 0; i < START.length / 3; i++) {
    const center = app.center(START, i)
    const r = (START[3 * i + 2] as number) * camera.scale
    // A finger covers 44 pixels.
    const from = { x: center.x, y: center.y - Math.max(r + 6, 18) }
    await Promise.all([touch('touchStart', from), touch('touchMove', { x: from.x, y: from.y - 8 })])
    await touch('touchMove', { x: from.x, y: from.y - 16 })
    await touch('touchEnd')
    await soon(async () => (await app.circles())[3 * i + 1] as number, `circle ${i}`).toBeGreaterThan(
      (START[3 * i + 1] as number) + 8 / camera.scale,
    )
    const moved = await app.circles()
    for (let k = 0; k < circles.length; k++)
      if (Math.floor(k / 3) !== i) expect(moved[k], `circle ${i}`).toBe(circles[k])
    circles = moved
  }
})

test('a swipe to the right on a panel does not go back to the page before', async ({ page }) => {
  const app = new App(page)
  await app.open(START_LINK)
  await app.openPanel('Layers')
  const { x, y, width } = (await page.locator('#layers').boundingBox()) as { x: number; y: number; width: number }
  const touch = await fingersOn(app)
  await touch('touchStart', { x: x + 40, y: y + 80 })
  await touch('touchMove', { x: x + width / 2, y: y + 85 })
  await touch('touchMove', { x: x + width - 10, y: y + 90 })
  await touch('touchEnd')
  // The browser goes back after its own animation, and another page would not have the panel.
  await framesOf(page, 60)
  await expect(page.locator('#layers')).toBeVisible()
})

test('the card is one line while a circle is dragged, and opens by a tap', async ({ page }) => {
  const app = new App(page)
  await app.open(START_LINK)
  const touch = await fingersOn(app)
  const at = app.center(START, 0)
  await Promise.all([touch('touchStart', at), touch('touchMove', { x: at.x + 8, y: at.y })])
  await touch('touchMove', { x: at.x + 16, y: at.y })
  await expect(app.inspector).toBeVisible()
  await expect(app.inspector.getByText(/^x 0\.\d+ {2}y 0 {2}r 1\.9$/)).toBeVisible()
  await expect(app.field('x')).toBeHidden()
  expect((await app.inspector.boundingBox())?.height).toBeLessThan(64)
  await touch('touchEnd')
  await expect(app.field('x')).toBeHidden()
  await app.inspector.getByRole('heading').tap()
  await expect(app.field('x')).toBeVisible()
  await app.inspector.getByRole('button', { name: 'Deselect' }).tap()
  await page.touchscreen.tap(at.x + 16, at.y)
  await expect(app.field('x')).toBeVisible()
})

test('a long press and taps select several circles, which are dragged together', async ({ page }) => {
  const app = new App(page)
  await app.open(START_LINK)
  const touch = await fingersOn(app)
  await page.clock.install()
  const press = async (i: number) => {
    await touch('touchStart', app.center(START, i))
    await page.clock.fastForward(700)
    await soon(async () => {
      await page.clock.fastForward(50)
      return page.locator('#inspector:not([hidden]), #group:not([hidden])').count()
    }).toBe(1)
  }
  await press(1)
  await touch('touchEnd')
  await touch('touchStart', app.center(START, 3))
  await page.clock.fastForward(700)
  const group = page.getByRole('region', { name: 'Selected circles' })
  await soon(async () => {
    await page.clock.fastForward(50)
    return group.textContent()
  }).toContain('2 circles')
  await touch('touchEnd')
  await page.touchscreen.tap(app.center(START, 6).x, app.center(START, 6).y)
  await soon(async () => {
    await page.clock.fastForward(50)
    return group.textContent()
  }).toContain('3 circles')
  const from = app.center(START, 1)
  await Promise.all([touch('touchStart', from), touch('touchMove', { x: from.x + 8, y: from.y })])
  await touch('touchMove', { x: from.x + 16, y: from.y })
  await touch('touchEnd')
  await soon(async () => {
    await page.clock.fastForward(500)
    const circles = await app.circles()
    return [0, 1, 2, 3, 4, 5, 6, 7].filter((i) => circles[3 * i] !== START[3 * i])
  }).toEqual([1, 3, 6])
})

test('the tray of tools has a caption below each icon, and title and tutorial are in sight', async ({ page }) => {
  const app = new App(page)
  await app.open(START_LINK)
  for (const name of [page.getByRole('link', { name: 'Tutorial' }), page.getByRole('heading', { level: 1 })])
    await expect(name).toBeInViewport({ ratio: 1 })
  await page.getByRole('button', { name: 'More tools' }).tap()
  const tools = page.locator('#more-tools button')
  for (const tool of await tools.all()) {
    const caption = tool.locator('.caption')
    await expect(caption).toBeInViewport({ ratio: 1 })
    await expect(caption).toHaveText((await tool.getAttribute('aria-label')) as string)
  }
})

for (const [width, height] of [
  [844, 390],
  [360, 740],
] as const) {
  test(`the number of the step is whole in the player: ${width} x ${height}`, async ({ page }) => {
    await page.setViewportSize({ width, height })
    const app = new App(page)
    await app.open(START_LINK)
    await app.openPanel('Step by step')
    const count = page.getByRole('region', { name: 'The method, step by step' }).locator('.where')
    await expect(count).toHaveText(/^0 \/ \d+$/)
    await expect(count).toBeInViewport({ ratio: 1 })
    expect(await count.evaluate((element) => element.getClientRects().length)).toBe(1)
    expect(await count.evaluate(({ scrollWidth, clientWidth }) => scrollWidth <= clientWidth + 1)).toBe(true)
  })
}

test('the method shows all circles beside its panel, also after an edit', async ({ page }) => {
  const app = new App(page)
  await app.open(START_LINK)
  await page.touchscreen.tap(app.center(START, 0).x, app.center(START, 0).y)
  await app.inspector.getByRole('button', { name: 'Duplicate' }).tap()
  await expect(app.status).toContainText('9 circles')
  await page.getByRole('button', { name: 'More tools' }).tap()
  await page.getByRole('button', { name: 'Step by step' }).tap()
  const player = page.getByRole('region', { name: 'The method, step by step' })
  await expect(player).toBeVisible()
  await expect(app.inspector).toBeHidden()
  expect((await player.boundingBox())?.y).toBeGreaterThan(0.4 * 844)
})

test('a link is sent with another program, where the system offers that', async ({ page }) => {
  await page.addInitScript(() => {
    const sent: ShareData[] = []
    Object.assign(globalThis, { sent })
    Object.assign(Navigator.prototype, {
      share: async (data: ShareData) => {
        sent.push(data)
        if (sent.length === 2) throw new DOMException('', 'AbortError')
        if (sent.length === 3) throw new DOMException('Not now.', 'NotAllowedError')
      },
    })
  })
  const app = new App(page)
  await app.open(START_LINK)
  await page.getByRole('button', { name: 'Share', exact: true }).tap()
  const send = page.getByRole('button', { name: 'Send' })
  await send.tap()
  const sent = () => page.evaluate(() => (globalThis as unknown as { sent: ShareData[] }).sent)
  await soon(sent).toEqual([{ title: expect.stringContaining('Voronoi'), url: expect.stringMatching(/#v1\.\w+/) }])
  // The user closes the dialog.
  await send.tap()
  await soon(sent).toHaveLength(2)
  await expect(page.getByRole('alert')).toBeHidden()
  await send.tap()
  await expect(page.getByRole('alert')).toContainText('Not now.')
})

for (const [width, size] of [
  [390, 16],
  [320, 16],
  [320, 32],
] as const) {
  test(`the row above has the data set and sharing, whole: ${width} px, letters of ${size} px`, async ({ page }) => {
    await page.setViewportSize({ width, height: 700 })
    await page.addInitScript((size) => {
      addEventListener('DOMContentLoaded', () => {
        document.documentElement.style.fontSize = `${size}px`
      })
    }, size)
    const app = new App(page)
    await app.open(START_LINK)
    const boxes = []
    for (const control of [page.getByLabel('Data set'), page.getByRole('button', { name: 'Share', exact: true })]) {
      const box = (await control.boundingBox()) as { x: number; y: number; width: number; height: number }
      expect(box.x).toBeGreaterThanOrEqual(0)
      expect(box.x + box.width).toBeLessThanOrEqual(width)
      expect(await control.evaluate((element) => element.scrollWidth <= element.clientWidth + 1)).toBe(true)
      boxes.push(box)
    }
    const [set, share] = boxes
    expect(Math.abs((set?.y ?? 0) + (set?.height ?? 0) / 2 - (share?.y ?? 0) - (share?.height ?? 0) / 2)).toBeLessThan(
      4,
    )
  })
}
