// SPDX-License-Identifier: GPL-3.0-or-later
// The step of a figure has one owner: whoever sets it last, from wherever, is what the player shows.
import { expect, type Page, test } from '@playwright/test'
import { encodeLink } from '../../web/lib/link.ts'
import { soon } from '../soon.ts'
import { ownPages } from './own-pages.ts'

type Element = HTMLElementTagNameMap['circle-voronoi']

const pages = ownPages('step')
const CIRCLES = [
  [0, 0, 2],
  [10, 0, 1],
  [5, 8, 1.5],
  [2, 6, 0.8],
]

/** Opens a page with one figure that has these attributes. */
const open = (page: Page, attributes: string) =>
  pages.open(page, `<circle-voronoi circles="${JSON.stringify(CIRCLES)}" ${attributes}></circle-voronoi>`)

/** The step of the property, of the state and of the slider, once all changes are visible. */
const steps = (page: Page) =>
  page.locator('circle-voronoi').evaluate(async (element: Element) => {
    await element.updateComplete
    const slider = (element.shadowRoot as ShadowRoot).querySelector<HTMLInputElement>('input[type=range]')
    return [element.step, element.getState().step, slider === null ? undefined : Number(slider.value)]
  })

test('a step that is set while the player plays is where it goes on', async ({ page }) => {
  await open(page, 'step="0"')
  const told = await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    const speed = (element.shadowRoot as ShadowRoot).querySelectorAll('select')
    for (const select of speed) {
      const fastest = [...select.options].find(({ text }) => text.includes('30'))
      if (fastest === undefined) continue
      select.value = fastest.value
      select.dispatchEvent(new Event('change', { bubbles: true }))
    }
    await element.play()
    await new Promise((resolve) => element.addEventListener('stepchange', resolve, { once: true }))
    const told: number[] = []
    element.addEventListener('stepchange', ({ detail }) => told.push(detail.step))
    // Also in the middle of a frame, and several times at once.
    for (const step of [30, 12, 20]) element.step = step
    const now = element.step
    while (told.length < 4) await new Promise((resolve) => setTimeout(resolve, 5))
    element.pause()
    return [now, ...told.slice(0, 4)]
  })
  expect(told[0]).toBe(20)
  // The player may have played on from step 20 before it was drawn.
  const first = told[1] as number
  expect([20, 21]).toContain(first)
  expect(told.slice(1)).toEqual([first, first + 1, first + 2, first + 3])
  const seen = await steps(page)
  expect(new Set(seen).size).toBe(1)
})

test('the same step as before is shown again once the player is elsewhere', async ({ page }) => {
  await open(page, 'step="3"')
  await page.locator('circle-voronoi').evaluate((element: Element) => element.stepTo(9))
  expect(await steps(page)).toEqual([9, 9, 9])
  await page.locator('circle-voronoi').evaluate((element: Element) => {
    element.step = 3
  })
  expect(await steps(page)).toEqual([3, 3, 3])
})

test('circles that are set are played from the step of the attribute, wherever the player was', async ({ page }) => {
  await open(page, 'step="3"')
  for (const before of [3, 9]) {
    const seen = await page.locator('circle-voronoi').evaluate(async (element: Element, before) => {
      await element.stepTo(before)
      element.circles = element.circles.map((value, k) => (k === 0 ? value - 0.25 : value))
      await element.updateComplete
      return element.step
    }, before)
    expect(seen).toBe(3)
    expect(await steps(page)).toEqual([3, 3, 3])
  }
})

test('a step that is set while the circles change is shown of the new ones', async ({ page }) => {
  await open(page, 'step="5"')
  for (const [step, times] of [
    [5, 1],
    [7, 2],
  ] as const) {
    await page.locator('circle-voronoi').evaluate(
      async (element: Element, [step, times]) => {
        for (let k = 0; k < times; k++) {
          const edits = [{ kind: 'replace', id: 0, circle: { x: -k - 1, y: 0, r: 2 } }] as const
          const edited = new Promise((resolve) => element.addEventListener('circleschange', resolve, { once: true }))
          void element.setState({ edits } as never)
          await edited
        }
        element.step = step
      },
      [step, times] as const,
    )
    expect(await steps(page)).toEqual([step, step, step])
  }
})

test('edits and undo begin again, or stay at the stage; undo does not change which step is wanted then', async ({
  page,
}) => {
  await open(page, 'step="9"')
  const figure = page.locator('circle-voronoi')
  const [x, y] = await figure.evaluate(async (element: Element) => {
    element.view = { x: 5, y: 4, span: 20 }
    await element.updateComplete
    const box = ((element.shadowRoot as ShadowRoot).querySelector('.figure') as HTMLElement).getBoundingClientRect()
    return [box.left + box.width / 2, box.top + box.height / 2, Math.min(box.width, box.height) / 20] as const
  })
  const scale = await figure.evaluate((element) => {
    const box = ((element.shadowRoot as ShadowRoot).querySelector('.figure') as HTMLElement).getBoundingClientRect()
    return Math.min(box.width, box.height) / 20
  })
  await page.mouse.move(x - 5 * scale, y + 4 * scale)
  await page.mouse.down()
  await page.mouse.move(x - 6 * scale, y + 4 * scale, { steps: 3 })
  await page.mouse.up()
  const first = () => figure.evaluate((element: Element) => element.circles[0])
  await soon(first).toBeLessThan(-0.5)
  expect(await steps(page)).toEqual([0, 0, 0])
  await page.keyboard.press('Control+z')
  await figure.evaluate((element: Element) => element.stepTo(4))
  await soon(first).toBe(0)
  expect((await steps(page))[0]).toBe(4)
})

test('a link to a step opens it, also while another step is set or played', async ({ page }) => {
  await open(page, 'step="9"')
  const link = await encodeLink({ circles: Float64Array.from(CIRCLES.flat(), (value) => value + 1), step: 6 })
  const seen = await page.locator('circle-voronoi').evaluate(async (element: Element, link) => {
    await element.play()
    element.step = 2
    await element.setState(link)
    element.pause()
    await element.updateComplete
    return element.step
  }, link)
  expect(seen).toBe(6)
  expect(await steps(page)).toEqual([6, 6, 6])
})

test('a figure that a script has played shows its diagram once the step is undefined', async ({ page }) => {
  await open(page, '')
  await page.locator('circle-voronoi').evaluate((element: Element) => element.stepTo(4))
  expect(await steps(page)).toEqual([4, 4, 4])
  await page.locator('circle-voronoi').evaluate((element: Element) => {
    element.step = undefined
  })
  await soon(() => steps(page)).toEqual([undefined, undefined, undefined])
})

test('a step beyond the end is the last one, and a listener may set another one', async ({ page }) => {
  await open(page, 'step="0"')
  await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    await element.stepTo(1e6)
  })
  const [last, ...others] = await steps(page)
  expect(others).toEqual([last, last])
  expect(last).toBeLessThan(1e6)
  const told = await page.locator('circle-voronoi').evaluate(async (element: Element) => {
    const told: number[] = []
    element.addEventListener('stepchange', ({ detail }) => {
      told.push(detail.step)
      if (detail.step === 5) element.step = 2
    })
    await element.stepTo(5)
    await new Promise((resolve) => setTimeout(resolve, 300))
    return told
  })
  expect(told).toEqual([5, 2])
  expect(await steps(page)).toEqual([2, 2, 2])
})
