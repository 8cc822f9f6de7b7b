// SPDX-License-Identifier: GPL-3.0-or-later
// The actions of the page beyond those of a figure: areas, boxes, colors and data sets.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { NOT_LOADED } from '../../web/app/not-loaded.ts'
import { PageActions } from '../../web/app/page-actions.ts'
import { namedAs } from '../../web/editing/attributes.ts'
import type { Outcome } from '../../web/editing/editing.ts'
import type { Stage } from '../../web/editing/opening-actions.ts'
import { encodeLink } from '../../web/lib/link.ts'
import { NO_PADDING } from '../../web/view/camera.ts'
import { editingSession, sceneOf } from './editing-session.ts'

const THREE = Float64Array.of(0, 0, 1, 10, 0, 2, 0, 20, 3)
const REGION = [
  [
    [-50, -50],
    [50, -50],
    [0, 90],
  ],
] as const
const LATTICE = { a: [40, 0], b: [0, 40] } as const

beforeEach(() => vi.stubGlobal('requestAnimationFrame', (act: () => void) => queueMicrotask(act)))
afterEach(() => vi.unstubAllGlobals())

async function started(circles = THREE, more: object = {}) {
  const session = editingSession()
  const { store, editing, view, fake } = session
  const asked: unknown[] = []
  const reader = {
    call: async (...what: unknown[]) => {
      asked.push(what)
      return Float64Array.of(1, 2, 3)
    },
    cancel: () => asked.push('cancel'),
  }
  const actions = new PageActions(store, editing, view, () => NO_PADDING, reader as never)
  Object.assign(fake, { cancel: () => true })
  await actions.open(async () => ({ ...sceneOf(circles), ...more }))
  const stages: [Stage, number][] = []
  actions.onstage = (stage, count) => stages.push([stage, count])
  const domain = () => editing.domain
  const radii = () => [...editing.circles.circles()].filter((_, k) => k % 3 === 2)
  /** Changes radii as fitting areas does. */
  const setRadii = (r: number) => {
    const edits = Array.from(editing.circles.ids(), (id) => {
      const { x, y } = editing.circles.get(id) as { x: number; y: number }
      return { kind: 'replace', id, circle: { x, y, r } } as const
    })
    return editing.edit(edits)
  }
  return { ...session, actions, asked, stages, domain, radii, setRadii }
}
const columnsOf = (columns: Record<string, string[]>) => ({
  attributes: { ...namedAs([]), columns: Object.entries(columns).map(([name, values]) => ({ name, values })) },
})

describe('areas', () => {
  it('replace radii, which are there again afterwards, also where areas are given twice', async () => {
    const { actions, radii, setRadii, domain } = await started()
    await actions.setDomain({ region: REGION })
    await actions.setAreas('equal')
    await setRadii(9)
    expect(actions.radii()).toEqual([1, 2, 3])
    await actions.setAreas([1, 2, 3])
    await setRadii(8)
    expect([actions.radii(), radii()]).toEqual([
      [1, 2, 3],
      [8, 8, 8],
    ])
    await actions.add([{ x: 5, y: 5, r: 4 }])
    expect(actions.radii(), 'a new circle has its own').toEqual([1, 2, 3, 4])
    await actions.setAreas(undefined)
    expect([domain().areas, radii()]).toEqual([undefined, [1, 2, 3, 4]])
    await setRadii(7)
    expect(actions.radii(), 'those of now').toEqual([7, 7, 7, 7])
    await actions.setAreas('equal')
    await setRadii(6)
    await actions.setAreas(undefined)
    expect(radii()).toEqual([7, 7, 7, 7])
    await actions.open(async () => sceneOf(Float64Array.of(0, 0, 1)))
    await actions.setAreas('equal')
    await actions.add([{ x: 9, y: 9, r: 2 }])
    expect(actions.radii(), 'not that of a former circle').toEqual([1, 2])
  })

  it('are given back with the region that is removed, in one step', async () => {
    const { actions, radii, setRadii, domain } = await started()
    await actions.setDomain({ region: REGION })
    await actions.setAreas('equal')
    await setRadii(9)
    await actions.removeRegion()
    expect([domain().region, domain().areas, radii()]).toEqual([undefined, undefined, [1, 2, 3]])
    await actions.undo()
    expect([domain().region !== undefined, domain().areas, radii()]).toEqual([true, 'equal', [9, 9, 9]])
    await actions.undo()
    await actions.undo()
    await actions.removeRegion()
    expect([domain().region, radii()]).toEqual([undefined, [1, 2, 3]])
  })

  it('by a column give the mean to circles without a number, and say how many there are', async () => {
    const { actions, editing, store } = await started(
      THREE,
      columnsOf({ n: ['2', '', '4'], wrong: ['2', '0', '4'], text: ['"a"', '', ''] }),
    )
    expect(actions.columns).toEqual(['n', 'wrong'])
    expect(await actions.setAreasBy('n')).toBe(1)
    expect(editing.areas).toEqual([2, 3, 4])
    expect(await actions.setAreasBy('wrong')).toBeUndefined()
    expect(store.get().problem).toBe('wrong: circle 1 has 0. Areas need numbers above 0.')
    expect(editing.areas).toEqual([2, 3, 4])
    await editing.setValues('n', new Map([[0, '-1']]))
    expect(await actions.setAreasBy('n')).toBeUndefined()
    expect(store.get().problem).toMatch(/^n: circle 0 has -1\./)
  })

  it('as shares of one cell keep the proportions of the others', async () => {
    const { actions, editing } = await started()
    expect(actions.shareOf(0)).toBeUndefined()
    await actions.setAreas('equal')
    expect(actions.shareOf(2)).toBe(1 / 3)
    await actions.setShare(1, 0.5)
    expect(editing.areas).toEqual([1, 2, 1])
    await actions.setAreas([1, 3, 4])
    await editing.edit([{ kind: 'remove', id: 0 }])
    await actions.setShare(2, 0.25)
    expect([editing.areas, actions.shareOf(1), actions.shareOf(2)]).toEqual([[3, 1], 0.75, 0.25])
  })
})

describe('the periodic box', () => {
  it('is around the circles, which move into it, and all are in view', async () => {
    const { actions, editing, domain } = await started(Float64Array.of(-50, 3, 1, -40, 3, 1))
    const look = vi.spyOn(actions, 'look')
    await actions.repeat()
    const { lattice } = domain()
    expect(lattice).toMatchObject({ a: [expect.any(Number), 0], b: [0, expect.any(Number)] })
    const [x = 0, , , other = 0] = editing.circles.circles()
    expect([x > 1, other - x]).toEqual([true, 10])
    expect(look.mock.calls).toEqual([[undefined]])
    await actions.setLattice(undefined)
    expect([domain().lattice, look.mock.calls.length]).toEqual([undefined, 1])
  })

  it('takes the place of a region and of areas, whose radii are there again', async () => {
    const { actions, radii, setRadii, domain } = await started()
    await actions.setDomain({ region: REGION })
    await actions.setAreas('equal')
    await setRadii(9)
    await actions.setLattice(LATTICE)
    expect([domain().lattice, domain().region, domain().areas, radii()]).toEqual([
      LATTICE,
      undefined,
      undefined,
      [1, 2, 3],
    ])
    await actions.undo()
    expect([domain().lattice, radii()]).toEqual([undefined, [9, 9, 9]])
  })

  it('moves no circles without need', async () => {
    const { actions, computer } = await started()
    const apply = vi.spyOn(computer, 'apply')
    await actions.setLattice(LATTICE)
    expect(apply.mock.lastCall?.[0]).toEqual([])
    await actions.setLattice(LATTICE, { x: 0, y: 1 })
    expect(apply.mock.lastCall?.[0]).toHaveLength(3)
  })

  it('that is refused changes nothing', async () => {
    const { actions, computer, domain } = await started()
    const look = vi.spyOn(actions, 'look')
    vi.spyOn(computer, 'apply').mockRejectedValueOnce(new Error('Parallel.'))
    await actions.setLattice(LATTICE)
    expect([domain().lattice, look.mock.calls]).toEqual([undefined, []])
  })
})

it('a change of the domain says its stage, and that it has ended, also if it is refused', async () => {
  const { actions, stages, computer } = await started()
  const changes = [
    [{ region: REGION }, 'clipping'],
    [{ areas: 'equal' }, 'fitting'],
    [{ areas: undefined }, 'clipping'],
    [{ region: undefined, lattice: LATTICE }, 'repeating'],
  ] as const
  for (const [change, stage] of changes) {
    await actions.setDomain(change)
    expect(stages.splice(0)).toEqual([
      [stage, 3],
      ['opened', 3],
    ])
  }
  vi.spyOn(computer, 'apply').mockRejectedValueOnce(new Error('It failed.'))
  await actions.setDomain({ region: REGION })
  expect(stages.at(-1)).toEqual(['opened', 3])
  stages.length = 0
  await expect(actions.setDomain({ region: 5 as never })).rejects.toThrow()
  expect(stages.map(([stage]) => stage)).toEqual(['clipping', 'opened'])
})

describe('undo', () => {
  it('takes back the last corner while a polygon is drawn, and else an edit', async () => {
    const { actions, editing } = await started()
    await actions.add([{ x: 50, y: 50, r: 1 }])
    const corners = { count: 1 }
    const drawn: unknown[] = []
    const pen = { undo: () => corners.count-- > 0, draw: (...what: unknown[]) => drawn.push(what) }
    actions.pen = pen as never
    actions.useTool('draw')
    await actions.undo()
    expect([editing.circles.count, corners.count]).toEqual([4, 0])
    await actions.undo()
    expect(editing.circles.count).toBe(3)
    await actions.redo()
    actions.useTool('select')
    corners.count = 1
    await actions.undo()
    expect([editing.circles.count, corners.count]).toEqual([3, 1])
    actions.draw('place', { x: 1, y: 2 }, 3)
    expect(drawn).toEqual([['place', { x: 1, y: 2 }, 3]])
  })
})

describe('colors by a column', () => {
  const COLUMNS = columnsOf({ n: ['5', '7', '9'], kind: ['"a"', '"b"', '"a"'] })

  it('have its numbers, and end with an unknown name', async () => {
    const { actions, fake } = await started(THREE, COLUMNS)
    actions.colorBy('n')
    expect(fake.layers.column).toEqual({ name: 'n', values: Float64Array.of(5, 7, 9) })
    actions.colorBy('none')
    expect(fake.layers.column).toBeUndefined()
  })

  it('come with circles that are opened', async () => {
    const { actions, fake } = await started()
    await actions.open(async () => ({ ...sceneOf(THREE), ...COLUMNS, layers: { column: 'kind' } }) as never)
    expect(fake.layers.column).toMatchObject({ name: 'kind', categories: ['a', 'b'] })
    const { column } = fake.layers
    const refused = { ...sceneOf(Float64Array.of(0, 0, -1)), ...COLUMNS, layers: { column: 'n' } } as never
    for (const load of [() => Promise.reject(new Error('no')), async () => refused]) {
      expect(await actions.open(load)).toBe('refused')
      expect(fake.layers.column).toBe(column)
    }
  })

  it('follow new circles, new values and an opening, and no other edit', async () => {
    const { actions, editing, fake } = await started(THREE, COLUMNS)
    const outcome = (more: object) =>
      ({ edited: { inserted: [] }, attributes: editing.attributes, isOpened: false, ...more }) as unknown as Outcome
    actions.colorBy('n')
    actions.followColumn(outcome({}))
    let { column } = fake.layers
    const isFollowed = (more: object) => {
      actions.followColumn(outcome(more))
      const isOther = fake.layers.column !== column
      column = fake.layers.column
      return isOther
    }
    expect(isFollowed({})).toBe(false)
    expect(isFollowed({ edited: { inserted: [3] } })).toBe(true)
    expect(isFollowed({ isOpened: true })).toBe(true)
    await editing.setValues('n', new Map([[0, '6']]))
    expect(isFollowed({})).toBe(true)
    expect(fake.layers.column?.values[0]).toBe(6)
    expect(isFollowed({})).toBe(false)
    actions.colorBy('none')
    column = undefined
    expect(isFollowed({ isOpened: true })).toBe(false)
  })
})

describe('the link of the state', () => {
  const keys = (state: object | undefined) => Object.keys(state ?? {})

  it('is none before circles are opened', () => {
    const { store, editing, view } = editingSession()
    const actions = new PageActions(store, editing, view, () => NO_PADDING, {} as never)
    expect([actions.linkState(), actions.hasOpened]).toEqual([undefined, false])
  })

  it('is the name of a data set, with what was edited, or the circles', async () => {
    const { actions, editing } = await started(THREE, { dataSet: 'spruces' })
    expect([actions.linkState(), actions.hasOpened]).toEqual([{ dataSet: 'spruces' }, true])
    const circle = { x: 1, y: 1, r: 1 }
    await editing.edit([{ kind: 'replace', id: 0, circle }])
    expect(actions.linkState()).toEqual({ dataSet: 'spruces', edits: [{ kind: 'replace', id: 0, circle }] })
    await actions.setName(1, 'A')
    expect(keys(actions.linkState())).toEqual(['circles', 'attributes'])
    const own = await started()
    expect(own.actions.linkState()).toEqual({ circles: THREE })
  })

  it('has the colors with circles and edits, not with the name alone', async () => {
    const { actions, editing } = await started(THREE, { dataSet: 'spruces', colors: '012' })
    expect(keys(actions.linkState())).toEqual(['dataSet'])
    await editing.edit([{ kind: 'remove', id: 0 }])
    expect(actions.linkState()).toMatchObject({ edits: [{ kind: 'remove', id: 0 }], colors: '012' })
    const own = await started(THREE, { colors: '012' })
    expect(own.actions.linkState()).toEqual({ circles: THREE, colors: '012' })
  })

  it('has each other part where it differs from what is usual', async () => {
    const { actions, fake, store } = await started()
    fake.camera = { ...fake.camera, x: 7 }
    expect(actions.linkState()).toEqual({
      circles: THREE,
      view: { x: 7, y: fake.camera.y, span: 100 / fake.camera.scale },
    })
    actions.look(undefined)
    fake.setLayers({ hull: true })
    expect(actions.linkState()).toEqual({ circles: THREE, layers: { hull: true } })
    fake.setLayers({ hull: false })
    store.update((state) => ({ ...state, step: 0, method: 'flip' }))
    expect(actions.linkState()).toEqual({ circles: THREE, step: 0, method: 'flip' })
    store.update((state) => ({ ...state, step: undefined }))
    await actions.setLattice(LATTICE)
    expect(keys(actions.linkState())).toEqual(['circles', 'lattice'])
    await actions.setDomain({ region: REGION })
    actions.look(undefined)
    expect(keys(actions.linkState())).toEqual(['circles', 'region'])
    await actions.setAreas('equal')
    actions.look(undefined)
    expect(actions.linkState()).toMatchObject({ areas: 'equal' })
    await actions.setDomain({ areas: [1, 2, 3] })
    expect(actions.linkState()).toMatchObject({ areas: [1, 2, 3], region: REGION })
  })

  it('has the circles of a data set whose areas are given one by one', async () => {
    const { actions } = await started(THREE, { dataSet: 'spruces' })
    await actions.setDomain({ areas: [1, 2, 3] })
    expect(keys(actions.linkState())).toEqual(['circles', 'areas'])
  })
})

describe('opening', () => {
  it('shows the method again from its first step if it is shown, or as the link says', async () => {
    const { actions, store } = await started()
    const shownAfter = async (more: object) => {
      await actions.open(async () => ({ ...sceneOf(THREE), ...more }))
      const { step, method, stage } = store.get()
      return [step, method, stage]
    }
    expect(await shownAfter({})).toEqual([undefined, undefined, undefined])
    store.update((state) => ({ ...state, step: 5, method: 'flip', stage: 'loading' }))
    expect(await shownAfter({})).toEqual([0, 'flip', undefined])
    expect(await shownAfter({ step: 3, method: 'other' })).toEqual([3, 'other', undefined])
    store.update((state) => ({ ...state, stage: 'loading' }))
    expect(await shownAfter({ step: undefined, method: undefined })).toEqual([undefined, undefined, undefined])
  })

  it('says each stage, clears the former problem, and selects the usual tool', async () => {
    const { actions, stages, store } = await started()
    actions.useTool('add')
    actions.complain('wrong')
    await actions.open(async () => {
      expect(store.get().problem).toBe('')
      return sceneOf(Float64Array.of(1, 2, 3))
    })
    expect([store.get().tool, stages.splice(0)]).toEqual([
      'select',
      [
        ['loading', 0],
        ['computing', 1],
        ['opened', 1],
      ],
    ])
    await actions.open(async () => sceneOf(Float64Array.of(1, 2, -3)))
    expect(stages.splice(0)).toEqual([
      ['loading', 0],
      ['computing', 1],
      ['refused', 1],
    ])
    await actions.open(() => Promise.reject(new Error('no')))
    expect([stages, store.get().problem]).toEqual([
      [
        ['loading', 0],
        ['refused', 1],
      ],
      'no',
    ])
  })

  it('a data set that is unknown is refused, and a random one is another each time', async () => {
    const { actions, asked, editing } = await started()
    expect(await actions.load('none')).toBe('refused')
    const random = vi.spyOn(Math, 'random').mockReturnValue(0.25)
    expect(await actions.load('random')).toBe('opened')
    random.mockReturnValue(0.5)
    expect(await actions.load('random-large')).toBe('opened')
    random.mockRestore()
    expect(asked).toEqual([
      ['make', { kind: 'family', family: 'dense', seed: 250_000, count: 300 }],
      ['make', { kind: 'family', family: 'dense', seed: 500_000, count: 10_000 }],
    ])
    expect(editing.scene).toMatchObject({ dataSet: 'dense:500000:10000', isEdited: false })
  })

  it('again generates the family with another seed, and nothing else', async () => {
    const { actions, asked, store } = await started()
    await actions.generateAgain()
    expect(asked).toEqual([])
    store.update((state) => ({ ...state, dataSet: 'grid:5:31' }))
    vi.spyOn(Math, 'random').mockReturnValueOnce(0.25)
    await actions.generateAgain()
    expect(asked).toEqual([['make', { kind: 'family', family: 'grid', seed: 250_000, count: 31 }]])
  })

  it('that is canceled ends the reader, too', async () => {
    const { actions, asked, fake, stages } = await started()
    const cancel = vi.spyOn(fake as never as { cancel(): boolean }, 'cancel')
    actions.cancelOpening()
    expect([asked, cancel.mock.calls.length, stages]).toEqual([['cancel'], 1, []])
    cancel.mockReturnValue(false)
    actions.cancelOpening()
    expect(stages).toEqual([['refused', 0]])
  })

  it('a link keeps its frame until a link without one', async () => {
    const { actions } = await started()
    expect(actions.frame).toBeUndefined()
    const circles = THREE
    const frame = { title: 'T', question: 'Q?' }
    await actions.openLink(await encodeLink({ circles, ...frame }))
    expect(actions.frame).toEqual(frame)
    await actions.openLink(await encodeLink({ circles }))
    expect(actions.frame).toBeUndefined()
  })

  it('a link has its domain, step, method and colors', async () => {
    const { actions, editing, store, domain } = await started()
    await actions.openLink(
      await encodeLink({ circles: THREE, region: REGION, areas: [1, 2, 3], step: 4, method: 'flip', colors: '012' }),
    )
    expect([domain().region, editing.areas, editing.scene?.colors]).toEqual([REGION, [1, 2, 3], '012'])
    expect(store.get()).toMatchObject({ step: 4, method: 'flip' })
    await actions.openLink(await encodeLink({ circles: THREE, lattice: LATTICE }))
    expect([domain().lattice, domain().region]).toEqual([LATTICE, undefined])
    expect(editing.scene).toMatchObject({ dataSet: '', isEdited: false })
  })

  it('a link of a data set has its region, unless the link has another one or none', async () => {
    const own = [
      [0, 0],
      [9, 0],
      [0, 9],
    ]
    vi.stubGlobal('document', { baseURI: 'https://a.example/' })
    vi.stubGlobal('fetch', async ({ href }: URL) => ({
      ok: true,
      text: async () => (href.endsWith('.csv') ? 'x,y,r\n1,1,1\n' : JSON.stringify([own])),
    }))
    const { actions, domain } = await started()
    const regionOf = async (more: object) => {
      expect(await actions.openLink(await encodeLink({ dataSet: 'cities', ...more }))).toBe('opened')
      return domain().region
    }
    expect(await regionOf({})).toEqual([own])
    expect(await regionOf({ region: REGION })).toEqual(REGION)
    expect(await regionOf({ region: null })).toBeUndefined()
  })

  it('offers a remedy', async () => {
    const { actions, store } = await started()
    const remedy = { problem: NOT_LOADED, label: 'Again', act() {} }
    actions.offer(remedy)
    expect(store.get().remedy).toBe(remedy)
  })
})
