// SPDX-License-Identifier: GPL-3.0-or-later
// A figure without a browser: a view without pixels, and no gestures, keys or player.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { EditorActions } from '../../web/editing/editor-actions.ts'
import { Figure } from '../../web/player/figure.ts'
import { NO_PADDING } from '../../web/view/camera.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { Superseded } from '../../web/view/refusal.ts'
import { aTurn, sceneOf } from './editing-session.ts'
import { LibraryBackend } from './library-backend.ts'

const world = vi.hoisted(() => ({
  view: undefined as unknown,
  calls: [] as string[],
  signal: undefined as unknown,
  keys: [] as readonly unknown[],
  pointer: [] as readonly unknown[],
  said: [] as readonly unknown[],
}))
vi.mock('../../web/view/mount.ts', () => ({ mount: () => world.view }))
vi.mock('../../web/view/pointer.ts', () => ({
  listenToPointer: (...args: unknown[]) => {
    world.pointer = args
    return { stop: () => world.calls.push('pointer') }
  },
}))
vi.mock('../../web/editing/keyboard.ts', () => ({
  listenToKeyboard: (...args: readonly unknown[]) => {
    world.keys = args
    world.signal = (args[5] as { signal: unknown }).signal
  },
}))
vi.mock('../../web/editing/live-region.ts', () => ({
  mountLiveRegion: (...args: unknown[]) => {
    world.said = args
  },
}))
vi.mock('../../web/player/stepping.ts', () => ({
  Stepping: class {
    constructor(options: unknown) {
      Object.assign(world, { stepping: options })
    }
    dispose() {
      world.calls.push('stepping')
    }
  },
}))

const THREE = Float64Array.of(0, 0, 1, 5, 0, 2, 0, 9, 3)
let problems: string[]
/** The error of the next request in place of its answer. */
let failure: Error | undefined
/** The promise that each request waits for. */
let before: () => Promise<unknown>
const listeners = new Map<string, (data: unknown) => void>()

function started(place: object = {}, others: object = {}, more: object = {}): Figure {
  const backend = new LibraryBackend(async () => {
    await before()
    const error = failure
    failure = undefined
    if (error !== undefined) throw error
  })
  const view = Object.assign(backend, {
    camera: { x: 0, y: 0, scale: 1 },
    size: { width: 100, height: 100 },
    layers: DEFAULT_LAYERS as object,
    on: (name: string, listen: (data: unknown) => void) => listeners.set(name, listen),
    mark() {},
    choose() {},
    setIdentities() {},
    setCamera: (camera: never) => Object.assign(view, { camera }),
    setLayers: (layers: object) => Object.assign(view, { layers: { ...view.layers, ...layers } }),
    dispose: () => world.calls.push('view'),
  })
  world.view = view
  return new Figure({ figure: place, ...others } as never, {
    actions: (store, editing, view) => new EditorActions(store, editing, view, () => NO_PADDING),
    onoutcome() {},
    onproblem: ({ message }) => problems.push(message),
    played: () => ({}),
    ...more,
  })
}

beforeEach(() => {
  problems = []
  failure = undefined
  before = async () => {}
  world.calls.length = 0
  vi.stubGlobal('requestAnimationFrame', () => 0)
})
afterEach(() => vi.unstubAllGlobals())

const MISSING = [{ kind: 'remove', id: 9 }] as const
const DOMAIN = { region: undefined, lattice: undefined, areas: undefined }

it('what is refused is thrown and told, and a request that is superseded afterwards throws nothing old', async () => {
  const figure = started()
  await figure.open(sceneOf(THREE))
  const requests = [
    () => figure.open(sceneOf(Float64Array.of(0, 0, 1))),
    () => figure.change({ edits: [{ kind: 'remove', id: 1 }] }),
    () => figure.setDomain(DOMAIN),
  ]
  for (const [k, request] of requests.entries()) {
    const refused = await figure.change({ edits: MISSING }).catch((error) => error)
    expect(refused).toMatchObject({ circle: 9 })
    expect([figure.isTold(refused), figure.isTold(new Error())]).toEqual([true, false])
    expect(problems).toHaveLength(k + 1)
    failure = new Superseded()
    await request()
    expect(failure).toBeUndefined()
  }
  failure = new Error('It broke.')
  await expect(figure.open(sceneOf(THREE))).rejects.toThrow('It broke.')
  failure = new Error('It broke.')
  await expect(figure.setDomain(DOMAIN)).rejects.toThrow('It broke.')
  expect([...figure.editing.circles.circles()]).toEqual([...THREE])
})

it('a change waits for circles that are being opened, and keeps what it does not name', async () => {
  const figure = started()
  const { view, editing, store } = figure
  view.setLayers({ data: [{ id: 'own', color: 'red' }], hull: true })
  before = aTurn
  const opening = figure.open(sceneOf(THREE))
  const lattice = { a: [20, 0], b: [0, 20] } as const
  await figure.change({ edits: [{ kind: 'remove', id: 1 }], layers: { dual: true }, step: 4, method: 'auto', lattice })
  await opening
  expect(editing.circles.count).toBe(2)
  expect(view.layers).toMatchObject({ data: [{ id: 'own' }], dual: true, hull: false })
  expect(store.get()).toMatchObject({ step: 4, method: 'auto' })
  await figure.change({ areas: [1, 2] })
  expect(editing.domain).toMatchObject({ lattice })
  expect(editing.areas).toEqual([1, 2])
  await figure.change({ lattice: null })
  expect([editing.domain.lattice, editing.areas]).toEqual([undefined, [1, 2]])
  const { camera } = view
  await figure.change({ view: { x: 1, y: 2, span: 10 } })
  expect(view.camera).toMatchObject({ x: 1, y: 2 })
  expect(view.camera).not.toEqual(camera)
})

it('passes its options on to the player, the keys and the pointer', () => {
  const texts = { refusals: {}, player: { lang: 'xx' } }
  const options = { played: () => ({}), onstep: () => {}, keys: { a: () => {} }, words: () => texts }
  const [place, player, around] = [{}, {}, {}]
  const figure = started(place, { player, around }, options)
  const {
    container,
    store,
    actions,
    options: played,
    onstep,
    words,
    onproblem,
  } = (world as unknown as { stepping: Record<string, unknown> }).stepping
  expect([container, store, actions, played, onstep]).toEqual([
    player,
    figure.store,
    figure.actions,
    options.played,
    options.onstep,
  ])
  expect((words as () => unknown)()).toBe(texts.player)
  ;(onproblem as (error: Error) => void)(new Error('Too many.'))
  expect(problems).toEqual(['Too many.'])
  expect(world.keys.slice(0, 5)).toEqual([place, figure.view, figure.store, figure.actions, options.keys])
  expect(world.keys[5]).toMatchObject({ around })
  expect(world.pointer).toEqual([place, figure.view, figure.actions, { letsPageScroll: false }])
  expect(world.said).toEqual([figure.store, undefined, figure.actions])
})

it('changes nothing that a change does not name', async () => {
  const figure = started()
  await figure.open(sceneOf(THREE))
  const setDomain = vi.spyOn(figure.actions, 'setDomain')
  const look = vi.spyOn(figure.actions, 'look')
  const showStep = vi.spyOn(figure.actions, 'showStep')
  await figure.change({})
  await figure.change({ edits: [{ kind: 'remove', id: 1 }] })
  expect([setDomain, look, showStep].map(({ mock }) => mock.calls.length)).toEqual([0, 0, 0])
  const region = {
    type: 'Polygon',
    coordinates: [
      [
        [0, 0],
        [9, 0],
        [9, 9],
        [0, 0],
      ],
    ],
  } as const
  await figure.change({ region: region as never })
  expect(figure.editing.domain.region).toBeDefined()
  await figure.change({ areas: 'equal' })
  expect([figure.editing.domain.region !== undefined, figure.editing.areas]).toEqual([true, 'equal'])
  await figure.change({ region: null })
  expect([figure.editing.domain.region, figure.editing.areas]).toEqual([undefined, 'equal'])
})

it('a figure is painted once it says so, is not shown, or its tab is hidden, and then observes nothing', async () => {
  const observers: { change: () => void; isOn: boolean; filter: unknown }[] = []
  vi.stubGlobal(
    'MutationObserver',
    class {
      change: () => void
      isOn = false
      filter: unknown
      constructor(change: () => void) {
        this.change = change
        observers.push(this)
      }
      observe(_: unknown, options: unknown) {
        this.isOn = true
        this.filter = options
      }
      disconnect() {
        this.isOn = false
      }
    },
  )
  const page = Object.assign(new EventTarget(), { visibilityState: 'visible' })
  vi.stubGlobal('document', page)
  let frame = () => {}
  vi.stubGlobal('requestAnimationFrame', (act: () => void) => {
    frame = act
  })
  const place = { ariaBusy: 'true' }
  const figure = started(place)
  const view = figure.view as unknown as { isShown: boolean; size: { width: number } }
  Object.assign(view, { isShown: true })
  for (const [busy, painted] of [
    [() => (place.ariaBusy = 'true'), () => (place.ariaBusy = 'false')],
    [() => (view.isShown = true), () => (view.isShown = false)],
    [() => (view.size = { width: 9 }), () => (view.size = { width: 0 })],
    [() => (page.visibilityState = 'visible'), () => (page.visibilityState = 'hidden')],
  ] as const) {
    Object.assign(place, { ariaBusy: 'true' })
    view.isShown = true
    view.size = { width: 9 }
    page.visibilityState = 'visible'
    for (const tell of [() => observers.at(-1)?.change(), () => page.dispatchEvent(new Event('visibilitychange'))]) {
      busy()
      let isPainted = false
      const done = figure.whenPainted().then(() => {
        isPainted = true
      })
      // A change that was just made may not have begun to be painted.
      painted()
      await aTurn()
      expect(isPainted).toBe(false)
      busy()
      frame()
      tell()
      await aTurn()
      expect([isPainted, observers.at(-1)?.isOn, observers.at(-1)?.filter]).toEqual([
        false,
        true,
        { attributeFilter: ['aria-busy'] },
      ])
      painted()
      tell()
      await done
      expect(observers.at(-1)?.isOn).toBe(false)
    }
  }
})

it('a figure that is disposed of listens to nothing, and tells no problem', async () => {
  const figure = started()
  await figure.open(sceneOf(THREE))
  figure.dispose()
  expect(world.calls.sort()).toEqual(['pointer', 'stepping', 'view'])
  expect((world.signal as AbortSignal).aborted).toBe(true)
  listeners.get('failed')?.({ error: new Error('It broke.'), marks: false })
  expect([problems, figure.store.get().problem]).toEqual([[], ''])
})
