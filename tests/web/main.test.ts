// SPDX-License-Identifier: GPL-3.0-or-later
// The start of the page: what is opened first, what is saved, and how its parts are connected. The parts note their calls.
// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { NOT_LOADED } from '../../web/app/not-loaded.ts'
import type { Outcome } from '../../web/editing/editing.ts'
import { element, openPage, stateOf } from './page-document.ts'
import { settled } from './turns.ts'

const world = vi.hoisted(() => {
  const done: unknown[][] = []
  /** The results of noted functions, by their names. */
  const results: Record<string, unknown> = {}
  /** The arguments of the last call of each noted function. */
  const last: Record<string, unknown[]> = {}
  const note =
    (name: string) =>
    (...values: unknown[]) => {
      done.push([name, ...values])
      last[name] = values
      const result = results[name]
      return typeof result === 'function' ? result(...values) : result
    }
  const noted = (...names: string[]) => Object.fromEntries(names.map((name) => [name, note(name)]))
  return { done, results, last, note, noted, parts: {} as Record<string, unknown>, isAddressNew: false }
})
vi.mock('../../web/player/figure.ts', () => ({
  Figure: class {
    readonly view = world.parts.view
    readonly store = world.parts.store
    readonly editing = 'editing'
    readonly actions = world.parts.actions
    constructor(...given: unknown[]) {
      world.last.Figure = given
    }
    whenPainted() {
      return world.results.whenPainted
    }
  },
}))
vi.mock('../../web/app/state-persistence.ts', () => ({
  StatePersistence: class {
    begin = world.note('begin')
    changed = world.note('changed')
    wasOpened = world.note('wasOpened')
    constructor(...given: unknown[]) {
      world.last.StatePersistence = given
    }
    get isAddressNew() {
      return world.isAddressNew
    }
  },
}))
vi.mock('../../web/app/region-pen.ts', () => ({
  RegionPen: class {
    key = world.note('penKey')
  },
}))
vi.mock('../../web/app/files/files-client.ts', () => ({ FilesClient: class {} }))
vi.mock('../../web/app/files/file-actions.ts', () => ({
  FileActions: class {
    openFile = world.note('openFile')
  },
}))
vi.mock('../../web/app/motion/motion.ts', () => ({ Motion: class {} }))
vi.mock('../../web/app/motion/radii.ts', () => ({ Radii: class {} }))
vi.mock('../../web/app/data-sets.ts', async (load) => ({ ...(await load<object>()), ...world.noted('askAhead') }))
vi.mock('../../web/app/style-sheets.ts', () => world.noted('styleSheetsLoaded'))
vi.mock('../../web/app/padding.ts', () => world.noted('paddingOfPage'))
vi.mock('../../web/app/arrange.ts', () => world.noted('arrangeAround'))
vi.mock('../../web/app/offline.ts', () => world.noted('workOffline'))
vi.mock('../../web/app/printing.ts', () => world.noted('printDrawing'))
vi.mock('../../web/app/motion/drift.ts', () => world.noted('driftAtStart'))
vi.mock('../../web/app/input/clipboard.ts', () => world.noted('listenToClipboard'))
vi.mock('../../web/app/input/dropping.ts', () => world.noted('listenToFiles'))
vi.mock('../../web/app/input/invalid-numbers.ts', () => world.noted('restoreInvalidNumbers'))
vi.mock('../../web/app/input/menu-key.ts', () => world.noted('listenToMenu'))
vi.mock('../../web/app/input/tabbing.ts', () => world.noted('markTabbing'))
vi.mock('../../web/app/panels/generate.ts', () => world.noted('mountGenerate'))
vi.mock('../../web/app/panels/group.ts', () => world.noted('mountGroup'))
vi.mock('../../web/app/panels/identity.ts', () => world.noted('mountIdentity'))
vi.mock('../../web/app/panels/inspector.ts', () => world.noted('mountInspector'))
vi.mock('../../web/app/panels/inspector-facts.ts', () => world.noted('mountInspectorFacts'))
vi.mock('../../web/app/panels/inspector-share.ts', () => world.noted('mountInspectorShare'))
vi.mock('../../web/app/panels/legend.ts', () => world.noted('mountLegend'))
vi.mock('../../web/app/panels/method.ts', () => world.noted('mountMethod'))
vi.mock('../../web/app/panels/names.ts', () => world.noted('mountNames'))
vi.mock('../../web/app/panels/one-line.ts', () => world.noted('mountOneLine'))
vi.mock('../../web/app/panels/panel.ts', () => world.noted('panelLater'))
vi.mock('../../web/app/panels/progress.ts', () => world.noted('mountProgress'))
vi.mock('../../web/app/panels/say.ts', () => world.noted('mountSay'))
vi.mock('../../web/app/panels/scale.ts', () => world.noted('mountScale'))
vi.mock('../../web/app/panels/status.ts', () => world.noted('mountStatus'))
vi.mock('../../web/app/panels/table.ts', () => world.noted('mountTable'))
vi.mock('../../web/app/panels/toolbar.ts', () => world.noted('mountToolbar'))
vi.mock('../../web/app/panels/trial.ts', () => world.noted('mountTrial'))
vi.mock('../../web/app/panels/view-controls.ts', () => world.noted('mountViewControls'))
vi.mock('../../web/app/panels/help.ts', () => world.noted('showHelp'))
vi.mock('../../web/app/panels/context-menu.ts', () => world.noted('contextMenu'))
vi.mock('../../web/app/panels/files.ts', () => world.noted('mountFiles'))
vi.mock('../../web/app/panels/share.ts', () => world.noted('mountShare'))
vi.mock('../../web/app/panels/layers.ts', () => world.noted('mountLayers'))
vi.mock('../../web/app/panels/numbers.ts', () => world.noted('mountNumbers'))
vi.mock('../../web/app/panels/motion.ts', () => world.noted('mountMotion'))
vi.mock('../../web/app/panels/region.ts', () => world.noted('mountRegion'))

beforeEach(() => {
  openPage()
  element('figure').innerHTML = '<div id="first-picture"></div>'
  world.done.length = 0
  for (const known of [world.results, world.last]) for (const name of Object.keys(known)) delete known[name]
  world.isAddressNew = false
})
afterEach(() => vi.unstubAllGlobals())

/** Starts the page at an address. `kept` is its saved link. */
async function started(
  hash = '',
  {
    kept,
    openLink = 'opened',
    load = 'opened',
    problem = '',
    hasOpened = false,
  }: {
    readonly kept?: string
    readonly openLink?: string
    readonly load?: string
    readonly problem?: string
    readonly hasOpened?: boolean
  } = {},
) {
  const { store, change } = stateOf()
  const removed: string[] = []
  const events = new Map<string, () => void>()
  const address = { hash }
  const window = new EventTarget()
  vi.stubGlobal('location', address)
  vi.stubGlobal('window', window)
  Object.assign(element('first-picture'), {
    remove() {
      removed.push('first picture')
      world.done.push(['remove'])
    },
  })
  let paint = () => {}
  Object.assign(world.results, {
    begin: Promise.resolve(kept),
    mountGenerate: { show: world.note('show'), open: 'open' },
    mountInspector: () => world.note('editNumbers'),
    mountMethod: () => world.note('played'),
    whenPainted: new Promise<void>((resolve) => {
      paint = resolve
    }),
    openLink: async () => {
      if (problem !== '') change({ problem })
      return openLink
    },
    load: async () => {
      change({ problem: '' })
      return load
    },
  })
  const actions = {
    hasOpened,
    pen: undefined,
    ...world.noted('openLink', 'load', 'complain', 'useTool', 'linkState', 'followColumn'),
  }
  world.parts = {
    store,
    actions,
    view: { circles: { get: () => undefined }, on: (name: string, act: () => void) => events.set(name, act) },
  }
  vi.resetModules()
  await import('../../web/app/main.ts')
  await settled()
  const [, options] = world.last.Figure as [
    unknown,
    Record<string, (...given: unknown[]) => unknown> & { keys: Record<string, (...given: unknown[]) => unknown> },
  ]
  const names = () => world.done.map(([name]) => name)
  const count = (name: string) => names().filter((other) => other === name).length
  const goTo = async (to: string) => {
    address.hash = to
    window.dispatchEvent(new Event('hashchange'))
    await settled()
  }
  return { store, change, removed, events, paint, options, names, count, goTo, actions }
}

describe('the first scene', () => {
  it('is the first data set, which is asked for early and is not saved; its picture stays until it is painted', async () => {
    const { removed, paint, options, count } = await started()
    expect(world.done.slice(0, 2)).toEqual([['askAhead', 'start'], ['styleSheetsLoaded']])
    expect(world.last.load).toEqual(['start'])
    expect([count('driftAtStart'), count('openLink'), removed]).toEqual([1, 0, []])
    expect(world.last.complain, 'no problem').toEqual([''])
    paint()
    await settled()
    expect(removed).toEqual(['first picture'])
    const outcome = {} as Outcome
    options.onoutcome?.(outcome)
    expect([count('changed'), world.last.followColumn]).toEqual([0, [outcome]])
    options.onoutcome?.(outcome)
    expect(count('changed')).toBe(1)
  })

  it('selects the moving circle at its place once it is home', async () => {
    const { change, store } = await started()
    change({ selection: [7], selected: 7, circle: { x: 1, y: 2, r: 3 } })
    const [, figure, onend] = world.last.driftAtStart as [unknown, unknown, () => void]
    expect(figure).toBe(element('figure'))
    onend()
    expect(store.get()).toMatchObject({ selection: [7], circle: undefined })
  })

  it('is the saved link', async () => {
    const { count } = await started('#v1.a', { kept: 'v1.b' })
    expect([world.last.openLink, count('load'), count('askAhead'), count('driftAtStart')]).toEqual([['v1.b'], 0, 0, 0])
    // The picture of another scene is removed at once.
    expect(world.done[0]).toEqual(['remove'])
    expect(count('changed')).toBe(0)
  })

  it('is the first data set with the problem of the link that was refused', async () => {
    const { count } = await started('#v1.a', { kept: 'v1.a', openLink: 'refused', problem: 'wrong link' })
    expect([world.last.load, world.last.complain, count('driftAtStart')]).toEqual([['start'], ['wrong link'], 1])
  })

  it('is what the user has opened meanwhile, which is saved', async () => {
    const { count, options, removed } = await started('', { kept: 'v1.b', hasOpened: true })
    expect([count('openLink'), count('load'), count('changed'), removed]).toEqual([0, 0, 1, ['first picture']])
    options.onoutcome?.({})
    expect(count('changed')).toBe(2)
    for (const [openLink, load, changes] of [
      ['superseded', 'opened', 1],
      ['refused', 'superseded', 0],
    ] as const) {
      world.done.length = 0
      const other = await started('', { kept: 'v1.b', openLink, load })
      expect([other.count('changed'), other.count('driftAtStart'), other.count('complain')]).toEqual([changes, 0, 0])
    }
  })
})

describe('an address', () => {
  it('is opened when it changes, and it is told whether it is shown', async () => {
    const { goTo } = await started('#v1.a', { kept: 'v1.a' })
    await goTo('#v1.b')
    expect([world.last.openLink, world.last.wasOpened]).toEqual([['#v1.b'], ['#v1.b', true]])
    world.results.openLink = async () => 'refused'
    await goTo('#v1.c')
    expect(world.last.wasOpened).toEqual(['#v1.c', false])
    await goTo('')
    expect([world.last.openLink, world.last.wasOpened]).toEqual([['#v1.c'], ['', true]])
  })

  it('that changes twice is told of once', async () => {
    const { goTo, count } = await started('#v1.a', { kept: 'v1.a' })
    const ends: ((how: string) => void)[] = []
    world.results.openLink = () => new Promise((resolve) => ends.push(resolve))
    await goTo('#v1.b')
    await goTo('#v1.c')
    ends[1]?.('opened')
    await settled()
    ends[0]?.('superseded')
    await settled()
    expect([count('wasOpened'), world.last.wasOpened]).toEqual([1, ['#v1.c', true]])
  })

  it('that has changed while the page was loading is opened', async () => {
    world.isAddressNew = true
    const { count, names } = await started('#v1.a', { kept: 'v1.b' })
    expect([count('openLink'), world.last.openLink, world.last.wasOpened]).toEqual([2, ['#v1.a'], ['#v1.a', true]])
    expect(names().indexOf('workOffline')).toBeGreaterThan(names().indexOf('wasOpened'))
  })
})

it('layers, the camera and the step are saved, and nothing else that is shown', async () => {
  const { events, change, count } = await started('#v1.a', { kept: 'v1.a' })
  for (const name of ['layers', 'camera']) events.get(name)?.()
  expect(count('changed')).toBe(2)
  change({ selection: [1] })
  expect(count('changed')).toBe(2)
  change({ step: 3 })
  change({ selection: [] })
  change({ step: 4 })
  expect(count('changed')).toBe(4)
  const [, state] = world.last.StatePersistence as [unknown, () => unknown]
  world.results.linkState = 'state'
  expect(state()).toBe('state')
  change({ dataSet: 'spruces' })
  expect(world.last.show).toEqual(['spruces'])
})

describe('the parts', () => {
  it('are there before the first circles, copied circles before files', async () => {
    const { names } = await started()
    const before = names().slice(0, names().indexOf('begin'))
    for (const name of [
      ...[
        'Generate',
        'Toolbar',
        'Trial',
        'ViewControls',
        'Status',
        'Progress',
        'Legend',
        'Say',
        'Inspector',
        'Identity',
      ],
      ...['InspectorFacts', 'InspectorShare', 'Group', 'OneLine', 'Table', 'Method', 'Scale', 'Names'],
    ]) {
      expect(before).toContain(`mount${name}`)
    }
    for (const name of ['restoreInvalidNumbers', 'markTabbing', 'listenToMenu']) expect(before).toContain(name)
    expect(before.indexOf('listenToClipboard')).toBeLessThan(before.indexOf('listenToFiles'))
    expect([names().includes('arrangeAround'), world.last.mountToolbar?.[2]]).toEqual([true, 'open'])
  })

  it('that are loaded later are mounted with what they need', async () => {
    const { store, options, actions } = await started()
    const later = world.done.filter(([name]) => name === 'panelLater') as [
      string,
      string,
      (problem: string) => void,
      () => Promise<void>,
    ][]
    expect(later.map(([, id]) => id)).toEqual(['files', 'share', 'layers', 'numbers', 'motion', 'region'])
    for (const [, id, complain, mount] of later) {
      await mount()
      complain(`no ${id}`)
      expect(world.last.complain).toEqual([`no ${id}`])
    }
    const files = world.last.mountFiles?.[0]
    expect(files).toHaveProperty('openFile')
    expect(world.last.mountShare?.slice(0, 5)).toEqual([files, store, 'editing', world.parts.view, actions])
    options.onstep?.(3, 8)
    const [, , , , , motion, steps] = world.last.mountShare ?? []
    expect((steps as () => number)()).toBe(8)
    expect(motion).toBe(world.last.mountLayers?.[3])
    expect(world.last.mountLayers?.slice(0, 3)).toEqual([store, actions, world.parts.view])
    expect(world.last.mountNumbers).toEqual([store, world.parts.view])
    expect(world.last.mountMotion).toEqual([world.last.mountLayers?.[3], world.parts.view, actions])
    expect(world.last.mountRegion).toEqual([store, actions, files, actions.pen])
  })

  it('have keys: numbers, help, the pen and the region', async () => {
    const { options } = await started()
    const { editNumbers, showHelp, drawKey, drawRegion } = options.keys
    world.results.penKey = true
    editNumbers?.()
    expect(world.last.editNumbers).toEqual([])
    expect([drawKey?.('Enter', 3), world.last.penKey]).toEqual([true, ['Enter', 3]])
    drawRegion?.()
    expect(world.last.useTool).toEqual(['draw'])
    await showHelp?.()
    expect(world.last.showHelp).toEqual([])
    element('show-help').click()
    await vi.dynamicImportSettled()
    expect(world.done.filter(([name]) => name === 'showHelp')).toHaveLength(2)
    expect([options.played?.('flip'), world.last.played]).toEqual([undefined, ['flip']])
  })

  it('open the menu at a place, whose first item moves the focus to the name', async () => {
    const { change } = await started()
    const [figure, , selected, open] = world.last.listenToMenu as [
      unknown,
      unknown,
      () => unknown,
      (at: unknown) => Promise<void>,
    ]
    change({ circle: { x: 1, y: 2, r: 3 } })
    expect([figure, selected()]).toEqual([element('figure'), { x: 1, y: 2, r: 3 }])
    world.results.contextMenu = () => world.note('menu')
    for (const at of [
      { x: 1, y: 2 },
      { x: 3, y: 4 },
    ]) {
      await open(at)
      expect(world.last.menu).toEqual([at])
    }
    expect(
      world.done.filter(([name]) => name === 'contextMenu'),
      'made once',
    ).toHaveLength(1)
    const [, , , name] = world.last.contextMenu ?? []
    ;(name as () => void)()
    expect(document.activeElement).toBe(element('field-name'))
  })

  it('open a photo of the caption, and say that a part was not loaded', async () => {
    await started()
    const [, open] = world.last.mountSay as [unknown, (file: string) => Promise<void>]
    await open('a.png')
    expect(world.last.openFile).toEqual(['a.png'])
    world.results.contextMenu = () => {
      throw new Error('no network')
    }
    const [, , , menu] = world.last.listenToMenu as [unknown, unknown, unknown, (at: unknown) => Promise<void>]
    await menu({ x: 1, y: 2 })
    expect(world.last.complain).toEqual([NOT_LOADED])
  })
})
