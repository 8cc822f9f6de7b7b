// SPDX-License-Identifier: GPL-3.0-or-later
// Circles that repeat in a box: by a link, by the panel, with images, dragged through the sides of the box.
import { readFileSync } from 'node:fs'
import type { Lattice, Point } from '../../web/lib/index.ts'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { fitted, toScreen } from '../../web/view/camera.ts'
import { boxOf } from '../../web/view/domain.ts'
import { soon } from '../soon.ts'
import { violationsInBoth } from './accessibility.ts'
import { type App, expect, test } from './page.ts'

const LATTICE: Lattice = { a: [8, 0], b: [2, 6] }
const CIRCLES: [number, number, number][] = [
  [2, 1, 0.8],
  [6, 1.5, 0.6],
  [5, 4, 1],
  [8.4, 4.6, 0.5],
]
const PAPER = [250, 248, 244]

const LINK = await encodeLink({ circles: CIRCLES, lattice: LATTICE })
const PLAIN = await encodeLink({ circles: CIRCLES })
const FAR = await encodeLink({ circles: CIRCLES.map(([x, y, r]) => [x - 50, y + 700, r] as const) })

function place(app: App, x: number, y: number, lattice = LATTICE): Point {
  const size = app.page.viewportSize() as { width: number; height: number }
  const box = boxOf({ minX: 0, minY: 0, maxX: 1, maxY: 1 }, { region: undefined, areas: undefined, lattice })
  return toScreen(fitted(box, size, app.padding), size, { x, y })
}

async function colorAt(app: App, x: number, y: number): Promise<number[]> {
  await app.painted()
  return (await app.colors([place(app, x, y)]))[0] as number[]
}

/** The distance of a color from the color of the paper. */
const strengthOf = (color: readonly number[]) =>
  color.reduce((sum, value, k) => sum + Math.abs(value - (PAPER[k] as number)), 0)

const latticeOf = async (app: App) => (await decodeLink(new URL(app.page.url()).hash).catch(() => undefined))?.lattice
const panel = (app: App) => app.page.getByRole('region', { name: 'Region', exact: true })
const box = (app: App) => panel(app).getByRole('checkbox', { name: 'Repeat the circles in a box' })
const period = (app: App, name: string) => panel(app).getByRole('spinbutton', { name: `Period ${name}` })

test.describe('a link with a lattice', () => {
  test.use({ link: LINK })

  test('shows the box with dimmed images around it', async ({ app }) => {
    await expect(app.status).toContainText('4 circles')
    await expect(app.status).toContainText('12 edges')
    const own = await colorAt(app, 2, 1)
    const image = await colorAt(app, 8.4 - 8, 4.6)
    const inside = await colorAt(app, 8.4, 4.6)
    expect(strengthOf(inside)).toBeGreaterThan(strengthOf(image) * 1.5)
    expect(strengthOf(image)).toBeGreaterThan(20)
    expect(strengthOf(own)).toBeGreaterThan(60)
  })

  test('a circle that is dragged out comes in on the other side, and the link keeps the box', async ({ app }) => {
    await app.drag(place(app, 2, 1), place(app, 0.5, -0.5))
    await app.page.mouse.up()
    await expect(async () => {
      const [x, y] = await app.circles()
      expect(x).toBeCloseTo(0.5 + 2, 1)
      expect(y).toBeCloseTo(-0.5 + 6, 1)
    }).toPass()
    expect(await latticeOf(app)).toEqual(LATTICE)
    // The disc is drawn on the side where the circle came in.
    expect(strengthOf(await colorAt(app, 2.5, 5.5))).toBeGreaterThan(60)
    await app.page.keyboard.press('ControlOrMeta+z')
    await expect(async () => expect((await app.circles())[0]).toBeCloseTo(2, 9)).toPass()
  })

  test('an image stands for its circle', async ({ app }) => {
    const { x, y } = place(app, 8.4 - 8, 4.6)
    await app.page.mouse.click(x, y)
    await expect(app.inspector.getByRole('heading')).toHaveText('Circle 3')
    const neighbors = await app.neighbors()
    expect(new Set(neighbors).size).toBe(neighbors.length)
  })

  test('a drawing that is saved has the box, and opens with it', async ({ app }) => {
    await app.openPanel('Files')
    const download = app.page.waitForEvent('download')
    await app.page.locator('#files').getByRole('button', { name: 'SVG', exact: true }).click()
    const buffer = readFileSync(await (await download).path())
    await app.choose('Introduction')
    await app.page.getByLabel('Open …').setInputFiles({ name: 'box.svg', mimeType: 'image/svg+xml', buffer })
    await expect(app.status).toContainText('12 edges')
    await soon(() => latticeOf(app)).toEqual(LATTICE)
  })
})

test.describe('a saved file of cells', () => {
  test.use({ link: LINK })

  test('has whole cells, which sum to the area of the box', async ({ app }) => {
    await app.openPanel('Files')
    const download = app.page.waitForEvent('download')
    await app.page.locator('#files').getByRole('button', { name: 'Cells', exact: true }).click()
    const { features } = JSON.parse(readFileSync(await (await download).path(), 'utf8'))
    const areas = features.map(({ properties }: { properties: { area: number } }) => properties.area)
    expect(areas).toHaveLength(4)
    expect(areas.reduce((sum: number, area: number) => sum + area, 0)).toBeCloseTo(48, 9)
    expect(features[0].properties.shifts).toHaveLength(features[0].properties.neighbors.length)
    await expect(app.page.getByText('The cells are whole, also where they cross the box.')).toBeVisible()
  })
})

test.describe('with a finger', () => {
  test.use({ link: LINK, hasTouch: true, viewport: { width: 390, height: 844 } })

  test('a circle that is dragged out comes in on the other side', async ({ app }) => {
    const session = await app.page.context().newCDPSession(app.page)
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: readonly Point[]) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(({ x, y }) => ({ x, y })) })
    const [from, to] = [place(app, 5, 4), place(app, 5, 7)]
    // A finger moves a circle once it is selected.
    await app.page.touchscreen.tap(from.x, from.y)
    await expect(app.inspector).toContainText('Circle 2')
    await touch('touchStart', [from])
    for (const t of [0.25, 0.5, 0.75, 1]) {
      await touch('touchMove', [{ x: from.x + t * (to.x - from.x), y: from.y + t * (to.y - from.y) }])
    }
    await touch('touchEnd', [])
    await expect(async () => {
      const circles = await app.circles()
      expect(circles[6]).toBeCloseTo(5 - 2, 1)
      expect(circles[7]).toBeCloseTo(7 - 6, 1)
    }).toPass()
  })
})

test.describe('the panel', () => {
  test.use({ link: PLAIN })

  test('switches a box around the circles on and off, each with undo', async ({ app }) => {
    const before = await app.circles()
    await app.openPanel('Region')
    await expect(period(app, 'a, x')).toHaveCount(0)
    await box(app).check()
    await expect(app.status).toContainText('12 edges')
    // From 1.2 to 8.9 and from 0.2 to 5.1, with room, in two digits: the circles stay where they are.
    await expect(period(app, 'a, x')).toHaveValue('11')
    await expect(period(app, 'a, y')).toHaveValue('0')
    await expect(period(app, 'b, x')).toHaveValue('0')
    await expect(period(app, 'b, y')).toHaveValue('5.5')
    await soon(() => latticeOf(app)).toEqual({ a: [11, 0], b: [0, 5.5] })
    expect(await app.circles()).toEqual(before)
    await box(app).uncheck()
    await expect(app.status).not.toContainText('12 edges')
    await soon(() => latticeOf(app)).toBeUndefined()
    await app.canvas.focus()
    await app.page.keyboard.press('ControlOrMeta+z')
    await expect(box(app)).toBeChecked()
    await app.page.keyboard.press('ControlOrMeta+z')
    await expect(box(app)).not.toBeChecked()
    await app.page.keyboard.press('ControlOrMeta+Shift+z')
    await expect(period(app, 'b, y')).toHaveValue('5.5')
    await app.page.reload()
    await expect(app.status).toContainText('12 edges')
    await expect(box(app)).toBeChecked()
  })

  test('edits the periods, wraps the circles, and refuses parallel ones', async ({ app }) => {
    await app.openPanel('Region')
    await box(app).check()
    await expect(period(app, 'b, x')).toHaveValue('0')
    await period(app, 'b, x').fill('2')
    await period(app, 'b, x').press('Enter')
    await soon(() => latticeOf(app)).toEqual({ a: [11, 0], b: [2, 5.5] })
    await period(app, 'a, x').fill('5')
    await period(app, 'a, x').press('Enter')
    await soon(() => latticeOf(app)).toEqual({ a: [5, 0], b: [2, 5.5] })
    // 6 is beyond the box there.
    await expect(async () => expect((await app.circles())[3]).toBeCloseTo(1, 9)).toPass()
    await expect(app.status).toContainText('4 circles')
    await period(app, 'b, y').fill('0')
    await period(app, 'b, y').press('Enter')
    await expect(app.page.getByText('The periods must not be zero or parallel')).toBeVisible()
    await expect(period(app, 'b, y')).toHaveValue('5.5')
    expect(await latticeOf(app)).toEqual({ a: [5, 0], b: [2, 5.5] })
    await app.canvas.focus()
    await app.page.keyboard.press('ControlOrMeta+z')
    await expect(async () => expect((await app.circles())[3]).toBeCloseTo(6, 9)).toPass()
  })

  test('a drawn region takes the place of the box, and a box that of a region', async ({ app }) => {
    await app.openPanel('Region')
    await box(app).check()
    await expect(box(app)).toBeChecked()
    await panel(app).getByRole('button', { name: 'Draw' }).click()
    for (const [x, y] of [
      [0, 0],
      [9, 0],
      [5, 6],
    ] as const) {
      const { x: left, y: top } = place(app, x, y, { a: [11, 0], b: [0, 5.5] })
      await app.page.mouse.click(left, top)
    }
    await panel(app).getByRole('button', { name: 'Close polygon' }).click()
    await expect(panel(app).getByText('One outline with 3 sides')).toBeVisible()
    await expect(box(app)).not.toBeChecked()
    await soon(() => latticeOf(app)).toBeUndefined()
    await panel(app).getByLabel('Areas', { exact: true }).selectOption('equal')
    await expect(panel(app).getByText('Drag a point')).toBeVisible()
    await box(app).check()
    await expect(panel(app).getByRole('button', { name: 'Remove region' })).toHaveCount(0)
    await expect(async () => {
      const radii = (await app.circles()).filter((_, k) => k % 3 === 2)
      expect([...radii]).toEqual([0.8, 0.6, 1, 0.5])
    }).toPass()
    await app.canvas.focus()
    await app.page.keyboard.press('ControlOrMeta+z')
    await expect(panel(app).getByText('Drag a point')).toBeVisible()
  })

  test('can be read by everyone', async ({ app }) => {
    await app.openPanel('Region')
    await box(app).check()
    await expect(period(app, 'a, x')).toBeVisible()
    expect(await violationsInBoth(app.page)).toEqual([])
  })
})

test.describe('circles away from the origin', () => {
  test.use({ link: FAR })

  test('move into the box, all alike, and back by undo, always in view', async ({ app }) => {
    const before = await app.circles()
    await app.openPanel('Region')
    await box(app).check()
    await expect(period(app, 'a, x')).toHaveValue('8.5')
    await expect(async () => {
      const after = await app.circles()
      const [dx, dy] = [0, 1].map((k) => (after[k] as number) - (before[k] as number)) as [number, number]
      after.forEach((value, k) => {
        expect(value).toBeCloseTo((before[k] as number) + ([dx, dy, 0][k % 3] as number), 9)
        if (k % 3 === 0) expect(value).toBeGreaterThan(0)
      })
      expect(Math.abs(dx)).toBeGreaterThan(40)
    }).toPass()
    await app.canvas.focus()
    await app.page.keyboard.press('ControlOrMeta+z')
    await expect(async () => expect([...(await app.circles())]).toEqual([...before])).toPass()
    await app.painted()
    const [color] = await app.colors([app.center(before, 2)])
    expect(strengthOf(color as number[])).toBeGreaterThan(60)
  })
})
