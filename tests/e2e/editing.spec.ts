// SPDX-License-Identifier: GPL-3.0-or-later
// Multiple selection, tools, steps and snapping by mouse, keys and fingers. The tests read the resulting circles from
// the address.
import type { Circle, Point } from '../../web/lib/index.ts'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { App, dataSet, expect, test } from './page.ts'

/** Discs in two rows, with 4 units between neighbors. */
const ROWS = Float64Array.from([0, 4, 8, 0, 4, 8].flatMap((x, k) => [x, k < 3 ? 0 : 4, 1]))

test.use({ link: await encodeLink({ circles: ROWS }) })

/** Returns the circles once they are saved in the address. */
async function circlesOf(app: App): Promise<Circle[]> {
  const { circles = [] } = await decodeLink(new URL(app.page.url()).hash)
  return Array.from({ length: circles.length / 3 }, (_, i) => {
    const [x, y, r] = circles.slice(3 * i, 3 * i + 3) as unknown as [number, number, number]
    return { x, y, r }
  })
}

const at = (app: App, x: number, y: number): Point => app.locate(ROWS, { x, y })
const group = (app: App) => app.page.getByRole('region', { name: 'Selected circles' })

async function click(app: App, x: number, y: number): Promise<void> {
  const point = at(app, x, y)
  await app.page.mouse.click(point.x, point.y)
}

/** Selects the lower row with a rubber band. */
async function selectRow(app: App): Promise<void> {
  await app.page.keyboard.down('Shift')
  await app.drag(at(app, -0.5, 1.7), at(app, 9, -0.4))
  await app.page.mouse.up()
  await app.page.keyboard.up('Shift')
  await expect(group(app)).toContainText('3 circles')
}

test('several are selected by Shift and by a rubber band, all and none by keys', async ({ app }) => {
  await click(app, 0, 0)
  await expect(app.inspector).toContainText('Circle 0')
  await app.page.keyboard.down('Shift')
  await click(app, 4, 4)
  await expect(group(app)).toContainText('2 circles')
  await expect(app.inspector).toBeHidden()
  await click(app, 0, 0)
  await expect(app.inspector).toContainText('Circle 4')
  await app.page.keyboard.up('Shift')
  await app.page.keyboard.press('Escape')
  await selectRow(app)
  await app.page.keyboard.press('Control+a')
  await expect(group(app)).toContainText('6 circles')
  await app.page.keyboard.press('Escape')
  await expect(group(app)).toBeHidden()
  // Escape during a rubber band selects nothing.
  await app.page.keyboard.down('Shift')
  await app.drag(at(app, -1, 2), at(app, 9, -1))
  await app.page.keyboard.press('Escape')
  await app.page.mouse.up()
  await app.page.keyboard.up('Shift')
  // The answer to Enter arrives after the answer to the band.
  await app.page.keyboard.press('Enter')
  await expect(app.inspector).toBeVisible()
  await expect(group(app)).toBeHidden()
})

test('several are moved together and back by one undo, and scaled by the handle and by keys; one by the handle', async ({
  app,
}) => {
  await test.step('several are moved', async () => {
    await selectRow(app)
    const { scale } = app.camera(ROWS)
    const from = at(app, 4, 0)
    await app.drag(from, { x: from.x, y: from.y + Math.round(scale) })
    await app.page.mouse.up()
    const moved = async () => (await circlesOf(app)).map(({ x, y }) => [x, Number(y.toFixed(1))])
    const y = expect.closeTo(-1, 1)
    await soon(moved).toEqual([
      [0, y],
      [4, y],
      [8, y],
      [0, 4],
      [4, 4],
      [8, 4],
    ])
    await app.page.keyboard.press('Control+z')
    await soon(moved).toEqual([
      [0, 0],
      [4, 0],
      [8, 0],
      [0, 4],
      [4, 4],
      [8, 4],
    ])
  })
  await test.step('several are scaled', async () => {
    await selectRow(app)
    const corner = at(app, 9, -1)
    const middle = at(app, 4, 0)
    // The handle is 7 pixels outside.
    const handle = { x: corner.x + 7, y: corner.y + 7 }
    await app.drag(handle, { x: middle.x + 1.1 * (handle.x - middle.x), y: middle.y + 1.1 * (handle.y - middle.y) })
    await app.page.mouse.up()
    const third = async () => (await circlesOf(app))[2]
    await soon(third).toEqual({ x: expect.closeTo(8.4, 1), y: 0, r: expect.closeTo(1.1, 1) })
    await app.page.keyboard.press('Control+z')
    await app.canvas.focus()
    await app.page.keyboard.press('+')
    await soon(third).toEqual({ x: expect.closeTo(4 + 4 * 1.04, 9), y: 0, r: expect.closeTo(1.04, 9) })
    await app.page.keyboard.press('Control+z')
    await app.page.keyboard.press('Escape')
    await soon(third).toEqual({ x: 8, y: 0, r: 1 })
  })
  await test.step('one is scaled', async () => {
    await click(app, 0, 4)
    await expect(app.inspector).toContainText('Circle 3')
    // The handle is 7 pixels outside of the rim.
    const rim = at(app, Math.SQRT1_2, 4 - Math.SQRT1_2)
    await app.drag({ x: rim.x + 7, y: rim.y + 7 }, { x: rim.x + 40, y: rim.y + 40 })
    await app.page.mouse.up()
    await soon(async () => (await circlesOf(app))[3]?.r).toBeGreaterThan(1.1)
  })
})

test('what is selected is duplicated, copied, cut and pasted, in another tab too, and deleted together', async ({
  app,
}) => {
  const context = app.page.context()
  await context.grantPermissions(['clipboard-read', 'clipboard-write'])
  await selectRow(app)
  await app.page.keyboard.press('Control+d')
  await expect(app.status).toContainText('9 circles')
  await expect(group(app)).toContainText('3 circles')
  await app.page.keyboard.press('Delete')
  await expect(app.status).toContainText('6 circles')
  await selectRow(app)
  await app.page.keyboard.press('Control+c')
  await app.page.keyboard.press('Control+v')
  await expect(app.status).toContainText('9 circles')
  await app.page.keyboard.press('Control+v')
  await expect(app.status).toContainText('12 circles')
  await app.page.keyboard.press('Control+x')
  await expect(app.status).toContainText('9 circles')

  const other = new App(await context.newPage())
  await other.open()
  await expect(other.status).toContainText('678 circles')
  await other.canvas.focus()
  await other.page.keyboard.press('Control+v')
  await expect(other.status).toContainText('681 circles')
  await expect(group(other)).toContainText('3 circles')
  // Other programs receive numbers.
  expect(await other.page.evaluate(() => navigator.clipboard.readText())).toMatch(/^(\S+\t\S+\t1\n){3}$/)
})

test('keys move by steps that fit the data, ten times with Shift, a tenth with Alt', async ({ app }) => {
  await click(app, 4, 0)
  await app.page.keyboard.press('ArrowRight')
  await app.page.keyboard.press('Shift+ArrowUp')
  await app.page.keyboard.press('Alt+ArrowUp')
  // 4 pixels are 0.037 units here.
  const { scale } = app.camera(ROWS)
  expect(4 / scale).toBeCloseTo(0.04, 2)
  await soon(async () => (await circlesOf(app))[1]).toEqual({ x: 4.05, y: 0.505, r: 1 })
  await app.page.keyboard.press('Control+a')
  await app.page.keyboard.press('ArrowLeft')
  await soon(async () => (await circlesOf(app)).map(({ x }) => x)).toEqual([-0.05, 4, 7.95, -0.05, 3.95, 7.95])
})

test('Control and an arrow key go to the neighbor on that side', async ({ app }) => {
  await click(app, 0, 0)
  await expect(app.inspector).toContainText('Circle 0')
  let last = 0
  for (const [key, id] of [
    ['ArrowRight', 1],
    ['ArrowUp', 4],
    ['ArrowRight', 5],
    ['ArrowDown', 2],
    ['ArrowLeft', 1],
  ] as const) {
    // The card shows the previous circle's neighbors until this circle is described, which is one of them.
    await soon(async () => {
      const neighbors = await app.neighbors()
      return neighbors.length > 0 && !neighbors.includes(String(last))
    }).toBe(true)
    await app.page.keyboard.press(`Control+${key}`)
    await expect(app.inspector).toContainText(`Circle ${id}`)
    last = id
  }
})

test('what is dragged snaps to neighbors and to the grid, with Alt or always', async ({ app }) => {
  await click(app, 0, 0)
  await expect(app.inspector).toContainText('Circle 0')
  const { scale } = app.camera(ROWS)
  const from = at(app, 0, 0)
  // The circle at (4, 0) is touched from (2, 0).
  const to = { x: from.x + 2 * scale - 5, y: from.y }
  await app.page.keyboard.down('Alt')
  await app.drag(from, to)
  await app.page.keyboard.up('Alt')
  await app.page.mouse.up()
  const place = async () => (await circlesOf(app))[0] as Circle
  await soon(async () => (await place()).x).toBeCloseTo(2, 12)
  await app.page.keyboard.press('Control+z')
  await soon(async () => (await place()).x).toBe(0)
  await app.page.keyboard.press('s')
  const near = at(app, -1, -1)
  await app.drag(at(app, 0, 0), { x: near.x + 3, y: near.y - 3 })
  await app.page.mouse.up()
  await soon(async () => (await place()).x).toBeLessThan(-0.8)
  // Grid lines are 0.1 apart.
  const { x, y } = await place()
  expect([x, y].map((value) => Number(value.toFixed(1)))).toEqual([x, y])
})

test('tools: pan moves no circle, Space and the middle button pan, keys choose', async ({ app }) => {
  const from = at(app, 4, 0)
  const view = async () => (await decodeLink(new URL(app.page.url()).hash)).view
  const expectPressed = (name: string) =>
    expect(app.page.getByRole('button', { name })).toHaveAttribute('aria-pressed', 'true')
  await app.canvas.focus()
  await app.page.keyboard.press('h')
  await expectPressed('Pan')
  await app.drag(from, { x: from.x + 50, y: from.y })
  await app.page.mouse.up()
  const { x: before, scale } = app.camera(ROWS)
  await soon(async () => (await view())?.x).toBeCloseTo(before - 50 / scale, 1)
  await app.page.keyboard.press('v')
  await expectPressed('Select and move')
  await app.page.mouse.move(from.x + 50, from.y)
  await app.page.mouse.down({ button: 'middle' })
  await app.page.mouse.move(from.x + 90, from.y, { steps: 3 })
  await app.page.mouse.up({ button: 'middle' })
  await soon(async () => (await view())?.x).toBeCloseTo(before - 90 / scale, 1)
  await app.canvas.focus()
  await app.page.keyboard.down('Space')
  await app.drag({ x: from.x + 90, y: from.y }, { x: from.x + 130, y: from.y })
  await app.page.mouse.up()
  await app.page.keyboard.up('Space')
  await soon(async () => (await view())?.x).toBeCloseTo(before - 130 / scale, 1)
  expect((await circlesOf(app)).map(({ x }) => x)).toEqual([0, 4, 8, 0, 4, 8])
  await expect(app.page.getByRole('button', { name: 'Undo' })).toBeDisabled()
})

test('help shows what pointer and keys do', async ({ app }) => {
  await app.canvas.focus()
  await app.page.keyboard.press('?')
  const help = app.page.getByRole('dialog')
  await expect(help).toContainText('Shift + click')
  await app.page.keyboard.press('Escape')
  await expect(help).toBeHidden()
  await app.page.getByRole('button', { name: 'Help' }).click()
  await help.getByRole('button', { name: 'Close' }).click()
  await expect(help).toBeHidden()
})

test('what is done is said once', async ({ app }) => {
  // The opened circles are announced first, once the page has been at rest.
  await expect(app.page.locator('#said')).not.toBeEmpty()
  await app.page.clock.install()
  await app.page.evaluate(() => {
    const said = document.querySelector('#said') as HTMLElement
    const texts: string[] = []
    const status = document.querySelector('#status') as HTMLElement
    const statuses: string[] = []
    Object.assign(window, { texts, statuses })
    new MutationObserver(() => texts.push(said.textContent ?? '')).observe(said, { childList: true })
    new MutationObserver(() => statuses.push(status.textContent ?? '')).observe(status, { childList: true })
  })
  const texts = () => app.page.evaluate(() => (window as unknown as { texts: string[] }).texts)
  await app.canvas.focus()
  await app.page.keyboard.press('Enter')
  await soon(texts).toEqual([expect.stringMatching(/^Circle \d\. (B|Unb)ounded cell, \d neighbors$/)])
  await app.page.keyboard.press('ArrowRight')
  await soon(texts).toEqual([expect.anything(), expect.stringMatching(/^Circle \d: x \S+, y \S+, r 1$/)])
  await app.page.keyboard.press('Delete')
  await soon(texts).toEqual([expect.anything(), expect.anything(), expect.stringMatching(/^Circle \d deleted$/)])
  // There are two edits; selections are none.
  const statuses = () => app.page.evaluate(() => (window as unknown as { statuses: string[] }).statuses)
  await soon(statuses).toHaveLength(2)
  // Runs all pending announcements.
  await app.page.clock.fastForward(5000)
  expect(await texts()).toHaveLength(3)
  expect(await statuses()).toHaveLength(2)
})

test.describe('with fingers', () => {
  test.use({ viewport: { width: 390, height: 780 }, hasTouch: true })

  test('one pans, or drags what is selected; a pinch edits nothing', async ({ app }) => {
    const session = await app.page.context().newCDPSession(app.page)
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...points: Point[]) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(({ x, y }, id) => ({ x, y, id })) })
    const swipe = async (from: Point, dx: number, dy: number) => {
      const moveTo = (share: number) => touch('touchMove', { x: from.x + share * dx, y: from.y + share * dy })
      // Sends both at once, because on a slow machine a resting finger would be a long press.
      await Promise.all([touch('touchStart', from), moveTo(0.3)])
      for (const share of [0.6, 1]) await moveTo(share)
      await touch('touchEnd')
    }
    const view = async () => (await decodeLink(new URL(app.page.url()).hash)).view
    const from = at(app, 4, 0)
    // Starts beside the circles, because large circles are dragged at once.
    await swipe(at(app, 2, 2), 0, -60)
    await soon(async () => (await view())?.y).toBeLessThan(1)
    expect((await circlesOf(app))[1]).toEqual({ x: 4, y: 0, r: 1 })

    await app.page.touchscreen.tap(from.x, from.y - 60)
    await expect(app.inspector).toContainText('Circle 1')
    await swipe({ x: from.x, y: from.y - 60 }, 0, -30)
    // More than two thirds of the drag are done.
    await soon(async () => (await circlesOf(app))[1]?.y).toBeGreaterThan(0.7)
    const moved = await circlesOf(app)

    const before = (await view())?.span
    // The first finger is on the selected circle.
    const place = { x: from.x, y: from.y - 90 }
    await touch('touchStart', place)
    await touch('touchMove', { x: place.x + 10, y: place.y })
    await touch('touchStart', { x: place.x + 10, y: place.y }, { x: place.x + 80, y: place.y })
    for (const x of [90, 110, 130])
      await touch('touchMove', { x: place.x - 10, y: place.y }, { x: place.x + x, y: place.y })
    await touch('touchEnd')
    await soon(async () => (await view())?.span).not.toBe(before)
    await soon(() => circlesOf(app)).toEqual(moved)
  })
})

test('a circle keeps its color where it is dragged, through undo, another scale of colors and the method', async ({
  app,
}) => {
  const { page } = app
  await app.choose('Eight circles')
  const circles = dataSet('start')
  const centers = Array.from({ length: circles.length / 3 }, (_, i) => app.center(circles, i))
  await app.painted()
  const known = await app.colors(centers)
  for (const i of [0, 3, 5]) {
    // To the middle between two others, where it has other neighbors.
    const [from, to] = [centers[i] as Point, centers[(i + 4) % 8] as Point]
    const there = { x: (from.x + 2 * to.x) / 3, y: (from.y + 2 * to.y) / 3 }
    await app.drag(from, there)
    await page.mouse.up()
    await app.painted()
    await soon(() => app.colors([there]), `circle ${i}`).toEqual([known[i]])
    await page.keyboard.press('Control+z')
    await app.painted()
    await soon(() => app.colors(centers), `after undo of circle ${i}`).toEqual(known)
  }
  await page.keyboard.press('Escape')
  const button = page.getByRole('button', { name: 'Step by step' })
  await button.click()
  await expect(page.getByRole('region', { name: 'The method, step by step' })).toBeVisible()
  await button.click()
  await app.painted()
  await soon(() => app.colors(centers), 'after the method').toEqual(known)
})
