// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of the region on the whole page, and the share of the selected cell.
// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { areasOf } from './areas-of.ts'
import { chosenOf, control, element, send, textOf } from './page-document.ts'
import { entered, FIVE, quiet, soon, wholePage } from './whole-page.ts'

/** A square around all circles. */
const SQUARE = [
  [-10, -10],
  [30, -10],
  [30, 30],
  [-10, 30],
] as const

let page: Awaited<ReturnType<typeof wholePage>>
let panel: HTMLElement
const domain = () => page.store.get().domain
const radii = () => [0, 1, 2, 3, 4].map((id) => page.circle(id)?.r)
const AREAS = 'Areas'

beforeAll(async () => {
  page = await wholePage()
  panel = await page.panel('region')
})
beforeEach(() => page.open(FIVE))

async function setRegion() {
  await page.actions.circles.setDomain({ region: [SQUARE] })
  await quiet()
}

it('an opening that is undone shows the whole region again', async () => {
  const wide = SQUARE.map(([x, y]) => [10 * x, 10 * y] as const)
  await page.actions.circles.setDomain({ region: [wide] })
  await page.open(FIVE)
  await page.actions.circles.undo()
  const { minX, maxX } = page.actions.camera.uncovered
  expect([minX <= -100, maxX >= 300, domain().region]).toEqual([true, true, [wide]])
})

describe('areas', () => {
  it.each([
    ['radius', 'by radius', [2, 3, 1, 2, 4]],
    ['disc', 'by disc area', [4, 9, 1, 4, 16]],
  ])('are given by the choice %s, and the radii come back', async (value, label, shares) => {
    await setRegion()
    await entered(panel, AREAS, value)
    await soon(() => expect(domain().areas).toBeDefined())
    await quiet()
    expect(chosenOf(control(panel, AREAS))).toBe(label)
    const total = shares.reduce((sum, share) => sum + share)
    for (const [id, area] of (await areasOf(page.view, FIVE.length / 3)).entries()) {
      expect(area / 1600).toBeCloseTo((shares[id] as number) / total, 6)
    }
    expect(textOf(element('areas-said'))).toMatch(/Largest error of an area: \de-\d+\.$/)
    await entered(panel, AREAS, 'free')
    expect([chosenOf(control(panel, AREAS)), radii()]).toEqual(['not fixed', [2, 3, 1, 2, 4]])
    await page.actions.circles.undo()
    await quiet()
    expect(chosenOf(control(panel, AREAS)), 'the choice is known again').toBe(label)
  })

  it('leave no radii of circles that were opened before', async () => {
    await setRegion()
    await entered(panel, AREAS, 'equal')
    await page.actions.opening.open(async () => ({
      circles: Float64Array.of(0, 0, 7, 20, 9, 8),
      dataSet: '',
      isEdited: false,
      domain: { region: [SQUARE], areas: 'equal' },
    }))
    await quiet()
    const fitted = [page.circle(0)?.r, page.circle(1)?.r]
    await entered(panel, AREAS, 'free')
    expect([page.circle(0)?.r, page.circle(1)?.r]).toEqual(fitted)
    await page.actions.circles.undo()
    await page.actions.circles.undo()
    await quiet()
    await entered(panel, AREAS, 'free')
    expect(radii()).toEqual([2, 3, 1, 2, 4])
  })
})

describe('the share of the selected cell', () => {
  const [NUMBER, SLIDER] = ['% of the region', 'Share of the region, against the mean']
  const place = () => element('inspector-share')

  it('is a number in percent, or a slider in powers of two of the mean, which is one step of undo', async () => {
    await setRegion()
    await page.actions.domain.setAreas('equal')
    page.actions.selection.select([3])
    await quiet()
    const share = async () => ((await areasOf(page.view, 5))[3] as number) / 1600
    await entered(place(), NUMBER, '12')
    expect(await share()).toBeCloseTo(0.12, 6)
    const steps = page.store.get().history.done.length
    for (const value of ['0', '-0.5', '-1']) {
      control(place(), SLIDER).value = value
      send(control(place(), SLIDER), 'input')
      await quiet()
    }
    send(control(place(), SLIDER), 'change')
    expect(await share()).toBeCloseTo(0.1, 6)
    expect(page.store.get().history.done).toHaveLength(steps + 1)
    for (const invalid of ['', '99.5', '0']) await entered(place(), NUMBER, invalid)
    expect(await share()).toBeCloseTo(0.1, 6)
    expect(textOf(place().querySelector('output'))).toBe('0.500 × mean')
  })
})
