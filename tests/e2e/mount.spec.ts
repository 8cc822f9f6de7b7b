// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, type Page } from '@playwright/test'
import { soon } from '../soon.ts'
import { testOf } from './built-page.ts'
import type { TwoViews } from './two-views/two-views.ts'

declare const views: TwoViews

const test = testOf('two-views', async (page) => {
  await expect(page.locator('#one[aria-busy="false"]')).toBeVisible()
  await expect(page.locator('#other[aria-busy="false"]')).toBeVisible()
})

const circleOf = (page: Page, name: 'one' | 'other', id: number) =>
  page.evaluate(([name, id]) => views[name].editing.circles.get(id), [name, id] as const)

test('two views on one page know nothing of each other', async ({ opened: page }) => {
  const other = page.locator('#other')
  const before = await other.screenshot()
  const place = await page.evaluate(() => {
    const { camera, size } = views.one.view
    const { left, top } = (document.getElementById('one') as HTMLElement).getBoundingClientRect()
    return {
      x: left + 3 + size.width / 2 - camera.x * camera.scale,
      y: top + 3 + size.height / 2 + camera.y * camera.scale,
    }
  })
  await page.mouse.move(place.x, place.y)
  await page.mouse.down()
  await page.mouse.move(place.x + 40, place.y - 20, { steps: 4 })
  await page.mouse.up()
  await soon(async () => (await circleOf(page, 'one', 0))?.x).toBeGreaterThan(0.5)
  expect(await circleOf(page, 'other', 0)).toEqual({ x: 0, y: 0, r: 2 })
  await page.mouse.move(place.x + 100, place.y + 4000)
  expect(before.equals(await other.screenshot())).toBe(true)

  // Layers, camera and selection belong to one view; errors are reported to the caller.
  await page.evaluate(() => {
    views.one.view.setLayers({ hull: true, cells: 'different' })
    views.one.view.setCamera({ x: 5, y: 5, scale: 10 })
    views.one.actions.selection.select([1])
  })
  await expect(page.locator('#one[aria-busy="false"]')).toBeVisible()
  expect(before.equals(await other.screenshot())).toBe(true)
  const refused = await page.evaluate(async () => {
    await views.one.editing.edit([{ kind: 'remove', id: 99 }])
    return [views.one, views.other].map(({ store }) => store.get().problem !== '')
  })
  expect(refused).toEqual([true, false])

  // Checks that nothing remains of a disposed view.
  await page.evaluate(() => views.one.dispose())
  await expect(page.locator('#one canvas')).toHaveCount(0)
  await page.evaluate(() => views.other.editing.edit([{ kind: 'remove', id: 1 }]))
  await soon(() => circleOf(page, 'other', 1)).toBeUndefined()
  const again = await page.evaluate(async () => {
    views.other.dispose()
    const { store, editing } = views.mount('one')
    await editing.open({ circles: Float64Array.of(0, 0, 1, 5, 0, 1), dataSet: '', isEdited: false })
    return store.get().edited?.counts
  })
  expect(again).toEqual({ circles: 2, hidden: 0, vertices: 0, edges: 1 })
})

test('a view is written as an SVG and as a PNG that look alike, and refuses what cannot be drawn', async ({
  opened: page,
}) => {
  await test.step('an SVG and a PNG look alike', async () => {
    const alike = await page.evaluate(async () => {
      const draw = async (blob: Blob) => {
        const image = new Image()
        image.src = URL.createObjectURL(blob)
        await image.decode()
        const canvas = new OffscreenCanvas(400, 300)
        const context = canvas.getContext('2d', { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D
        context.drawImage(image, 0, 0, 400, 300)
        return { pixels: context.getImageData(0, 0, 400, 300).data, width: image.naturalWidth }
      }
      const found = new Promise<void>((resolve) => views.one.view.on('found', (found) => found?.hull && resolve()))
      views.one.view.setLayers({ hull: true, dual: true })
      await found
      const svg = await draw(new Blob([await views.toSVG(views.one.view)], { type: 'image/svg+xml' }))
      const png = await draw(await views.toPNG(views.one.view, 1))
      const large = await views.toPNG(views.one.view, 3)
      let different = 0
      for (let k = 0; k < svg.pixels.length; k++) {
        if (Math.abs((svg.pixels[k] as number) - (png.pixels[k] as number)) > 60) different += 1
      }
      const colors = new Set(Array.from({ length: 3000 }, (_, k) => png.pixels.slice(160 * k, 160 * k + 3).join()))
      // The selection is not part of the picture.
      const before = await views.toSVG(views.one.view)
      const marked = new Promise<void>((resolve) =>
        views.one.view.on('marked', ({ selected }) => selected && resolve()),
      )
      views.one.actions.selection.select([0])
      await marked
      views.one.actions.selection.select([0, 1])
      return {
        isUnmarked: before === (await views.toSVG(views.one.view)),
        share: different / svg.pixels.length,
        colors: colors.size,
        width: (await draw(large)).width,
        type: large.type,
      }
    })
    expect(alike.isUnmarked).toBe(true)
    expect(alike.share).toBeLessThan(0.01)
    expect(alike.colors).toBeGreaterThan(8)
    expect(alike.width).toBe(1200)
    expect(alike.type).toBe('image/png')
  })
  await test.step('what cannot be drawn is refused where it is asked for, and all views go on', async () => {
    const refused = await page.evaluate(async () => {
      const told: string[] = []
      const reason = (error: Error) => told.push(`${error.name}: ${error.message}`)
      for (const scale of [0, Number.NaN, 1000]) await views.toPNG(views.one.view, scale).catch(reason)
      try {
        views.one.view.setLayers({ data: 5 as never })
      } catch (error) {
        reason(error as Error)
      }
      await views.other.editing.edit([{ kind: 'remove', id: 1 }])
      return { told, data: views.one.view.layers.data, type: (await views.toPNG(views.one.view, 1)).type }
    })
    expect(refused.told).toEqual([
      'CircleVoronoiError: The scale of a picture is a positive number, not 0.',
      'CircleVoronoiError: The scale of a picture is a positive number, not NaN.',
      'CircleVoronoiError: A picture 1000 times as large as this one is too large.',
      'CircleVoronoiError: The layer data must be an array of objects whose points, segments and discs are arrays of numbers (got 5).',
    ])
    expect(refused.data).toEqual([])
    expect(refused.type).toBe('image/png')
    expect(await circleOf(page, 'other', 1)).toBeUndefined()
  })
})

test('what is found stays where circles are refused, and is told to be gone once others are there', async ({
  opened: page,
}) => {
  const outcome = await page.evaluate(async () => {
    const one = views.one.view
    const told: (number | undefined)[] = []
    const isFound = () => new Promise<void>((resolve) => one.on('found', (found) => found?.hull && resolve()))
    const before = isFound()
    one.setLayers({ hull: true })
    await before
    one.on('found', (found) => told.push(found?.hull?.length))
    const picture = await views.toSVG(one)
    await one.scene.open(Float64Array.of(0, 0, -1)).catch(() => {})
    const isSame = picture === (await views.toSVG(one))
    const toldMeanwhile = [...told]
    const after = isFound()
    await one.scene.open(Float64Array.of(0, 0, 1, 5, 0, 1))
    const toldAtOnce = [...told]
    await after
    return { isSame, toldMeanwhile, toldAtOnce, told }
  })
  // The hull of two circles has two arcs of seven numbers each.
  expect(outcome).toEqual({ isSame: true, toldMeanwhile: [], toldAtOnce: [undefined], told: [undefined, 14] })
})
