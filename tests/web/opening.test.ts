// SPDX-License-Identifier: GPL-3.0-or-later
// Openings that follow each other before the first is done.
import { beforeEach, describe, expect, it, vi } from 'vitest'
import { PageActions } from '../../web/app/page-actions.ts'
import { Editing } from '../../web/editing/editing.ts'
import { EditorActions } from '../../web/editing/editor-actions.ts'
import type { OpenRequest } from '../../web/editing/opening-actions.ts'
import { INITIAL_STATE } from '../../web/editing/state.ts'
import { createStore } from '../../web/editing/store.ts'
import { encodeLink } from '../../web/lib/link.ts'
import type { Camera } from '../../web/view/camera.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import type { View } from '../../web/view/view.ts'
import { LibraryBackend } from './library-backend.ts'

const FIRST = { ...opened(0, 0, 1, 5, 5, 2), edits: [{ kind: 'remove' as const, id: 0 }], layers: { hull: true } }
const SECOND = opened(1, 1, 1, 2, 2, 2, 3, 3, 3)
const REFUSED = opened(0, 0, -1)

function opened(...circles: number[]): OpenRequest {
  return { circles: Float64Array.from(circles), dataSet: '', isEdited: false }
}

/** Actions on a view that computes a turn later. */
function started() {
  const later = () => new Promise((resolve) => setTimeout(resolve))
  const view = {
    camera: { x: 0, y: 0, scale: 1 } as Camera,
    size: { width: 100, height: 100 },
    layers: DEFAULT_LAYERS,
    setCamera(camera: Camera) {
      view.camera = camera
    },
    setLayers(layers: object) {
      view.layers = { ...view.layers, ...layers }
    },
  }
  const store = createStore(INITIAL_STATE)
  const editing = new Editing(
    new LibraryBackend(later),
    () => {},
    ({ message }) => store.update((state) => ({ ...state, problem: message })),
  )
  const actions = new EditorActions(store, editing, view as unknown as View, () => ({
    ...{ top: 0, right: 0, bottom: 0, left: 0 },
  }))
  return { actions, editing, store, view, circles: () => [...editing.circles.circles()] }
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
    for (let k = 0; k < 10; k++) await Promise.resolve()
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
    expect(await actions.open(async () => REFUSED)).toBe('refused')
    expect([circles(), view.camera]).toEqual([[1, 1, 1, 2, 2, 2, 3, 3, 3], before])
    expect(store.get().problem).toMatch(/Circle 0 .*radius/)
  })

  it('that fails too late is not told of', async () => {
    const { actions, store } = started()
    const failing = Promise.reject(new Error('It could not be loaded.'))
    const [first, second] = await Promise.all([actions.open(() => failing), actions.open(async () => SECOND)])
    expect([first, second, store.get().problem]).toEqual(['superseded', 'opened', ''])
  })

  it('is superseded at once by what is opened after it, or canceled, though it is never loaded', async () => {
    const { actions, view, circles } = started()
    const never = () => new Promise<OpenRequest>(() => {})
    const first = actions.open(never)
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

describe('what the page opens', () => {
  it('by a link that has circles is not edited, and by one that names a data set has its name', async () => {
    const { editing, store, view } = started()
    const made: unknown[] = []
    const padding = () => ({ top: 0, right: 0, bottom: 0, left: 0 })
    const page = new PageActions(store, editing, view as unknown as View, padding, {
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
