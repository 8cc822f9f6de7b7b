// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of the region on the whole page, and the share of the selected cell.
// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { areasOf } from './areas-of.ts'
import {
  all,
  choose,
  chosenOf,
  control,
  controls,
  element,
  limitsOf,
  optionsOf,
  send,
  textOf,
} from './page-document.ts'
import { entered, FIVE, pressed, quiet, soon, wholePage } from './whole-page.ts'

/** A square around all circles. */
const SQUARE = [
  [-10, -10],
  [30, -10],
  [30, 30],
  [-10, 30],
] as const
const OTHER = SQUARE.map(([x, y]) => [x + 20, y] as const)
const polygonsOf = (...squares: (readonly (readonly number[])[])[]) =>
  JSON.stringify({ type: 'MultiPolygon', coordinates: squares.map((ring) => [[...ring, ring[0]]]) })

let page: Awaited<ReturnType<typeof wholePage>>
let panel: HTMLElement
const domain = () => page.store.get().domain
const says = () => all(panel, 'p').map(textOf)
const radii = () => [0, 1, 2, 3, 4].map((id) => page.circle(id)?.r)
const AREAS = 'Areas'
const MERGE = 'Merge polygons that share borders or overlap'
const REPEAT = 'Repeat the circles in a box'

beforeAll(async () => {
  page = await wholePage()
  panel = await page.panel('region')
})
beforeEach(() => page.open(FIVE))

async function setRegion() {
  await page.actions.setDomain({ region: [SQUARE] })
  await quiet()
}

describe('the region', () => {
  it('is drawn corner by corner, and closed from three corners on', async () => {
    await pressed(panel, 'Draw')
    expect([page.store.get().tool, document.activeElement]).toEqual(['draw', element('figure')])
    const disabled = () => ['Close polygon', 'Undo corner', 'Cancel'].map((name) => control(panel, name).disabled)
    const corner = async (offsetX: number, offsetY: number) => {
      for (const type of ['pointerdown', 'pointerup']) {
        send(element('figure'), type, { pointerId: 1, button: 0, pointerType: 'mouse', offsetX, offsetY })
      }
      await quiet()
    }
    expect(disabled()).toEqual([true, true, false])
    for (const [x, y, ...expected] of [
      [300, 200, true, false],
      [500, 200, true, false],
      [400, 400, false, false],
      [300, 450, false, false],
    ] as const) {
      await corner(x, y)
      expect(disabled()).toEqual([...expected, false])
    }
    await pressed(panel, 'Undo corner', 'Close polygon')
    await soon(() => expect(domain().region).toHaveLength(1))
    await quiet()
    expect(says()[0]).toBe('One outline with 3 sides. Cells, areas and files are clipped to it.')
    await pressed(panel, 'Draw more')
    expect(says()[1]).toMatch(/becomes a hole/)
    await pressed(panel, 'Cancel')
    expect(page.store.get().tool).toBe('select')
    await pressed(panel, 'Remove region')
    expect(domain().region).toBeUndefined()
  })

  it('is opened from a file, the same one again too, and merged if that is wanted', async () => {
    const file = new File([polygonsOf(SQUARE, OTHER)], 'a.geojson')
    const input = control(panel, 'Open …')
    await pressed(panel, MERGE)
    choose(input, file)
    await soon(() => expect(domain().region).toBeDefined())
    expect(input.value).toBe('')
    await quiet()
    expect(control(panel, MERGE).checked).toBe(true)
    expect(domain().region).toMatchObject({ dissolve: true })
    const merged = page.store.get().edited
    await page.actions.undo()
    choose(input, file)
    await soon(() => expect(domain().region).toBeDefined())
    expect(page.store.get().edited).not.toBe(merged)
    await pressed(panel, MERGE)
    await soon(() => expect(page.store.get().problem).toMatch(/overlap|cross/))
    expect(domain().region, 'polygons that overlap are refused unmerged').toMatchObject({ dissolve: true })
    await page.actions.removeRegion()
    await quiet()
    if (control(panel, MERGE).checked) await pressed(panel, MERGE)
    expect(says()[0]).toMatch(/^Clip the cells/)
  })

  it('is described by its outlines and sides, without the point that closes a ring', async () => {
    await page.actions.setDomain({
      region: [[...SQUARE, SQUARE[0]], SQUARE.map(([x, y]) => [x / 100, y / 100] as const)],
    })
    await quiet()
    expect(says()[0]).toMatch(/^2 outlines with 8 sides\./)
  })
})

describe('areas', () => {
  it.each([
    ['equal', 'equal', [1, 1, 1, 1, 1]],
    ['radius', 'by radius', [2, 3, 1, 2, 4]],
    ['disc', 'by disc area', [4, 9, 1, 4, 16]],
    ['column:n', 'by n', [1, 2, 3, 4, 5]],
  ])('are given by the choice %s, and the radii come back', async (value, label, shares) => {
    await page.open(FIVE, [{ name: 'n', values: ['1', '2', '3', '4', '5'] }])
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
    await page.actions.undo()
    await quiet()
    expect(chosenOf(control(panel, AREAS)), 'the choice is known again').toBe(label)
  })

  it('of their own are a choice that changes nothing, and a refused choice is taken back', async () => {
    await setRegion()
    await page.actions.setAreas([5, 4, 3, 2, 1])
    await quiet()
    expect(optionsOf(control(panel, AREAS)).at(-1)).toBe('one by one')
    const { areas } = domain()
    await entered(panel, AREAS, 'own')
    expect([domain().areas, chosenOf(control(panel, AREAS))]).toEqual([areas, 'one by one'])
    await page.open(Float64Array.of(0, 0, 1, 0, 0, 1))
    await setRegion()
    await entered(panel, AREAS, 'radius')
    await soon(() => expect(page.store.get().problem).not.toBe(''))
    expect([domain().areas, chosenOf(control(panel, AREAS))]).toEqual([undefined, 'not fixed'])
  })

  it('by a column give the mean to circles without a number, which is said', async () => {
    await page.open(FIVE, [{ name: 'n', values: ['1', '', '3', '2', '2'] }])
    await setRegion()
    await entered(panel, AREAS, 'column:n')
    await soon(() => expect(textOf(element('toast'))).toBe('1 of the circles have no number in n: they get the mean.'))
    await quiet()
    const areas = await areasOf(page.view, 5)
    expect(areas[1] as number).toBeCloseTo(320, 3)
  })

  it('need a region', async () => {
    const disabled = () => all(panel, 'fieldset').map((fields) => (fields as HTMLFieldSetElement).disabled)
    expect([disabled(), textOf(element('areas-said'))]).toEqual([[true, false], expect.stringMatching(/need a region/)])
    await setRegion()
    expect(disabled()).toEqual([false, false])
  })
})

describe('the periodic box', () => {
  const fields = () => [...controls(panel).keys()].filter((label) => label.startsWith('Period'))

  it('is around the circles, has a field for each number, and is switched off again', async () => {
    await setRegion()
    expect(says().at(-1)).toMatch(/It replaces the region/)
    await pressed(panel, REPEAT)
    expect(control(panel, REPEAT).checked).toBe(true)
    expect([domain().region, says().at(-1)]).toEqual([undefined, expect.stringMatching(/^Opposite sides are glued/)])
    const { a, b } = domain().lattice as { a: readonly number[]; b: readonly number[] }
    expect(fields().map((label) => control(panel, label).value)).toEqual([...a, ...b].map(String))
    for (const [k, label] of ['Period a, x', 'Period a, y', 'Period b, x', 'Period b, y'].entries()) {
      const before = [...(domain().lattice?.a ?? []), ...(domain().lattice?.b ?? [])]
      await entered(panel, label, String((before[k] as number) + 1))
      expect([...(domain().lattice?.a ?? []), ...(domain().lattice?.b ?? [])]).toEqual(
        before.with(k, (before[k] as number) + 1),
      )
    }
    await entered(panel, 'Period a, y', '0')
    const kept = domain().lattice
    await entered(panel, 'Period a, x', '0')
    expect([domain().lattice, page.store.get().problem !== '']).toEqual([kept, true])
    expect(control(panel, 'Period a, x').value).toBe(String(kept?.a[0]))
    await entered(panel, 'Period a, x', '')
    expect(domain().lattice).toEqual(kept)
    await pressed(panel, REPEAT)
    expect([domain().lattice, fields()]).toEqual([undefined, []])
  })
})

describe('the share of the selected cell', () => {
  const [NUMBER, SLIDER] = ['% of the region', 'Share of the region, against the mean']
  const place = () => element('inspector-share')

  it('is shown where areas are given, and the radius is then a weight that cannot be entered', async () => {
    page.actions.select([1])
    await setRegion()
    const radius = element<HTMLInputElement>('field-r')
    const shown = () => [!place().hidden, radius.readOnly, textOf(radius.labels?.[0])]
    expect(shown()).toEqual([false, false, 'r'])
    await page.actions.setAreas('equal')
    await quiet()
    expect(shown()).toEqual([true, true, 'w'])
    expect([control(place(), NUMBER).value, limitsOf(control(place(), NUMBER))]).toEqual([
      '20',
      ['0.0001', '99', 'any'],
    ])
    expect([Number(control(place(), SLIDER).value), limitsOf(control(place(), SLIDER))]).toEqual([
      0,
      ['-5', '5', 'any'],
    ])
    page.actions.select([])
    await quiet()
    expect(shown()).toEqual([false, false, 'r'])
  })

  it('is a number in percent, or a slider in powers of two of the mean, which is one step of undo', async () => {
    await setRegion()
    await page.actions.setAreas('equal')
    page.actions.select([3])
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
