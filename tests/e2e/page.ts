// SPDX-License-Identifier: GPL-3.0-or-later
import { readFileSync } from 'node:fs'
import { test as base, expect, type Locator, type Page } from '@playwright/test'
import { at } from '../../web/lib/base/diagram-data.ts'
import type { Circle, Point } from '../../web/lib/index.ts'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { boundingBox, type Camera, fitted, type Padding, toScreen } from '../../web/view/camera.ts'
import { circlesOfText } from '../../web/view/circle-text.ts'
import { soon } from '../soon.ts'
import { framesOf } from './frames.ts'

/** The space that the page keeps free for its panels (web/app/padding.ts), in a wide window and on a phone. */
export const PADDING = { top: 84, right: 32, bottom: 106, left: 94 }
const PADDING_OF_PHONE = { top: 98, right: 16, bottom: 220, left: 16 }
const NARROW = 640
const ROOM = 16

const BRONZE_LINK = await encodeLink({ dataSet: 'bronzefilter' })
const INTRODUCTION_LINK = await encodeLink({ dataSet: 'introduction' })
const EIGHT_LINK = await encodeLink({ dataSet: 'start' })

/** The opened page, with the positions of its circles. */
export class App {
  readonly page: Page
  /** The edge of the open panel, if any. */
  #panelEnd = 0

  constructor(page: Page) {
    this.page = page
  }

  /** Opens the page with enough circles for most tests. An empty link shows the introduction. */
  async open(link = BRONZE_LINK): Promise<void> {
    await this.page.goto(`/#${link}`)
    await expect(this.status).toContainText('edges')
  }

  /** The space that the page keeps free in the current window. */
  get padding(): Padding {
    const isPhone = (this.page.viewportSize()?.width ?? 0) <= NARROW
    return isPhone ? PADDING_OF_PHONE : { ...PADDING, left: Math.max(PADDING.left, this.#panelEnd + ROOM) }
  }

  /** Opens or closes a panel by its button, which on a phone is in the second row. */
  async openPanel(name: string): Promise<void> {
    const more = this.page.getByRole('button', { name: 'More tools' })
    // A sheet that covers the rail hides it.
    const button = this.page.locator('#rail').getByRole('button', { name, exact: true, includeHidden: true })
    if (!(await button.isVisible())) await more.click()
    const wasOpen = await button.getAttribute('aria-expanded')
    await button.click()
    // The panel is loaded when it is opened for the first time.
    await expect(button).not.toHaveAttribute('aria-expanded', wasOpen ?? '')
    const panel = await this.page.evaluate(
      () => document.querySelector('#left > .panel:not([hidden])')?.getBoundingClientRect().right,
    )
    this.#panelEnd = panel ?? 0
    // The page learns the panel's size in its next frame, and then shows all circles beside it.
    await framesOf(this.page, 2)
  }

  /** The circles in the address, x, y, r each, once they are saved. */
  async circles(): Promise<Float64Array> {
    const link = await decodeLink(new URL(this.page.url()).hash)
    const circles = link.circles ?? dataSet(link.dataSet as string)
    const byId = new Map<number, Circle>()
    const circleAt = (i: number): Circle => ({
      x: at(circles, 3 * i),
      y: at(circles, 3 * i + 1),
      r: at(circles, 3 * i + 2),
    })
    for (let i = 0; i < circles.length / 3; i++) byId.set(i, circleAt(i))
    let next = byId.size
    for (const edit of link.edits ?? []) {
      if (edit.kind === 'remove') byId.delete(edit.id)
      else byId.set(edit.kind === 'replace' ? edit.id : next++, edit.circle as Circle)
    }
    return Float64Array.from([...byId.values()].flatMap(({ x, y, r }) => [x, y, r]))
  }

  async choose(label: string): Promise<void> {
    const before = await this.status.textContent()
    await this.page.getByLabel('Data set').selectOption({ label })
    await expect(this.status).not.toHaveText(before as string)
  }

  get status() {
    return this.page.locator('#status')
  }

  get canvas() {
    return this.page.locator('#figure')
  }

  get inspector() {
    return this.page.getByRole('region', { name: 'Selected circle', exact: true })
  }

  /** Waits until the picture is painted. The busy state is updated one frame later. */
  async painted(): Promise<void> {
    await framesOf(this.page, 2)
    await expect(this.canvas).toHaveAttribute('aria-busy', 'false')
  }

  field(name: 'x' | 'y' | 'r') {
    return this.inspector.getByLabel(name, { exact: true })
  }

  /**
   * Selects a circle by a click on its center, and waits for its card, because the fields show the previous circle
   * until then.
   */
  async select(circles: Float64Array, i: number): Promise<void> {
    const { x, y } = this.center(circles, i)
    await this.page.mouse.click(x, y)
    await expect(this.inspector.getByRole('heading')).toHaveText(`Circle ${i}`)
  }

  /** The numbers of the neighbors listed in the inspector. */
  neighbors(): Promise<string[]> {
    return this.inspector.getByRole('list', { name: 'Neighbors' }).getByRole('button').allTextContents()
  }

  /** The camera that shows all circles. */
  camera(circles: Float64Array): Camera {
    const { width, height } = this.page.viewportSize() as { width: number; height: number }
    return fitted(boundingBox(circles), { width, height }, this.padding)
  }

  /** The position on the page of a point of the plane, while all circles are shown. */
  locate(circles: Float64Array, point: Point): Point {
    return toScreen(this.camera(circles), this.page.viewportSize() as { width: number; height: number }, point)
  }

  center(circles: Float64Array, i: number): Point {
    return this.locate(circles, { x: at(circles, 3 * i), y: at(circles, 3 * i + 1) })
  }

  isShown({ x, y }: Point): boolean {
    const { width, height } = this.page.viewportSize() as { width: number; height: number }
    return x >= 0 && x < width && y >= 0 && y < height
  }

  async drag(from: Point, to: Point): Promise<void> {
    const { mouse } = this.page
    await mouse.move(from.x, from.y)
    // Sends the first move with the press, because a resting press would preview a circle.
    await Promise.all([mouse.down(), mouse.move(to.x, to.y, { steps: 8 })])
  }

  /** Drops a file on the page. */
  async drop(name: string, text: string): Promise<void> {
    await this.page.evaluate(
      ([name, text]) => {
        const dataTransfer = new DataTransfer()
        dataTransfer.items.add(new File([text as string], name as string))
        document.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }))
      },
      [name, text],
    )
  }

  /** The text that a button copies. The clipboard of a browser still has what an earlier test copied. */
  async copiedBy(button: Locator): Promise<string> {
    await this.page.context().grantPermissions(['clipboard-read', 'clipboard-write'])
    await this.page.evaluate(() => navigator.clipboard.writeText(''))
    await button.click()
    const read = () => this.page.evaluate(() => navigator.clipboard.readText())
    await soon(read).not.toBe('')
    return read()
  }

  /** The number of values above zero in the overlay's pixels. */
  readonly drawnAbove = (): Promise<number> =>
    this.canvas
      .locator('canvas')
      .nth(1)
      .evaluate((canvas: HTMLCanvasElement) => {
        const copy = new OffscreenCanvas(canvas.width, canvas.height)
        const context = copy.getContext('2d', { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D
        context.drawImage(canvas, 0, 0)
        return context.getImageData(0, 0, canvas.width, canvas.height).data.filter((value) => value > 0).length
      })

  /**
   * The colors of the canvas at some points of the page, red, green, blue each, with one device pixel per CSS pixel.
   */
  colors(points: readonly Point[]): Promise<number[][]> {
    return this.canvas
      .locator('canvas')
      .first()
      .evaluate((canvas: HTMLCanvasElement, points) => {
        const copy = new OffscreenCanvas(canvas.width, canvas.height)
        const context = copy.getContext('2d', { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D
        context.drawImage(canvas, 0, 0)
        const { data, width } = context.getImageData(0, 0, canvas.width, canvas.height)
        return points.map(({ x, y }) => {
          const first = 4 * (Math.floor(y) * width + Math.floor(x))
          return [...data.slice(first, first + 3)]
        })
      }, points)
  }
}

export function dataSet(name: string): Float64Array {
  return circlesOfText(readFileSync(new URL(`../../public/data/${name}.csv`, import.meta.url), 'utf8'))
}

/** Opens the page for a test. The test fails on any error message and any violation of the Content-Security-Policy. */
async function opened(page: Page, link: string | undefined, use: (app: App) => Promise<void>): Promise<void> {
  const errors: string[] = []
  page.on('pageerror', (error) => errors.push(error.message))
  page.on('console', (message) => {
    const isBlocked = message.text() === 'Service Worker registration blocked by Playwright'
    if ((message.type() === 'error' || message.type() === 'warning') && !isBlocked) errors.push(message.text())
  })
  const app = new App(page)
  await app.open(link)
  await use(app)
  expect(errors).toEqual([])
}

/** A test with the page open at a link, or at one of the small data sets. */
export const test = base.extend<{ app: App; introduction: App; eight: App; link: string | undefined }>({
  link: [undefined, { option: true }],
  app: ({ page, link }, use) => opened(page, link, use),
  introduction: ({ page }, use) => opened(page, INTRODUCTION_LINK, use),
  eight: ({ page }, use) => opened(page, EIGHT_LINK, use),
})

export { expect }
