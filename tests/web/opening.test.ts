// SPDX-License-Identifier: GPL-3.0-or-later
// Openings that follow each other before the first is done.
import { beforeEach, describe, expect, it, vi } from 'vitest'
import { PageActions } from '../../web/app/page-actions.ts'
import type { OpenRequest } from '../../web/editing/opening-actions.ts'
import { encodeLink } from '../../web/lib/link.ts'
import { NO_PADDING } from '../../web/view/camera.ts'
import { aTurn, editingSession, sceneOf } from './editing-session.ts'
import { box } from './shapes.ts'
import { settled } from './turns.ts'

const FIRST = { ...opened(0, 0, 1, 5, 5, 2), edits: [{ kind: 'remove' as const, id: 0 }], layers: { hull: true } }
const SECOND = opened(1, 1, 1, 2, 2, 2, 3, 3, 3)
const REFUSED = opened(0, 0, -1)

function opened(...circles: number[]): OpenRequest {
  return sceneOf(Float64Array.from(circles))
}

/** Actions on a view that computes a turn later. */
function started() {
  return editingSession({ before: aTurn })
}

beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', () => {})
})

describe('what is opened', () => {
  it('has its edits and layers', async () => {
    const { actions, view, circles } = started()
    expect(actions.hasOpened).toBe(false)
    expect(await actions.open(async () => FIRST)).toBe('opened')
    expect([actions.hasOpened, circles(), view.layers.hull]).toEqual([true, [5, 5, 2], true])
  })

  it('keeps a selection that is made before its edits are applied', async () => {
    const { actions, editing, store } = editingSession({
      async before() {
        if (editing.circles.get(1)?.y === 5) actions.select([1])
      },
    })
    const edits = [{ kind: 'replace' as const, id: 1, circle: { x: 5, y: 6, r: 2 } }]
    await actions.open(async () => ({ ...opened(0, 0, 1, 5, 5, 2), edits }))
    expect(store.get()).toMatchObject({ selection: [1], circle: { x: 5, y: 6, r: 2 } })
  })

  it('keeps its edits and layers from what is opened after it', async () => {
    const { actions, store, view, circles } = started()
    const [first, second] = await Promise.all([actions.open(async () => FIRST), actions.open(async () => SECOND)])
    expect([first, second]).toEqual(['superseded', 'opened'])
    expect([circles(), view.layers.hull, store.get().problem]).toEqual([[1, 1, 1, 2, 2, 2, 3, 3, 3], false, ''])
  })

  it('keeps its edits from what is opened while it is computed', async () => {
    const { actions, editing, view, circles } = started()
    const first = actions.open(async () => FIRST)
    // Loading is over by then; computing takes another turn.
    await settled()
    const second = actions.open(async () => SECOND)
    expect([await first, await second]).toEqual(['superseded', 'opened'])
    expect([circles(), view.layers.hull]).toEqual([[1, 1, 1, 2, 2, 2, 3, 3, 3], false])
    await editing.undo()
    expect(circles()).toEqual([5, 5, 2])
  })

  it('changes nothing where it is refused, not even what is looked at', async () => {
    const { actions, store, view, circles } = started()
    await actions.open(async () => SECOND)
    const before = view.camera
    actions.select([1])
    expect(await actions.open(async () => REFUSED)).toBe('refused')
    expect([circles(), view.camera, store.get().selection]).toEqual([[1, 1, 1, 2, 2, 2, 3, 3, 3], before, [1]])
    expect(store.get().problem).toMatch(/Circle 0 .*radius/)
  })

  it('forgets the layers that name places among the former circles', async () => {
    const { actions, view } = started()
    await actions.open(async () => SECOND)
    const path = { from: { x: 1, y: 1 }, to: { x: 2, y: 2 } }
    view.setLayers({ path, nearZero: 1, maxDistance: 2, hull: true })
    await actions.open(async () => opened(50, 50, 1, 90, 50, 2))
    const { hull, nearZero, maxDistance } = view.layers
    expect([hull, nearZero, maxDistance]).toEqual([true, undefined, undefined])
    expect(view.layers.path).toEqual(actions.pathAcross())
    view.setLayers({ path: undefined })
    await actions.open(async () => SECOND)
    expect(view.layers.path).toBeUndefined()
  })

  it('leaves layers alone that name no places, and has the path across the picture again', async () => {
    const { actions, fake } = editingSession({ before: aTurn, size: { width: 200, height: 100 } })
    const setLayers = vi.spyOn(fake, 'setLayers')
    await actions.open(async () => SECOND)
    expect(setLayers).not.toHaveBeenCalled()
    for (const [name, value] of [
      ['nearZero', 0.5],
      ['maxDistance', 3],
      ['path', { from: { x: 0, y: 0 }, to: { x: 1, y: 1 } }],
    ] as const) {
      fake.setLayers({ [name]: value })
      await actions.open(async () => SECOND)
      const { nearZero, maxDistance, path } = fake.layers
      expect([nearZero, maxDistance, path]).toEqual([
        undefined,
        undefined,
        name === 'path' ? actions.pathAcross() : undefined,
      ])
    }
    fake.camera = { x: 3, y: 4, scale: 2 }
    expect(actions.pathAcross()).toEqual({ from: { x: -27, y: 4 }, to: { x: 33, y: 4 } })
  })

  it('is in view beside a panel that opens meanwhile, unless the camera was moved', async () => {
    for (const isMoved of [false, true]) {
      const padding = { top: 0, right: 0, bottom: 0, left: 0 }
      const { actions, fake, editing, store } = editingSession({ before: aTurn, padding })
      actions.select([0])
      const opening = actions.open(async () => SECOND)
      await settled()
      expect(fake.camera.x).toBe(3)
      expect(store.get().selection, 'of the former circles').toEqual([])
      const camera = { x: 7, y: 8, scale: 9 }
      if (isMoved) fake.camera = camera
      Object.assign(padding, { left: 50 })
      await opening
      expect(editing.circles.count).toBe(3)
      // The panel covers half of the picture.
      if (isMoved) expect(fake.camera).toEqual(camera)
      else expect(fake.camera.x).toBeLessThan(3)
    }
  })

  it('that fails too late is not told of', async () => {
    const { actions, store } = started()
    const failing = Promise.reject(new Error('It could not be loaded.'))
    const [first, second] = await Promise.all([actions.open(() => failing), actions.open(async () => SECOND)])
    expect([first, second, store.get().problem]).toEqual(['superseded', 'opened', ''])
  })

  it('is superseded at once by what is opened after it, or canceled, though it is never loaded', async () => {
    const { actions, store, view, circles } = started()
    const never = () => new Promise<OpenRequest>(() => {})
    actions.complain('It could not be opened.')
    const first = actions.open(never)
    expect(store.get().problem).toBe('')
    expect(await actions.open(async () => SECOND)).toBe('opened')
    expect(await first).toBe('superseded')
    const third = actions.open(never)
    Object.assign(view, { cancel: () => false })
    actions.cancelOpening()
    expect(await third).toBe('superseded')
    expect(circles()).toEqual([1, 1, 1, 2, 2, 2, 3, 3, 3])
  })
})

describe('the next circle', () => {
  it('is the next number that there is, or the one before, and none beyond the last', async () => {
    const { actions, editing, store } = started()
    await actions.open(async () => SECOND)
    await editing.edit([{ kind: 'remove', id: 1 }])
    expect(actions.selectNext(1)).toBe(false)
    actions.select([0])
    const selected = () => store.get().selection
    expect([actions.selectNext(1), selected()]).toEqual([true, [2]])
    expect([actions.selectNext(1), selected()]).toEqual([false, [2]])
    expect([actions.selectNext(-1), selected()]).toEqual([true, [0]])
    expect([actions.selectNext(-1), selected()]).toEqual([false, [0]])
  })
})

it('the number of several selected circles, or of none, is said', async () => {
  const { actions, store } = started()
  await actions.open(async () => SECOND)
  const said = (select: () => void) => {
    store.update((state) => ({ ...state, said: { text: '' } }))
    select()
    return store.get().said.text
  }
  const within = (minX: number, maxX: number) => () => actions.selectWithin({ minX, minY: 0, maxX, maxY: 9 })
  expect(said(within(8, 9))).toBe('0 circles selected')
  // A circle alone is described.
  expect(said(within(0.5, 1.5))).toBe('')
  expect(said(within(1.5, 2.5))).toBe('2 circles selected')
  expect(said(() => actions.selectAll())).toBe('3 circles selected')
})

it('a region ends the repetition in a box, and a box ends the region', async () => {
  const { editing, store, view } = started()
  const files = { call: () => Promise.reject(new Error()), cancel() {} }
  const page = new PageActions(store, editing, view, () => NO_PADDING, files)
  await page.open(async () => SECOND)
  const lattice = { a: [9, 0], b: [0, 9] } as const
  const region = [box(0, 0, 9, 9)]
  const domainAfter = async (changed: Promise<unknown>) => {
    await changed
    return [editing.domain.region, editing.domain.lattice]
  }
  expect(await domainAfter(page.setDomain({ region }))).toEqual([region, undefined])
  expect(await domainAfter(page.setLattice(lattice))).toEqual([undefined, lattice])
  expect(await domainAfter(page.setDomain({ areas: [1, 2, 3] }))).toEqual([undefined, lattice])
  expect(await domainAfter(page.setDomain({ region }))).toEqual([region, undefined])
})

describe('what the page opens', () => {
  it.each([
    ['figure', 'figure-15a', 'huge', { x: 12.5, y: 22, across: 7 }],
    ['figure', 'figure-15a', 'small', { x: 12.5, y: 22, across: 6 }],
    ['family', 'grid:5:31', 'huge', { x: -1492.25, y: 0, across: 3015.5 }],
  ] as const)('by a recipe is seen as a whole, but for a huge circle beside a figure: %s %s %s', async (...given) => {
    const [kind, name, largest, seen] = given
    const { editing, store, view, fake } = started()
    const small = Array.from({ length: 30 }, (_, k) => [10 + (k % 6), 20 + Math.floor(k / 6), 0.5])
    const circles = Float64Array.from([...small, ...(largest === 'huge' ? [[-2000, 0, 1000]] : [])].flat())
    const files = { call: async () => circles as never, cancel() {} }
    const page = new PageActions(store, editing, view, () => NO_PADDING, files)
    await page.generate(kind === 'figure' ? { kind, figure: '15a' } : { kind, family: 'grid', seed: 5, count: 31 })
    expect(editing.scene).toMatchObject({ dataSet: name, circles })
    const { x, y, scale } = fake.camera
    expect([x, y, 100 / scale]).toEqual([seen.x, seen.y, seen.across].map((value) => expect.closeTo(value)))
  })

  it('by a link that has circles is not edited, and by one that names a data set has its name', async () => {
    const { editing, store, view } = started()
    const made: unknown[] = []
    const page = new PageActions(store, editing, view, () => NO_PADDING, {
      call: async (_, ...args) => {
        made.push(args[0])
        return Float64Array.of(1, 2, 3) as never
      },
      cancel: () => {},
    })
    expect(await page.openLink(await encodeLink({ circles: Float64Array.of(4, 5, 6) }))).toBe('opened')
    expect(editing.scene).toEqual({ circles: Float64Array.of(4, 5, 6), dataSet: '', isEdited: false })
    expect(await page.openLink(await encodeLink({ dataSet: 'grid:5:9' }))).toBe('opened')
    expect(editing.scene).toEqual({ circles: Float64Array.of(1, 2, 3), dataSet: 'grid:5:9', isEdited: false })
    expect(made).toEqual([{ kind: 'family', family: 'grid', seed: 5, count: 9 }])
    expect(await page.openRead(async () => ({ circles: Float64Array.of(7, 8, 9) }) as never)).toBe('opened')
    expect(editing.scene).toEqual({ circles: Float64Array.of(7, 8, 9), dataSet: '', isEdited: false })
    expect(await page.openLink('v1.none')).toBe('refused')
  })
})
