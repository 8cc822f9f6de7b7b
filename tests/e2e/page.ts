// SPDX-License-Identifier: GPL-3.0-or-later
import { readFileSync } from 'node:fs'
import { test as base, expect, type Page } from '@playwright/test'
import { parseCircles } from '../../web/app/csv.ts'
import { at } from '../../web/lib/base/diagram-data.ts'
import type { Point } from '../../web/lib/index.ts'
import { boundingBox, type Camera, fitted, toScreen } from '../../web/view/camera.ts'

/** What the page keeps free for its panels (`padding` in main.ts). */
export const PADDING = { top: 72, right: 32, bottom: 64, left: 32 }

/** The opened page, and where its circles are. */
export class App {
  readonly page: Page

  constructor(page: Page) {
    this.page = page
  }

  async open(): Promise<void> {
    await this.page.goto('/')
    await expect(this.status).toContainText('edges')
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

  field(name: 'x' | 'y' | 'r') {
    return this.inspector.getByLabel(name, { exact: true })
  }

  /** The numbers of the circles that the inspector lists as neighbors. */
  neighbors(): Promise<string[]> {
    return this.inspector.getByRole('list', { name: 'Neighbors' }).getByRole('button').allTextContents()
  }

  /** The camera that shows all circles of a data set. */
  camera(circles: Float64Array): Camera {
    const { width, height } = this.page.viewportSize() as { width: number; height: number }
    return fitted(boundingBox(circles), { width, height }, PADDING)
  }

  /** Where a point of the plane is on the page while all circles are shown. */
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
    await this.page.mouse.move(from.x, from.y)
    await this.page.mouse.down()
    await this.page.mouse.move(to.x, to.y, { steps: 8 })
  }

  /** The colors of the canvas at these points of the page, red, green, blue each; one device pixel per pixel. */
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
  return parseCircles(readFileSync(new URL(`../../public/data/${name}.csv`, import.meta.url), 'utf8'))
}

/** A test with the page open. It fails on any message of an error and any violation of the Content-Security-Policy. */
export const test = base.extend<{ app: App }>({
  app: async ({ page }, use) => {
    const errors: string[] = []
    page.on('pageerror', (error) => errors.push(error.message))
    page.on('console', (message) => {
      const isBlocked = message.text() === 'Service Worker registration blocked by Playwright'
      if ((message.type() === 'error' || message.type() === 'warning') && !isBlocked) errors.push(message.text())
    })
    const app = new App(page)
    await app.open()
    await use(app)
    expect(errors).toEqual([])
  },
})

export { expect }
