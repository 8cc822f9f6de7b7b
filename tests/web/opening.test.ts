// SPDX-License-Identifier: GPL-3.0-or-later
// The whole page opens one thing after another, and has a link of what it shows.
// @vitest-environment happy-dom

import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import type { OpenRequest } from '../../web/editing/open-request.ts'
import { showStep } from '../../web/editing/state.ts'
import { encodeLink, type LinkInput } from '../../web/lib/link.ts'
import { NO_DOMAIN } from '../../web/view/domain.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { ring } from './shapes.ts'
import { FIVE, quiet, soon, wholePage } from './whole-page.ts'

const THREE = Float64Array.of(0, 0, 1, 10, 0, 2, 0, 20, 3)
const REGION = [ring(-50, -50, 50, -50, 0, 90)] as const
const LATTICE = { a: [40, 0], b: [0, 40] } as const
let page: Awaited<ReturnType<typeof wholePage>>
const circles = () => [...page.editing.circles.circles()]
const problem = () => page.store.get().problem
const scene = (given: ArrayLike<number>, more: object = {}): OpenRequest => ({
  circles: Float64Array.from(given),
  dataSet: '',
  isEdited: false,
  ...more,
})
const open = (given: ArrayLike<number>, more: object = {}) => page.actions.opening.open(async () => scene(given, more))
const openLink = async (state: LinkInput) => page.actions.data.openLink(await encodeLink(state))

beforeAll(async () => {
  page = await wholePage()
})
beforeEach(async () => {
  page.view.setLayers({ ...DEFAULT_LAYERS, path: undefined })
  await page.actions.circles.setDomain(NO_DOMAIN)
  await page.open(FIVE)
})

describe('what is opened', () => {
  it('has its edits and layers, and what is opened after it has its own', async () => {
    const first = { edits: [{ kind: 'remove', id: 0 }], layers: { hull: true } }
    expect(await open(THREE, first)).toBe('opened')
    expect([circles(), page.view.layers.hull]).toEqual([[...THREE.slice(3)], true])
    for (const isLoaded of [false, true]) {
      page.view.setLayers({ hull: false })
      const former = open([5, 5, 5, 6, 6, 6], first)
      // Loading is over after a turn, and computing is not.
      if (isLoaded) await Promise.resolve()
      const later = open(THREE)
      expect([await former, await later, circles(), page.view.layers.hull, problem()]).toEqual([
        'superseded',
        'opened',
        [...THREE],
        false,
        '',
      ])
    }
  })

  it('changes nothing where it is refused, not even what is looked at', async () => {
    page.actions.selection.select([1])
    await quiet()
    const { camera } = page.view
    expect(await open([0, 0, -1])).toBe('refused')
    expect([circles(), page.view.camera, page.store.get().selection]).toEqual([[...FIVE], camera, [1]])
    expect(problem()).toMatch(/Circle 0 .*radius/)
    const [late, next] = [page.actions.opening.open(() => Promise.reject(new Error('late'))), open(THREE)]
    expect([await late, await next, problem()]).toEqual(['superseded', 'opened', ''])
  })

  it.each([1e-20, 1e-300, 1e40, Number.MAX_VALUE, Number.NaN])(
    'is refused once where its numbers are as %d',
    async (size) => {
      const { camera } = page.view
      const scales = new Set<number>()
      const unsubscribe = page.view.on('camera', ({ scale }) => scales.add(scale))
      expect(await open([0, 0, size, 3 * size, 0, size])).toBe('refused')
      const refusal = problem()
      expect(refusal).not.toBe('')
      // The painter says nothing more.
      await quiet()
      unsubscribe()
      expect([circles(), problem(), page.view.camera, [...scales]]).toEqual([[...FIVE], refusal, camera, []])
    },
  )

  it('is superseded at once by what is opened after it, or canceled, though it is never loaded', async () => {
    const never = () => new Promise<OpenRequest>(() => {})
    page.actions.messages.complain('It could not be opened.')
    const first = page.actions.opening.open(never)
    expect(problem()).toBe('')
    expect([await open(THREE), await first]).toEqual(['opened', 'superseded'])
    const third = page.actions.opening.open(never)
    page.actions.data.cancel()
    expect([await third, circles()]).toEqual(['superseded', [...THREE]])
  })

  it('ends the selection, the tool and the problem, and shows the method from its first step', async () => {
    page.actions.selection.select([1, 2])
    page.actions.tools.useTool('add')
    page.actions.messages.complain('wrong')
    showStep(page.store, 5, 'auto')
    await open(THREE)
    expect(page.store.get()).toMatchObject({ selection: [], tool: 'select', problem: '', step: 0, method: 'auto' })
    await open(THREE, { step: 3, method: 'touching-disc' })
    await soon(() => expect(page.store.get()).toMatchObject({ step: 3, method: 'touching-disc' }))
    showStep(page.store, undefined)
    await open(THREE)
    expect(page.store.get().step).toBeUndefined()
  })
})

describe('a link that is opened', () => {
  it('has its circles, domain, areas, step, method and colors', async () => {
    const parts = { region: REGION, areas: [1, 2, 3], step: 4, method: 'auto', colors: '012' } as const
    await openLink({ circles: THREE, ...parts })
    expect([page.editing.domain.region, page.editing.areas, page.editing.scene]).toMatchObject([
      REGION,
      [1, 2, 3],
      { colors: '012', dataSet: '', isEdited: false },
    ])
    expect(page.store.get()).toMatchObject({ step: 4, method: 'auto' })
    showStep(page.store, undefined)
    await openLink({ circles: THREE, lattice: LATTICE })
    expect(page.editing.domain).toMatchObject({ lattice: LATTICE, region: undefined })
    expect(await page.actions.data.openLink('v1.none')).toBe('refused')
  })

  it.each([
    [{}, true],
    [{ region: REGION }, REGION],
    [{ region: null }, undefined],
  ])('of a data set has its region, unless the link has another one or none: %j', async (more, region) => {
    expect(await openLink({ dataSet: 'cities', ...more })).toBe('opened')
    const found = page.editing.domain.region
    expect(region === true ? found !== undefined : found).toEqual(region)
    expect(page.editing.scene?.dataSet).toBe('cities')
  })

  it('keeps its title and question until a link without one', async () => {
    const frame = { title: 'T', question: 'Q?' }
    await openLink({ circles: THREE, ...frame })
    expect(page.actions.data.frame).toEqual(frame)
    await openLink({ circles: THREE })
    expect(page.actions.data.frame).toBeUndefined()
  })

  it('colors cells by its column', async () => {
    const attributes = { properties: ['{"n":5}', '{"n":7}', '{"n":9}'], ids: [], heights: [], collection: '' }
    await openLink({ circles: THREE, attributes, layers: { column: 'n' } })
    expect(page.view.layers.column).toMatchObject({ name: 'n', values: Float64Array.of(5, 7, 9) })
    await page.editing.setValues('n', new Map([[0, '6']]))
    await quiet()
    expect(page.view.layers.column?.values[0]).toBe(6)
    page.actions.coloring.colorBy('none')
    expect(page.view.layers.column).toBeUndefined()
  })
})

describe('the link of what is shown', () => {
  const link = () => page.actions.opening.linkState()
  const keys = () => Object.keys(link() ?? {})

  it('is the name of a data set with what was edited, or the circles', async () => {
    await page.actions.data.load('spruces')
    expect(link()).toEqual({ dataSet: 'spruces' })
    const circle = { x: 1, y: 1, r: 1 }
    await page.editing.edit([{ kind: 'replace', id: 0, circle }])
    expect(link()).toMatchObject({ dataSet: 'spruces', edits: [{ kind: 'replace', id: 0, circle }] })
    await page.actions.identity.setName(1, 'A')
    expect(keys()).toEqual(expect.arrayContaining(['circles', 'attributes']))
    await open(THREE)
    expect(link()).toEqual({ circles: THREE })
  })

  it.each<[string, () => unknown, readonly string[]]>([
    ['the viewport', () => page.actions.camera.showView({ x: 7, y: 1, span: 3 }), ['view']],
    ['layers', () => page.view.setLayers({ hull: true }), ['layers']],
    ['a step', () => showStep(page.store, 0, 'auto'), ['step', 'method']],
    ['periods', () => page.actions.domain.setLattice(LATTICE), ['lattice']],
    ['a region', () => page.actions.circles.setDomain({ region: REGION }), ['region']],
    ['areas', () => page.actions.circles.setDomain({ region: REGION, areas: [1, 2, 3] }), ['region', 'areas']],
  ])('has %s where that differs from what is usual', async (_, change, names) => {
    await open(THREE)
    await change()
    await quiet()
    expect(
      keys().filter((name) => !['circles', 'colors'].includes(name) && (name !== 'view' || names.includes(name))),
    ).toEqual(names)
    showStep(page.store, undefined)
  })
})
