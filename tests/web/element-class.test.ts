// SPDX-License-Identifier: GPL-3.0-or-later
// The class of <circle-voronoi> without a browser: a base class with attributes and events, a shell without nodes, and a
// figure whose view has no pixels.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { EditorActions } from '../../web/editing/editor-actions.ts'
import { CircleVoronoiElement } from '../../web/element/circle-voronoi-element.ts'
import { defineCircleVoronoi } from '../../web/element/define.ts'
import { loadWords } from '../../web/element/language.ts'
import { CircleVoronoiError } from '../../web/lib/index.ts'
import { encodeLink } from '../../web/lib/link.ts'
import type { Figure } from '../../web/player/figure.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { aTurn, eventually } from './editing-session.ts'
import { LibraryBackend } from './library-backend.ts'

type Listen = (data: unknown) => void

const world = vi.hoisted(() => {
  class FakeElement extends EventTarget {
    isConnected = false
    readonly localName = 'circle-voronoi'
    readonly baseURI = 'https://example.org/page/'
    parentElement = null
    childNodes: { nodeType: number; textContent: string }[] = []
    readonly attributes = new Map<string, string>()
    readonly around = { isForm: true }
    readonly internals = {
      form: undefined as object | null | undefined,
      values: [] as string[],
      validities: [] as unknown[][],
      states: new Set<string>(),
      validationMessage: 'message',
      setFormValue: (value: string) => this.internals.values.push(value),
      setValidity: (...validity: unknown[]) => this.internals.validities.push(validity),
      checkValidity: () => 'checked',
      reportValidity: () => 'reported',
    }
    attachInternals() {
      this.internals.form = this.around
      return this.internals
    }
    attachShadow() {
      return {}
    }
    getAttribute(name: string) {
      return this.attributes.get(name) ?? null
    }
    hasAttribute(name: string) {
      return this.attributes.has(name)
    }
    setAttribute(name: string, value: string) {
      this.attributes.set(name, value)
      this.#changed(name)
    }
    removeAttribute(name: string) {
      if (this.attributes.delete(name)) this.#changed(name)
    }
    toggleAttribute(name: string, isSet: boolean) {
      if (!isSet) this.removeAttribute(name)
      else if (!this.hasAttribute(name)) this.setAttribute(name, '')
    }
    #changed(name: string) {
      const { observedAttributes } = this.constructor as unknown as { observedAttributes: readonly string[] }
      const { attributeChangedCallback } = this as unknown as { attributeChangedCallback(name: string): void }
      if (observedAttributes.includes(name)) attributeChangedCallback.call(this, name)
    }
    closest(): unknown {
      return this.hasAttribute('lang') ? this : null
    }
    getRootNode(): unknown {
      return undefined
    }
    querySelector() {
      return null
    }
  }
  Object.assign(globalThis, { HTMLElement: FakeElement, ShadowRoot: class {} })
  return {
    views: [] as unknown[],
    shells: [] as unknown[],
    papers: [] as { calls: string[]; draw: () => Promise<string> }[],
    calls: [] as string[],
    /** The options of the listeners to pointer and keyboard. */
    listening: [] as unknown[],
    idle: [] as (() => void)[],
    sights: [] as ((sight: string) => void)[],
    observers: [] as { change: () => void; isOn: boolean; options: unknown }[],
    isPressed: false,
    mounted: [] as unknown[][],
    makeView: (): unknown => undefined,
  }
})
vi.mock('../../web/view/mount.ts', () => ({
  mount: (_: unknown, load: unknown) => {
    const view = world.makeView()
    Object.assign(view as object, { load })
    world.views.push(view)
    return view
  },
}))
vi.mock('../../web/view/pointer.ts', () => ({
  listenToPointer: (...given: unknown[]) => {
    world.listening.push(given.at(-1))
    return {
      get isPressed() {
        return world.isPressed
      },
      stop: () => world.calls.push('pointer stopped'),
    }
  },
}))
vi.mock('../../web/editing/keyboard.ts', () => ({
  listenToKeyboard: (...given: unknown[]) => world.listening.push(given.at(-1)),
}))
vi.mock('../../web/editing/live-region.ts', () => ({ mountLiveRegion() {} }))
vi.mock('../../web/player/stepping.ts', () => ({
  Stepping: class {
    constructor(options: unknown) {
      Object.assign(world, { stepping: options })
    }
    play = () => world.calls.push('play')
    pause = () => world.calls.push('pause')
    restart = () => world.calls.push('restart')
    redraw = () => world.calls.push('redraw')
    whenReady = async () => {
      world.calls.push('ready')
    }
    dispose = () => world.calls.push('stepping disposed')
  },
}))
vi.mock('../../web/element/shell.ts', () => ({
  Shell: class {
    figure = Object.assign(new EventTarget(), {
      ariaBusy: 'false',
      focus: (options: unknown) => world.calls.push(`focus ${JSON.stringify(options)}`),
    })
    frame = new EventTarget()
    picture = {}
    paper = {}
    controls = { replaceChildren: () => world.calls.push('no buttons') }
    player = { hidden: false }
    said = {}
    problem = ''
    isRunning = false
    isShown = true
    hasFailed = false
    hints: string[] = []
    described: unknown[] = []
    onrestyle = () => {}
    constructor() {
      world.shells.push(this)
    }
    describe(...how: unknown[]) {
      this.described = how
    }
    hint(text: string) {
      this.hints.push(text)
    }
    fail() {
      this.hasFailed = true
    }
  },
}))
vi.mock('../../web/element/controls.ts', () => ({
  mountControls: (...args: unknown[]) => world.mounted.push(args),
  paddingBelow: () => ({ top: 0, right: 0, bottom: 0, left: 0 }),
}))
vi.mock('../../web/element/idle.ts', () => ({
  whenIdle: (act: () => void) => {
    world.idle.push(act)
    return () => world.idle.splice(world.idle.indexOf(act), 1)
  },
}))
vi.mock('../../web/element/visibility.ts', () => ({
  watchVisibility: (_: unknown, tell: (sight: string) => void) => {
    world.sights.push(tell)
    return () => world.sights.splice(world.sights.indexOf(tell), 1)
  },
}))
vi.mock('../../web/view/paper.ts', () => ({
  Paper: class {
    calls: string[] = []
    draw: () => Promise<string>
    constructor(_: unknown, draw: () => Promise<string>) {
      this.draw = draw
      world.papers.push(this)
    }
    change() {
      this.calls.push('change')
    }
    dispose() {
      this.calls.push('dispose')
    }
  },
}))

interface FakeShell {
  readonly figure: EventTarget
  readonly frame: EventTarget
  readonly player: { hidden: boolean }
  readonly problem: string
  readonly isRunning: boolean
  readonly isShown: boolean
  readonly hasFailed: boolean
  readonly hints: string[]
  readonly described: readonly [words: { lang: string }, alt: string, about: string, isReadonly: boolean]
  onrestyle(): void
}

interface FakeInternals {
  form: object | null
  readonly values: string[]
  readonly validities: unknown[][]
  readonly states: Set<string>
}

type Fake = CircleVoronoiElement & { readonly internals: FakeInternals; isConnected: boolean }

/** A view without pixels, whose diagrams the library computes. */
interface FakeView extends LibraryBackend {
  camera: object
  layers: object
  isShown: boolean
  size: { width: number; height: number }
  readonly listeners: Map<string, Set<Listen>>
  readonly asked: [name: string, ...args: unknown[]][]
  readonly load: unknown
}

/** The answers of a view to questions, by name. */
let answers: Record<string, unknown>
/** The errors of the next requests, and `undefined` where the answer is right. */
let failures: (Error | undefined)[]
let before: () => Promise<unknown>
let domains: unknown[]

world.makeView = () => {
  const listeners = new Map<string, Set<Listen>>()
  const asked: unknown[][] = []
  const backend = new LibraryBackend(async () => {
    await before()
    const error = failures.shift()
    if (error !== undefined) throw error
  })
  const { setCircles, apply } = backend
  const tell = (name: string, data?: unknown) => {
    for (const listen of listeners.get(name) ?? []) listen(data)
  }
  return Object.assign(backend, {
    listeners,
    asked,
    camera: { x: 0, y: 0, scale: 1 },
    size: { width: 100, height: 100 },
    layers: DEFAULT_LAYERS as object,
    isShown: true,
    setCircles: async (...args: Parameters<typeof setCircles>) => {
      domains.push(args[1])
      return setCircles.apply(backend, args)
    },
    apply: async (...args: unknown[]) => {
      domains.push(args[1])
      return apply.apply(backend, [args[0]] as unknown as Parameters<typeof apply>)
    },
    on: (name: string, listen: Listen) => {
      listeners.set(name, (listeners.get(name) ?? new Set()).add(listen))
      return () => listeners.get(name)?.delete(listen)
    },
    ask: async (...question: unknown[]) => {
      asked.push(question)
      return answers[question[0] as string]
    },
    mark() {},
    choose() {},
    setIdentities() {},
    setCamera(camera: object) {
      Object.assign(backend, { camera })
    },
    setLayers(layers: object) {
      const next = { ...(backend as unknown as FakeView).layers, ...layers }
      Object.assign(backend, { layers: next })
      tell('layers', next)
    },
    restyle: () => world.calls.push('restyle'),
    toSVG: async () => '<svg>',
    toPNG: async (scale: unknown) => `png ${scale}`,
    cancel: () => false,
    dispose: () => world.calls.push('view disposed'),
  })
}

beforeEach(() => {
  for (const list of [
    world.views,
    world.shells,
    world.papers,
    world.calls,
    world.idle,
    world.sights,
    world.mounted,
    world.listening,
  ])
    list.length = 0
  world.observers.length = 0
  world.isPressed = false
  answers = {}
  failures = []
  before = async () => {}
  domains = []
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => queueMicrotask(frame))
  vi.stubGlobal('navigator', {})
  vi.stubGlobal('document', Object.assign(new EventTarget(), { readyState: 'complete', visibilityState: 'visible' }))
  vi.stubGlobal(
    'Node',
    class {
      static readonly TEXT_NODE = 3
      readonly nodeType = 0
    },
  )
  vi.stubGlobal(
    'MutationObserver',
    class {
      isOn = false
      change: () => void
      constructor(change: () => void) {
        this.change = change
        world.observers.push(this)
      }
      options: unknown
      observe(_: unknown, options: unknown) {
        this.isOn = true
        this.options = options
      }
      disconnect() {
        this.isOn = false
      }
    },
  )
})
afterEach(() => vi.unstubAllGlobals())

const THREE = [
  [0, 0, 2],
  [10, 0, 1],
  [5, 8, 1.5],
]
const TEXT = JSON.stringify(THREE)

const EVENTS = [
  'circleschange',
  'diagramchange',
  'checkchange',
  'selectionchange',
  'stepchange',
  'input',
  'change',
  'error',
] as const

/** An element with attributes, which is in no page yet. `told` has the names of its events. */
function made(attributes: Readonly<Record<string, string>> = { circles: TEXT }) {
  const element = new CircleVoronoiElement() as Fake
  const told: string[] = []
  const events: CustomEvent[] = []
  for (const name of EVENTS) {
    element.addEventListener(name, (event) => {
      told.push(name)
      events.push(event as CustomEvent)
    })
  }
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value)
  const shell = world.shells.at(-1) as FakeShell
  return {
    element,
    shell,
    told: () => told.splice(0),
    events,
    view: () => world.views.at(-1) as FakeView,
  }
}

function connect(element: Fake): void {
  element.isConnected = true
  element.connectedCallback()
}

async function disconnect(element: Fake): Promise<void> {
  element.isConnected = false
  element.disconnectedCallback()
  await aTurn()
}

/** An element in a page that shows its circles. */
async function shown(attributes?: Readonly<Record<string, string>>) {
  const all = made(attributes)
  await run(all.element)
  return all
}

/** Puts an element into a page that is idle. */
async function run(element: Fake): Promise<void> {
  connect(element)
  for (const start of world.idle.splice(0)) start()
  await element.ready
  await settled(element)
}

async function settled(element: Fake): Promise<void> {
  await element.updateComplete
  await aTurn()
}

/** The figure that runs in an element with `controls`, as its buttons know it. */
const figureOf = () => (world.mounted.at(-1) as [unknown, Figure<EditorActions>])[1]

/** Lets a change of a program pass, and returns the error events that it caused. */
async function errorsOf(all: ReturnType<typeof made>, act: () => unknown): Promise<string[]> {
  all.events.length = 0
  act()
  await settled(all.element)
  return all.events.filter(({ type }) => type === 'error').map(({ detail }) => detail.error.message)
}

const SQUARE = 'POLYGON ((-9 -9, 19 -9, 19 19, -9 19))'
const RING = [
  [-9, -9],
  [19, -9],
  [19, 19],
  [-9, 19],
]

describe('a wrong attribute', () => {
  const wrong: readonly [name: string, wrong: string, right: string, message: RegExp][] = [
    ['areas', '1 x', 'equal', /^The areas must be /],
    ['check', '{', '{"circles": 3}', /^The check cannot be read: it is not valid JSON\.$/],
    ['check', '{"cell": 3, "edges": 1}', '{"cell": 2, "edges": 1}', /there is no circle 3\. .* ids 0 to 2\.$/],
    ['controls', 'x', 'player', /^The controls must be /],
    ['lattice', '1 0 0', '30 0 0 30', /^The lattice must be /],
    ['layers', 'x', 'hull', /^There is no layer x\./],
    ['method', 'x', 'flip', /^The method must be /],
    ['region', 'POLYGON x', SQUARE, /^This is neither GeoJSON/],
    ['samples', '-1', '3', /^The samples must be /],
    ['step', 'x', '2', /^A step is /],
    ['view', '1 2', '1 2 3', /^A view is /],
  ]

  it.each(wrong)(
    '%s="%s" is one error event, and is shown until it is right or gone',
    async (name, bad, good, said) => {
      const all = await shown()
      const { element, shell } = all
      for (const end of [() => element.setAttribute(name, good), () => element.removeAttribute(name)]) {
        expect(await errorsOf(all, () => element.setAttribute(name, bad))).toEqual([expect.stringMatching(said)])
        expect(all.events.find(({ type }) => type === 'error')?.detail.error).toBeInstanceOf(CircleVoronoiError)
        expect(shell.problem).toMatch(said)
        expect(await errorsOf(all, end)).toEqual([])
        expect(shell.problem).toBe('')
      }
      expect([...element.circles]).toEqual(THREE.flat())
    },
  )

  it('is shown together with others, which stay', async () => {
    const { element, shell } = await shown()
    element.setAttribute('method', 'x')
    element.setAttribute('step', 'x')
    expect(shell.problem).toMatch(/^The method must .* A step is [^.]*\.$/)
    element.removeAttribute('method')
    expect(shell.problem).toMatch(/^A step is [^.]*\.$/)
  })

  it('of layers and areas is told once, also if it was there before the figure began', async () => {
    const all = await shown({ circles: TEXT, layers: 'x', areas: 'x', region: 'POLYGON x', samples: '-1' })
    expect(all.told().filter((name) => name === 'error')).toHaveLength(4)
    expect(all.view().layers).toEqual(DEFAULT_LAYERS)
    expect(await errorsOf(all, () => all.element.setAttribute('circles', TEXT))).toEqual([])
    expect(all.shell.problem).toMatch(/There is no layer x.*The areas must be.*This is neither/)
  })
})

describe('a check', () => {
  it('that names a circle which is missing is wrong until circles have it', async () => {
    const all = await shown({ circles: TEXT, check: '{"cell": 3, "edges": 1}' })
    expect(all.shell.problem).toMatch(/there is no circle 3/)
    expect(await errorsOf(all, () => Object.assign(all.element, { circles: [...THREE, [20, 0, 1]] }))).toEqual([])
    expect(all.shell.problem).toBe('')
    expect(await errorsOf(all, () => Object.assign(all.element, { circles: THREE }))).toHaveLength(1)
    expect(all.shell.problem).toMatch(/there is no circle 3/)
    await all.element.setState({ edits: [{ kind: 'remove', id: 0 }] })
    expect(all.told().filter((name) => name === 'error')).toHaveLength(2)
  })

  it('that cannot be written is an error, until it is unset or another one', async () => {
    const all = await shown()
    const circular: unknown[] = []
    circular.push({ all: circular })
    for (const end of [undefined, null, { circles: 3 }]) {
      expect(await errorsOf(all, () => Object.assign(all.element, { check: { all: circular } }))).toEqual([
        expect.stringMatching(/circular/),
      ])
      expect(all.shell.problem).toMatch(/circular/)
      expect(await errorsOf(all, () => Object.assign(all.element, { check: end }))).toEqual([])
      expect(all.shell.problem).toBe('')
    }
  })

  it('is the value and the validity of the field, a state, a part of the description, and an event where that changes', async () => {
    const facts = { circles: 3, hidden: 0, vertices: 1, edges: 3, cells: new Map() }
    answers.tell = facts
    const all = await shown({ circles: TEXT, check: '{"circles": 4}', controls: '' })
    const { element, shell, events } = all
    const { internals } = element
    const now = () => ({
      value: JSON.parse(internals.values.at(-1) as string),
      validity: internals.validities.at(-1),
      isMet: internals.states.has('met'),
      about: shell.described[2],
    })
    const checked = () => events.splice(0).flatMap(({ type, detail }) => (type === 'checkchange' ? [detail.isMet] : []))
    expect(now()).toMatchObject({
      value: { circles: THREE, check: false },
      validity: [{ customError: true }, expect.any(String), shell.figure],
      isMet: false,
    })
    const [, unmet] = now().validity as string[]
    expect(now().about).toMatch(/^3 circles; .* /)
    expect(now().about).toContain(` ${unmet}`)
    expect(checked()).toEqual([false])
    answers.tell = { ...facts, circles: 4 }
    await figureOf().actions.add([{ x: 20, y: 20, r: 1 }])
    await settled(element)
    expect(now()).toMatchObject({
      value: { circles: [...THREE, [20, 20, 1]], check: true },
      validity: [{}],
      isMet: true,
    })
    expect(now().about).not.toContain(unmet)
    expect(checked()).toEqual([true])
    await figureOf().actions.add([{ x: 30, y: 20, r: 1 }])
    await settled(element)
    expect(checked()).toEqual([])
    element.removeAttribute('check')
    await settled(element)
    expect(now()).toMatchObject({ validity: [{}], isMet: false })
    expect(now().value).not.toHaveProperty('check')
    expect(checked()).toEqual([false])
    expect(element.check).toBeUndefined()
  })

  it('that is replaced while its facts are found says nothing', async () => {
    let answer = (_: unknown) => {}
    const all = await shown({ circles: TEXT })
    answers.tell = new Promise((resolve) => {
      answer = resolve
    })
    all.told()
    all.element.setAttribute('check', '{"circles": 3}')
    answers.tell = undefined
    all.element.removeAttribute('check')
    answer({ circles: 3, hidden: 0, vertices: 1, edges: 3, cells: new Map() })
    await settled(all.element)
    expect(all.told()).toEqual([])
    expect(all.element.internals.states.has('met')).toBe(false)
  })

  it('is asked of the circles that it is about', async () => {
    const { view } = await shown({
      circles: TEXT,
      check: '{"any": [{"cell": 1, "edges": 2}, {"cell": 2, "edges": 2}]}',
    })
    expect(
      view()
        .asked.filter(([name]) => name === 'tell')
        .at(-1),
    ).toEqual(['tell', [1, 2]])
  })
})

describe('a field of a form', () => {
  it('has a value only within a form', async () => {
    const { element } = made()
    element.internals.form = null
    await run(element)
    expect([element.internals.values, element.form]).toEqual([[], null])
  })

  it('passes on what the browser says of it', async () => {
    const { element } = made()
    expect([element.checkValidity(), element.reportValidity(), element.validationMessage]).toEqual([
      'checked',
      'reported',
      'message',
    ])
  })

  it('is reset to the circles of its attributes, restored to those that the browser kept, and disabled', async () => {
    const { element } = await shown({ circles: TEXT, controls: '' })
    element.formStateRestoreCallback('{"circles": [[1, 1, 1]]}')
    await settled(element)
    expect([...element.circles]).toEqual([1, 1, 1])
    element.formResetCallback()
    await settled(element)
    expect([...element.circles]).toEqual(THREE.flat())
    for (const isDisabled of [true, false]) {
      element.formDisabledCallback(isDisabled)
      expect(figureOf().actions.isReadonly).toBe(isDisabled)
      expect(world.mounted.at(-1)?.[3]).toBe(isDisabled)
    }
  })
})

describe('attributes and properties', () => {
  it.each([
    ['alt', 'Trees', 'Trees', ''],
    ['check', { circles: 3 }, '{"circles":3}', undefined],
    ['check', '{"circles": 3}', '{"circles": 3}', undefined],
    ['controls', 'player', 'player', null],
    ['controls', true, '', null],
    ['lang', 'de', 'de', ''],
    ['method', 'flip', 'flip', 'auto'],
    ['name', 'a', 'a', ''],
    ['samples', 3, '3', undefined],
    ['src', 'a.csv', 'a.csv', ''],
    ['step', 0, '0', undefined],
    ['areas', '1 2', '1 2', undefined],
    ['lattice', '9 0 0 9', '9 0 0 9', undefined],
    ['layers', 'hull', 'hull', DEFAULT_LAYERS],
    ['region', SQUARE, SQUARE, undefined],
    ['view', '1 2 3', '1 2 3', undefined],
    ['readonly', true, '', false],
    ['dissolve', true, '', false],
  ] as const)('the property %s of %j is the attribute "%s", and without it %j', (name, value, attribute, none) => {
    const { element, told } = made({})
    const any = element as unknown as Record<string, unknown>
    for (const nothing of [undefined, null, ...(typeof value === 'boolean' ? [false] : [])]) {
      any[name] = value
      expect(element.getAttribute(name)).toBe(attribute)
      any[name] = nothing
      // The attribute of a text stays if the property has other forms, too.
      if (['areas', 'lattice', 'layers', 'region', 'view'].includes(name)) element.removeAttribute(name)
      expect(element.hasAttribute(name)).toBe(false)
      expect(any[name]).toEqual(none)
    }
    expect(told()).toEqual([])
  })

  it.each([
    ['readonly', 'no'],
    ['dissolve', 1],
  ])('the property %s is set by true alone', (name, value) => {
    const { element } = made({})
    Object.assign(element, { [name]: value })
    expect(element.hasAttribute(name)).toBe(false)
  })

  it.each([
    ['areas', [1, 2, 3], [3, 2, 1]],
    ['lattice', { a: [30, 0], b: [0, 30] }, { a: [40, 0], b: [0, 40] }],
    ['layers', { ...DEFAULT_LAYERS, hull: true }, { ...DEFAULT_LAYERS, dual: true }],
    ['view', { x: 1, y: 2, span: 3 }, { x: 2, y: 2, span: 3 }],
    ['selection', [1], [2]],
  ])('the property %s is copied when it is set and when it is read', async (name, value, other) => {
    for (const isShown of [false, true]) {
      const { element } = isShown ? await shown() : made()
      const any = element as unknown as Record<string, unknown>
      const given = structuredClone(value)
      any[name] = given
      await aTurn()
      Object.assign(given, other)
      const read = any[name] as object
      expect(read, String(isShown)).toEqual(value)
      Object.assign(read, other)
      expect(any[name], String(isShown)).toEqual(value)
    }
  })

  it('a property wins over its attribute until it is unset, or the attribute is set anew', async () => {
    const acts: readonly [string, string, unknown, unknown][] = [
      ['areas', '1 2 3', 'equal', [3, 2, 1]],
      ['lattice', '30 0 0 30', { a: [30, 0], b: [0, 30] }, { a: [40, 0], b: [0, 40] }],
      ['layers', 'hull', { ...DEFAULT_LAYERS, hull: true }, { ...DEFAULT_LAYERS, dual: true }],
      ['view', '1 2 3', { x: 1, y: 2, span: 3 }, { x: 2, y: 2, span: 3 }],
    ]
    for (const [name, text, , own] of acts) {
      const { element } = made({ circles: TEXT, [name]: text })
      const any = element as unknown as Record<string, unknown>
      const said = any[name]
      expect(said, name).not.toEqual(own)
      for (const back of [
        () => Object.assign(element, { [name]: undefined }),
        () => Object.assign(element, { [name]: null }),
        () => element.setAttribute(name, text),
      ]) {
        any[name] = own
        expect(any[name], name).toEqual(own)
        back()
        expect(any[name], name).toEqual(said)
      }
    }
  })

  it('layers and a view are seen at once in a figure that runs, with the data of clients', async () => {
    const data = [{ id: 'a', color: 'red', points: Float64Array.of(1, 2) }]
    const early = made({ circles: TEXT })
    early.element.layers = { data }
    await run(early.element)
    expect(early.view().layers).toMatchObject({ data })
    const { element, view } = await shown({ circles: TEXT, layers: 'hull' })
    const seen: unknown[] = []
    for (const act of [
      () => Object.assign(element, { layers: { dual: true } }),
      () => Object.assign(element, { layers: undefined }),
      () => element.setAttribute('layers', 'dual'),
      () => element.removeAttribute('layers'),
    ]) {
      act()
      const { hull, dual } = view().layers as { hull: boolean; dual: boolean }
      seen.push([hull, dual])
    }
    expect(seen).toEqual([
      [false, true],
      [true, false],
      [false, true],
      [false, false],
    ])
    element.view = { x: 1, y: 2, span: 9 }
    expect(view().camera).toMatchObject({ x: 1, y: 2 })
    element.setAttribute('view', '3 4 9')
    expect(view().camera).toMatchObject({ x: 3, y: 4 })
  })

  it('a property that cannot be is one error, and leaves the former value', async () => {
    const all = await shown()
    const acts: readonly [name: string, value: unknown, message: RegExp][] = [
      ['areas', [1, -1], /^The areas must be /],
      ['areas', [], /^The areas must be /],
      ['circles', [[0, 0]], /^Circle 0 does not have three numbers/],
      ['value', [[0, 0]], /^Circle 0 does not have three numbers/],
      ['lattice', { a: [1, 0] }, /^The lattice must be /],
      ['layers', { x: true }, /^There is no layer x\./],
      ['region', 7, /^A region is made of /],
      ['selection', 7, /^The selection must be a list of circle ids \(got 7\)/],
      ['view', { x: 1, y: 2, span: 0 }, /^A view is /],
    ]
    for (const [name, value, message] of acts) {
      const any = all.element as unknown as Record<string, unknown>
      const former = structuredClone(any[name])
      expect(await errorsOf(all, () => Object.assign(all.element, { [name]: value })), name).toEqual([
        expect.stringMatching(message),
      ])
      expect(all.shell.problem, name).toMatch(message)
      expect(any[name], name).toEqual(former)
      expect(await errorsOf(all, () => Object.assign(all.element, { [name]: undefined })), name).toEqual([])
      expect(all.shell.problem, name).toBe('')
    }
  })

  it('properties that were set before the class was defined are taken over', async () => {
    const { element } = made({})
    for (const [name, value] of Object.entries({ circles: THREE, alt: 'Trees', readonly: true, selection: [1] }))
      Object.defineProperty(element, name, { value, configurable: true, enumerable: true, writable: true })
    await run(element)
    expect([...element.circles]).toEqual(THREE.flat())
    expect([element.alt, element.readonly, [...element.selection]]).toEqual(['Trees', true, [1]])
    expect(['circles', 'alt', 'readonly', 'selection'].filter((name) => Object.hasOwn(element, name))).toEqual([])
  })
})

describe('circles', () => {
  it('are those of the newest request, however late others are, and all are ready then', async () => {
    const { element, told, view } = await shown()
    let go = () => {}
    before = () => new Promise<void>((resolve) => (go = resolve))
    told()
    element.circles = [[1, 1, 1]]
    await aTurn()
    const first = go
    before = async () => {}
    element.circles = [[2, 2, 2]]
    first()
    await settled(element)
    expect([...element.circles]).toEqual([2, 2, 2])
    expect([...view().circles.circles()]).toEqual([2, 2, 2])
  })

  it('of the newest event change nothing if they are set again; of older ones, and changed copies, they do', async () => {
    const { element, events, told } = await shown()
    const [{ detail: first }] = events as [CustomEvent]
    const { circles } = first
    expect(first.circles).toBe(circles)
    expect([...first.ids]).toEqual([0, 1, 2])
    told()
    element.circles = circles
    await settled(element)
    expect(told()).toEqual([])
    element.circles = Float64Array.from(circles as Float64Array)
    await settled(element)
    expect(told()).toEqual(['circleschange', 'diagramchange'])
    element.circles = circles
    await settled(element)
    expect(told()).toEqual(['circleschange', 'diagramchange'])
  })

  it('as a value are one object between changes, and setting them again, however written, changes nothing', async () => {
    const { element, told } = await shown()
    told()
    const { value } = element
    expect(element.value).toBe(value)
    element.value = value
    element.value = THREE
    await settled(element)
    expect(told()).toEqual([])
    element.value = THREE.slice(1)
    await settled(element)
    expect(told()).toEqual(['circleschange', 'diagramchange'])
    expect([...element.value]).toEqual(THREE.slice(1).flat())
    element.value = [
      [10, 0, 1],
      [5, 8, 1.25],
    ]
    await settled(element)
    expect(told()).toEqual(['circleschange', 'diagramchange'])
    await element.setState({ edits: [{ kind: 'remove', id: 0 }] })
    expect([...element.value]).toEqual([5, 8, 1.25])
    for (const nothing of ['', undefined, null]) {
      element.value = [[1, 1, 1]]
      element.value = nothing
      await settled(element)
      expect([...element.value]).toEqual(THREE.flat())
    }
  })

  it('have ids, before the figure runs and after circles are gone', async () => {
    const early = made({})
    early.element.circles = THREE
    expect([[...early.element.ids], [...early.element.circles]]).toEqual([[0, 1, 2], THREE.flat()])
    const { element } = await shown({ circles: TEXT, controls: '' })
    await figureOf().editing.edit([{ kind: 'remove', id: 1 }])
    expect([...element.ids]).toEqual([0, 2])
    await disconnect(element)
    expect([...element.ids]).toEqual([0, 2])
    expect([...element.circles]).toEqual([...(THREE[0] as number[]), ...(THREE[2] as number[])])
  })

  it('that cannot be shown are an error, and the content stays where there were none before', async () => {
    const all = await shown({ circles: '[[1, 2]]' })
    expect(all.told()).toEqual(['error'])
    expect([all.shell.hasFailed, all.shell.isRunning]).toEqual([true, false])
    expect(all.shell.problem).toMatch(/^Circle 0/)
    expect(await errorsOf(all, () => all.element.setAttribute('circles', TEXT))).toEqual([])
    expect([all.shell.problem, all.shell.isRunning]).toEqual(['', true])
    const good = await shown()
    expect(await errorsOf(good, () => good.element.setAttribute('circles', '[[1, 2]]'))).toHaveLength(1)
    expect([good.shell.hasFailed, [...good.element.circles]]).toEqual([false, THREE.flat()])
  })

  it('that the backend refuses are one error', async () => {
    failures = [new CircleVoronoiError('negativeRadius', 'Circle 1 is negative.', { circle: 1 })]
    const all = await shown()
    expect(all.told()).toEqual(['error'])
    expect(all.shell.hasFailed).toBe(true)
  })

  it('between the tags are read again when they change, unless there are others', async () => {
    const { element, told, shell } = await shown({})
    expect([...element.circles]).toEqual([])
    const [observer] = world.observers as [(typeof world.observers)[number]]
    expect(observer).toMatchObject({ isOn: true, options: { childList: true, subtree: true, characterData: true } })
    const write = async (textContent: string) => {
      Object.assign(element, { childNodes: [{ nodeType: 3, textContent }] })
      observer.change()
      await settled(element)
    }
    expect(told()).toEqual([])
    await write('|1|2|')
    expect(shell.problem).toMatch(/^Line 1/)
    await write('|1|2|3|')
    expect([...element.circles, shell.problem]).toEqual([1, 2, 3, ''])
    for (const [set, unset] of [
      [() => element.setAttribute('circles', TEXT), () => element.removeAttribute('circles')],
      [() => Object.assign(element, { circles: THREE }), () => Object.assign(element, { circles: undefined })],
    ] as const) {
      set()
      await settled(element)
      told()
      await write('|4|4|4|')
      expect([told(), [...element.circles]]).toEqual([[], THREE.flat()])
      unset()
      await settled(element)
      expect([...element.circles]).toEqual([4, 4, 4])
    }
    Object.assign(element, { childNodes: [] })
    observer.change()
    await settled(element)
    expect([...element.circles]).toEqual([])
    await disconnect(element)
    expect(observer.isOn).toBe(false)
  })

  it('of an address replace those of properties', async () => {
    const { element } = await shown()
    element.circles = [[1, 1, 1]]
    await settled(element)
    const asked: string[] = []
    const signals: AbortSignal[] = []
    vi.stubGlobal('fetch', async (src: string, { signal }: { signal: AbortSignal }) => {
      asked.push(src)
      signals.push(signal)
      return new Response('9,9,9\n')
    })
    element.removeAttribute('circles')
    element.src = 'a.csv'
    await settled(element)
    expect([asked.at(-1), [...element.circles]]).toEqual(['https://example.org/page/a.csv', [9, 9, 9]])
    expect(signals.at(-1)?.aborted).toBe(false)
    element.circles = THREE
    expect(signals.at(-1)?.aborted).toBe(true)
  })
})

describe('readers', () => {
  const circle = { x: 20, y: 20, r: 1 }

  it('cause input and, once they release the circles, change; programs cause neither', async () => {
    const { element, shell, told, events } = await shown({ circles: TEXT, controls: '' })
    const { actions } = figureOf()
    expect(told()).not.toContain('input')
    await element.setState({ edits: [{ kind: 'remove', id: 1 }] })
    element.circles = THREE
    await settled(element)
    expect(told()).not.toContain('input')
    await actions.add([circle])
    await settled(element)
    const edited = ['circleschange', 'input', 'diagramchange', 'selectionchange', 'change']
    expect(told().sort()).toEqual(edited.toSorted())
    for (const name of ['pointerup', 'pointercancel', 'lostpointercapture']) {
      world.isPressed = true
      await actions.add([circle])
      await actions.add([circle])
      await settled(element)
      expect(told().filter((event) => ['input', 'change'].includes(event))).toEqual(['input', 'input'])
      world.isPressed = false
      shell.figure.dispatchEvent(new Event(name))
      await aTurn()
      shell.figure.dispatchEvent(new Event(name))
      await aTurn()
      expect(told(), name).toEqual(['change'])
    }
    const flags = new Map(events.map(({ type, bubbles, composed }) => [type, [bubbles, composed]]))
    expect(flags.get('change')).toEqual([true, false])
    for (const name of ['input', 'circleschange', 'diagramchange', 'selectionchange'])
      expect(flags.get(name), name).toEqual([true, true])
  })

  it('release circles once all their edits are made', async () => {
    const { element, shell, told } = await shown({ circles: TEXT, controls: '' })
    const { actions } = figureOf()
    world.isPressed = true
    let go = () => {}
    await actions.add([circle])
    before = () => new Promise<void>((resolve) => (go = resolve))
    const second = actions.add([circle])
    await aTurn()
    told()
    world.isPressed = false
    shell.figure.dispatchEvent(new Event('pointerup'))
    await aTurn()
    expect(told()).toEqual([])
    go()
    await second
    await settled(element)
    expect(told().filter((event) => ['input', 'change'].includes(event))).toEqual(['input', 'change'])
  })

  it('hear how to zoom where the wheel scrolls the page', async () => {
    const { shell } = await shown()
    const wheel = new Event('wheel', { cancelable: true })
    wheel.preventDefault()
    shell.frame.dispatchEvent(wheel)
    expect(shell.hints).toEqual([])
    shell.frame.dispatchEvent(new Event('wheel'))
    expect(shell.hints).toEqual([expect.stringMatching(/^Ctrl and the wheel zoom/)])
  })

  it('who may only look have no tool and no buttons that edit', async () => {
    const { element, shell } = await shown({ circles: TEXT, controls: '' })
    const { actions, store } = figureOf()
    actions.useTool('add')
    element.readonly = true
    expect([actions.isReadonly, store.get().tool, world.mounted.at(-1)?.[3], shell.described[3]]).toEqual([
      true,
      'select',
      true,
      true,
    ])
    element.readonly = false
    expect([actions.isReadonly, world.mounted.at(-1)?.[3], shell.described[3]]).toEqual([false, false, false])
    world.calls.length = 0
    element.controls = null
    expect(world.calls).toContain('no buttons')
  })
})

describe('a selection', () => {
  it('is told where it changes, in copies, and kept until its circles are there', async () => {
    const { element, events, told } = made({ circles: TEXT, controls: '' })
    element.selection = [1]
    expect(element.selection).toEqual([1])
    await run(element)
    expect(element.selection).toEqual([1])
    const selections = () =>
      events.splice(0).flatMap(({ type, detail }) => (type === 'selectionchange' ? [detail.selection] : []))
    expect(selections()).toEqual([[1]])
    element.selection = [0, 2]
    await settled(element)
    const [told02] = selections()
    expect(told02).toEqual([0, 2])
    told02.push(7)
    expect(figureOf().store.get().selection).toEqual([0, 2])
    for (const none of [undefined, null, []]) {
      element.selection = none as number[]
      await settled(element)
    }
    expect(selections()).toEqual([[]])
    element.selection = [1]
    figureOf().actions.select([2])
    await settled(element)
    expect([element.selection, selections()]).toEqual([[2], [[2]]])
    figureOf().actions.hover(1)
    await settled(element)
    expect(selections()).toEqual([])
    // While others are opened, a selection waits for them.
    let go = () => {}
    before = () => new Promise<void>((resolve) => (go = resolve))
    element.circles = [...THREE, [20, 20, 1]]
    element.selection = [3]
    await aTurn()
    expect(element.selection).toEqual([3])
    before = async () => {}
    go()
    await settled(element)
    expect(element.selection).toEqual([3])
    expect(figureOf().store.get().selection).toEqual([3])
    told()
  })
})

describe('an element that leaves its page', () => {
  it('goes on if it is only moved', async () => {
    const { element } = await shown({ circles: TEXT, controls: '' })
    element.isConnected = false
    element.disconnectedCallback()
    connect(element)
    await aTurn()
    expect(world.calls).not.toContain('view disposed')
    for (const start of world.idle.splice(0)) start()
    expect(world.views).toHaveLength(1)
  })

  it('ends its figure and all that it waits for, and goes on with its history once it is back', async () => {
    const { element, shell, view } = await shown({ circles: TEXT, controls: '', region: SQUARE, layers: 'hull' })
    const { actions, editing } = figureOf()
    await editing.edit([{ kind: 'remove', id: 1 }])
    await editing.setValues('name', new Map([[2, '"C"']]))
    actions.look({ x: 1, y: 2, span: 9 })
    actions.showStep(4, 'auto')
    await settled(element)
    const state = element.getState()
    const [paper] = world.papers as [(typeof world.papers)[number]]
    const papers = paper.calls.length
    view()
      .listeners.get('camera')
      ?.forEach((listen) => void listen(undefined))
    expect(paper.calls.length).toBe(papers + 1)
    await disconnect(element)
    expect(world.calls).toEqual(expect.arrayContaining(['pointer stopped', 'stepping disposed', 'view disposed']))
    expect([world.sights, world.idle, shell.isRunning]).toEqual([[], [], false])
    expect(paper.calls.at(-1)).toBe('dispose')
    expect(element.getState()).toEqual(state)
    expect([...element.ids]).toEqual([0, 2])
    await run(element)
    expect(element.getState()).toEqual(state)
    expect([...element.ids]).toEqual([0, 2])
    const next = figureOf()
    expect(next.editing.nameOf(2)).toBe('C')
    expect(next.editing.past.history.done).toHaveLength(2)
    expect(next.store.get().history).toBe(next.editing.past.history)
    await next.actions.undo()
    await next.actions.undo()
    expect([...element.circles].sort()).toEqual(THREE.flat().sort())
  })

  it('keeps areas and colors, and waits for no file any more', async () => {
    const { element } = await shown()
    await element.setState({ circles: THREE, region: [RING], areas: [3, 2, 1], colors: '012' })
    const state = element.getState()
    expect(state).toMatchObject({ areas: [3, 2, 1] })
    await disconnect(element)
    expect(element.getState()).toEqual(state)
    await run(element)
    expect(element.getState()).toEqual(state)
    expect(domains.at(-1)).toMatchObject({ colors: '012' })
    await disconnect(element)
    element.lattice = { a: [30, 0], b: [0, 30] }
    await run(element)
    expect([element.lattice, element.region, element.areas]).toEqual([{ a: [30, 0], b: [0, 30] }, undefined, undefined])
    expect([...element.circles]).toEqual(THREE.flat())
    const signals: AbortSignal[] = []
    vi.stubGlobal('fetch', (_: string, { signal }: { signal: AbortSignal }) => {
      signals.push(signal)
      return new Promise(() => {})
    })
    element.removeAttribute('circles')
    element.src = 'a.csv'
    await aTurn()
    await disconnect(element)
    expect(signals.length).toBeGreaterThan(0)
    expect(signals.map(({ aborted }) => aborted)).not.toContain(false)
  })

  it('has no history of circles that others have replaced meanwhile', async () => {
    const { element } = await shown({ circles: TEXT, controls: '' })
    await figureOf().editing.edit([{ kind: 'remove', id: 1 }])
    await disconnect(element)
    element.circles = THREE
    await run(element)
    expect(figureOf().editing.past.history.done).toEqual([])
  })

  it('leaves no promise open, and refuses what needs a figure', async () => {
    const { element } = made()
    connect(element)
    let isReady = false
    const ready = element.ready.then(() => {
      isReady = true
    })
    await aTurn()
    await aTurn()
    expect(isReady).toBe(false)
    await disconnect(element)
    await ready
    await element.ready
    connect(element)
    isReady = false
    element.ready.then(() => {
      isReady = true
    })
    await aTurn()
    await aTurn()
    expect(isReady).toBe(false)
    await disconnect(element)
    expect(isReady).toBe(true)
    const acts = [() => element.toSVG(), () => element.compute(), () => element.play(), () => element.setState({})]
    for (const act of acts) await expect(act()).rejects.toThrow('The figure is in no page, or no longer.')
    element.pause()
    expect(world.idle).toEqual([])
    expect(world.sights).toEqual([])
  })

  it('reports no circles that arrive afterwards', async () => {
    const { element, told } = await shown()
    let go = () => {}
    before = () => new Promise<void>((resolve) => (go = resolve))
    element.circles = [[1, 1, 1]]
    await aTurn()
    told()
    await disconnect(element)
    failures = [new Error('late')]
    go()
    await aTurn()
    expect(told().filter((name) => name === 'error')).toEqual([])
  })
})

describe('a figure', () => {
  it('begins when it comes near, or when the browser is idle and need not save data, and begins once', async () => {
    const near = made()
    connect(near.element)
    expect(world.views).toHaveLength(0)
    const [see] = world.sights as [(sight: string) => void]
    see('far')
    expect(world.views).toHaveLength(0)
    see('near')
    expect(world.views).toHaveLength(1)
    for (const start of world.idle.splice(0)) start()
    expect(world.views).toHaveLength(1)
    vi.stubGlobal('navigator', { connection: { saveData: true } })
    connect(made().element)
    expect(world.idle).toEqual([])
    vi.stubGlobal('navigator', { connection: { saveData: false } })
    connect(made().element)
    expect(world.idle).toHaveLength(1)
  })

  it('that is far has no pixels, unless it has many circles, which are printed from them', async () => {
    const { element, shell, view } = await shown()
    const see = world.sights.at(-1) as (sight: string) => void
    for (const [sight, isShown] of [
      ['far', false],
      ['near', true],
    ] as const) {
      see(sight)
      expect([view().isShown, shell.isShown]).toEqual([isShown, isShown])
    }
    const [paper] = world.papers as [(typeof world.papers)[number]]
    expect(await paper.draw()).toBe('<svg>')
    view().size.width = 0
    expect(await paper.draw()).toBe('')
    view().size.width = 100
    const many = (count: number) => Float64Array.from({ length: 3 * count }, (_, k) => (k % 3 === 2 ? 0 : k))
    for (const [count, isPrinted] of [
      [5000, false],
      [5001, true],
    ] as const) {
      element.circles = many(count)
      await settled(element)
      see('far')
      expect([view().isShown, shell.isShown]).toEqual([isPrinted, isPrinted])
      expect(await paper.draw()).toBe(isPrinted ? '' : '<svg>')
    }
  })

  it('that is far from the start has no pixels', async () => {
    const { element, shell, view } = made()
    connect(element)
    world.sights.at(-1)?.('far')
    for (const start of world.idle.splice(0)) start()
    await element.ready
    expect([view().isShown, shell.isShown]).toEqual([false, false])
  })

  it('begins at a call, lets the page scroll, and has the keys of its picture and the modules of its class', async () => {
    const load = { wasm: 'a.wasm' }
    const former = CircleVoronoiElement.load
    CircleVoronoiElement.load = load
    const { element, shell, view } = made({ circles: TEXT, layers: 'hull' })
    connect(element)
    expect(await element.toSVG()).toBe('<svg>')
    CircleVoronoiElement.load = former
    expect([...view().circles.circles()]).toEqual(THREE.flat())
    expect(view().load).toBe(load)
    const { picture } = shell as unknown as { picture: unknown }
    expect(world.listening).toEqual([{ letsPageScroll: true }, expect.objectContaining({ around: picture })])
    const empty = await shown({ layers: 'hull' })
    expect(empty.view().layers).toMatchObject({ hull: true })
  })

  it('is complete once all is computed, checked, played and painted', async () => {
    const { element, shell } = await shown()
    const isComplete = async () => {
      let isDone = false
      void element.updateComplete.then(() => {
        isDone = true
      })
      await aTurn()
      await aTurn()
      return isDone
    }
    const pending = () => {
      let resolve = (_?: unknown) => {}
      const promise = new Promise((done) => {
        resolve = done
      })
      return { promise, resolve }
    }
    const computed = pending()
    before = () => computed.promise
    element.circles = [[1, 1, 1]]
    expect(await isComplete()).toBe(false)
    computed.resolve()
    expect(await isComplete()).toBe(true)
    const checked = pending()
    answers.tell = checked.promise
    element.check = { circles: 1 }
    expect(await isComplete()).toBe(false)
    checked.resolve({ circles: 1, hidden: 0, vertices: 0, edges: 0, cells: new Map() })
    expect(await isComplete()).toBe(true)
    world.calls.length = 0
    await isComplete()
    expect(world.calls).toEqual(['ready'])
    const figure = shell.figure as EventTarget & { ariaBusy: string }
    figure.ariaBusy = 'true'
    expect(await isComplete()).toBe(false)
    figure.ariaBusy = 'false'
    expect(await isComplete()).toBe(true)
    const empty = await shown({})
    Object.assign(empty.shell.figure, { ariaBusy: 'true' })
    await empty.element.updateComplete
  })

  it('has its drawing for print made again after each change that is seen', async () => {
    const { view } = await shown()
    const [paper] = world.papers as [(typeof world.papers)[number]]
    for (const name of ['camera', 'layers', 'diagram', 'style', 'found', 'changed']) {
      const count = paper.calls.length
      for (const listen of view().listeners.get(name) ?? []) {
        if (name !== 'found' && name !== 'layers') listen(undefined)
        else listen(name === 'layers' ? DEFAULT_LAYERS : undefined)
      }
      expect(paper.calls.length, name).toBeGreaterThan(count)
    }
  })

  it('reads its style again where the shell sees other colors', async () => {
    const { shell } = made()
    shell.onrestyle()
    expect(world.calls).not.toContain('restyle')
    const running = await shown()
    running.shell.onrestyle()
    expect(world.calls).toContain('restyle')
  })

  it('takes the focus with its options', () => {
    const { element } = made()
    element.focus({ preventScroll: true })
    expect(world.calls).toEqual(['focus {"preventScroll":true}'])
  })

  it('is described by its numbers, and the name of the page', async () => {
    const { shell } = await shown({ circles: TEXT, alt: 'Trees' })
    expect(shell.described[1]).toBe('Trees')
    expect(shell.described[2]).toMatch(/^3 circles; /)
    const early = made({})
    expect(early.shell.described.slice(1)).toEqual(['', '', false])
    early.element.alt = 'Trees'
    expect(early.shell.described.slice(1)).toEqual(['Trees', '', false])
  })

  it('tells what went wrong, also while it shows circles', async () => {
    const all = await shown()
    expect(
      await errorsOf(all, () => {
        for (const listen of all.view().listeners.get('failed') ?? [])
          listen({ error: new Error('It broke.'), marks: true })
      }),
    ).toEqual(['It broke.'])
    expect(all.shell.problem).toMatch(/^It broke\./)
    all.element.setAttribute('method', 'x')
    expect(all.shell.problem).toMatch(/^The method must.* It broke\./)
  })
})

describe('a domain', () => {
  const [LATTICE, AREAS] = ['30 0 0 30', '1 2 3']
  const refusal = (what: string) => new CircleVoronoiError('badOption', `No ${what}.`)

  it('is that of attributes and properties from the start', async () => {
    const early = made({ dissolve: '' })
    early.element.region = [RING]
    expect(JSON.stringify(early.element.region)).toBe(JSON.stringify([RING]))
    early.element.region = undefined
    await run(early.element)
    expect(early.told()).not.toContain('error')
    const both = await shown({ circles: TEXT, lattice: LATTICE, areas: AREAS })
    expect([both.element.lattice, both.element.areas]).toEqual([{ a: [30, 0], b: [0, 30] }, [1, 2, 3]])
    domains.length = 0
    const { element } = await shown({ circles: TEXT, region: SQUARE, areas: AREAS })
    expect(domains).toHaveLength(1)
    expect([element.areas, element.getState().areas]).toEqual([
      [1, 2, 3],
      [1, 2, 3],
    ])
    expect(element.region).toBeDefined()
    expect(element.getState().region).toEqual(element.region)
    const other = await shown({ circles: TEXT, lattice: LATTICE })
    expect(other.element.getState().lattice).toEqual({ a: [30, 0], b: [0, 30] })
  })

  it('that is changed in several parts at once is changed once, after what is opened', async () => {
    const { element, told } = await shown()
    domains.length = 0
    told()
    element.region = [RING]
    element.areas = [3, 2, 1]
    await settled(element)
    expect(domains).toHaveLength(1)
    expect(told()).toEqual(['circleschange', 'diagramchange'])
    expect([element.areas, element.region !== undefined]).toEqual([[3, 2, 1], true])
    element.areas = undefined
    element.region = undefined
    await settled(element)
    expect(domains).toHaveLength(2)
    expect([element.areas, element.region]).toEqual([undefined, undefined])
    element.circles = THREE.slice(1)
    element.region = [RING]
    await settled(element)
    expect(element.region).toBeDefined()
    expect([...element.circles]).toEqual(THREE.slice(1).flat())
  })

  it.each([
    [{ region: SQUARE, areas: AREAS }, ['areas'], { region: true }],
    [{ region: SQUARE, areas: AREAS }, ['areas', 'region'], {}],
    [{ lattice: LATTICE }, ['lattice'], {}],
    [{ lattice: LATTICE, region: SQUARE }, ['lattice'], { region: true }],
    [{ areas: AREAS }, ['areas'], {}],
    [{ region: SQUARE }, ['region'], {}],
  ] as const)(
    '%j without %j, which are refused, is shown with the rest, and the last is to blame',
    async (given, refused, rest) => {
      failures = refused.map(refusal)
      const all = await shown({ circles: TEXT, ...given })
      expect([...all.element.circles]).toEqual(THREE.flat())
      const { element, shell } = all
      expect([element.region !== undefined, element.areas, element.lattice]).toEqual([
        'region' in rest,
        undefined,
        undefined,
      ])
      expect(all.told().filter((name) => name === 'error')).toHaveLength(refused.length)
      expect(shell.problem).toBe(`No ${refused.at(-1)}.`)
      element.removeAttribute(refused.at(-1) as string)
      expect(shell.problem).toBe('')
    },
  )

  it('follows each attribute and each property, also those of an element that runs', async () => {
    const { element } = await shown()
    const box = (size: number) => ({ a: [size, 0], b: [0, size] })
    const region = () => JSON.stringify(element.region)?.match(/1[79]/)?.[0]
    for (const [name, attribute, property, read, values] of [
      [
        'areas',
        '1 2 3',
        [3, 2, 1],
        () => element.areas,
        [
          [1, 2, 3],
          [3, 2, 1],
        ],
      ],
      [
        'region',
        SQUARE,
        [RING.map((corner) => corner.map((place) => (place === 19 ? 17 : place)))],
        region,
        ['19', '17'],
      ],
      ['lattice', '30 0 0 30', box(40), () => element.lattice, [box(30), box(40)]],
    ] as const) {
      const seen: unknown[] = []
      for (const act of [
        () => element.setAttribute(name, attribute),
        () => Object.assign(element, { [name]: property }),
        () => Object.assign(element, { [name]: undefined }),
        () => Object.assign(element, { [name]: property }),
        () => element.setAttribute(name, attribute),
        () => element.removeAttribute(name),
      ]) {
        act()
        await settled(element)
        seen.push(read())
      }
      const [said, own] = values
      expect(seen, name).toEqual([said, own, said, own, said, undefined])
    }
  })

  it('that is refused later stays as it was', async () => {
    const all = await shown({ circles: TEXT, region: SQUARE })
    failures = [refusal('areas')]
    expect(await errorsOf(all, () => Object.assign(all.element, { areas: 'equal' }))).toEqual(['No areas.'])
    expect([all.element.areas, all.element.region !== undefined]).toEqual([undefined, true])
    expect(all.shell.isRunning).toBe(true)
  })

  it('may have its region at an address, which is read again, or is an error', async () => {
    let text = 'POLYGON ((0 0, 1 0, 1 1, 0 1))'
    const asked: string[] = []
    vi.stubGlobal('fetch', async (src: string) => {
      asked.push(src)
      return new Response(text, { status: text === '' ? 404 : 200 })
    })
    const all = await shown({ circles: TEXT, region: 'b.wkt' })
    expect(all.told()).not.toContain('error')
    expect(asked).toEqual(['https://example.org/page/b.wkt'])
    expect(all.element.region).toBeDefined()
    text = ''
    expect(await errorsOf(all, () => all.element.setAttribute('region', 'c.wkt'))).toEqual([
      expect.stringMatching(/c\.wkt cannot be loaded: the answer is 404/),
    ])
    expect(all.shell.problem).toMatch(/c\.wkt/)
    expect(await errorsOf(all, () => all.element.removeAttribute('region'))).toEqual([])
    expect([all.shell.problem, all.element.region]).toEqual(['', undefined])
  })

  it('has a dissolved region with the attribute, and the given one without', async () => {
    const two = 'MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2)), ((1 0, 3 0, 3 2, 1 2)))'
    const { element } = await shown({ circles: TEXT, region: two })
    const count = () => JSON.stringify(element.region).match(/\],\[/g)?.length
    const before = count()
    element.dissolve = true
    await settled(element)
    const dissolved = JSON.stringify(element.region)
    element.dissolve = false
    await settled(element)
    expect(count()).toBe(before)
    expect(JSON.stringify(element.region)).not.toBe(dissolved)
  })
})

describe('the method', () => {
  interface SteppingOptions {
    options(method?: string): unknown
    onstep(step: number, steps: number): void
    words(): { lang: string } | undefined
    onproblem(error: Error): void
  }
  const stepping = () => (world as unknown as { stepping: SteppingOptions }).stepping

  it('is played by the attributes, or as a link says', async () => {
    const { element } = await shown()
    const { options } = stepping()
    expect([options(undefined), options('auto')]).toEqual([{ method: 'touching-disc' }, { method: 'auto' }])
    element.method = 'flip'
    element.samples = 0
    expect(options('auto')).toEqual({ method: 'flip', samples: 0 })
    expect(world.calls.filter((call) => call === 'restart')).toHaveLength(2)
  })

  it('tells each step, and why it cannot be played', async () => {
    const all = await shown()
    stepping().onstep(3, 9)
    expect(all.events.at(-1)).toMatchObject({ type: 'stepchange', detail: { step: 3, steps: 9 } })
    expect(await errorsOf(all, () => stepping().onproblem(new Error('Too many.')))).toEqual(['Too many.'])
  })

  it('is shown at the step of the attribute, from the start with a player, and otherwise not at all', async () => {
    for (const [attributes, step] of [
      [{}, undefined],
      [{ step: '4' }, 4],
      [{ controls: 'player' }, 0],
      [{ controls: 'buttons player', step: '2' }, 2],
    ] as const) {
      const { element, shell } = await shown({ circles: TEXT, ...attributes })
      expect(element.step, JSON.stringify(attributes)).toBe(step)
      expect(shell.player.hidden).toBe(!('controls' in attributes))
    }
  })

  it('follows the attribute, the property and the controls', async () => {
    const { element } = await shown()
    const seen: unknown[] = []
    const set = (act: () => void) => {
      act()
      seen.push(element.step)
    }
    set(() => element.setAttribute('step', '3'))
    set(() => element.removeAttribute('step'))
    set(() => Object.assign(element, { step: 5 }))
    set(() => element.setAttribute('controls', 'player'))
    set(() => Object.assign(element, { step: null }))
    set(() => element.removeAttribute('controls'))
    set(() => element.setAttribute('controls', 'player'))
    set(() => element.setAttribute('step', '2'))
    set(() => element.removeAttribute('controls'))
    set(() => Object.assign(element, { step: undefined }))
    expect(seen).toEqual([3, undefined, 5, 5, 0, undefined, 0, 2, 2, undefined])
    // Without a player, an attribute that is missing already takes a step of a reader away.
    await element.stepTo(7)
    element.step = undefined
    expect(element.step).toBeUndefined()
  })

  it('is played, paused and shown at a step by calls, in their order', async () => {
    const { element } = await shown()
    world.calls.length = 0
    await element.play()
    element.pause()
    await element.stepTo(3)
    expect(world.calls).toEqual(['play', 'ready', 'pause', 'pause', 'ready'])
    expect(element.step).toBe(3)
    await expect(element.stepTo(-1)).rejects.toThrow('A step is a whole number from 0, not -1.')
    world.calls.length = 0
    expect([await element.toSVG(), await element.toPNG(2)]).toEqual(['<svg>', 'png 2'])
    expect(world.calls).toEqual(['ready', 'ready'])
  })

  it('computes from scratch by the attributes, which must be right', async () => {
    const { element, view } = await shown()
    const computed = { stats: {}, certificate: {} }
    answers.compute = computed
    expect(await element.compute()).toBe(computed)
    element.method = 'flip'
    element.samples = 0
    await element.compute()
    expect(
      view()
        .asked.filter(([name]) => name === 'compute')
        .map(([, options]) => options),
    ).toEqual([{ method: 'auto' }, { method: 'flip', samples: 0 }])
    answers.compute = undefined
    await expect(element.compute()).rejects.toMatchObject({ code: 'internal', message: /could not be computed/ })
    answers.compute = { problem: 'No samples.' }
    await expect(element.compute()).rejects.toMatchObject({ code: 'badOption', message: 'No samples.' })
    for (const name of ['method', 'samples'] as const) {
      element.setAttribute(name, 'x')
      await expect(element.compute()).rejects.toThrow(name === 'method' ? 'The method must' : 'The samples must')
      element.removeAttribute(name)
    }
  })
})

describe('a state', () => {
  const STATE = {
    circles: THREE,
    view: { x: 1, y: 2, span: 9 },
    layers: { hull: true },
    step: 2,
    method: 'auto',
    lattice: { a: [30, 0], b: [0, 30] },
  } as const

  it('is given back as it was set, before the figure begins, while it runs and after it', async () => {
    const { element } = await shown({ circles: '[[9, 9, 9]]', layers: 'dual', controls: '' })
    await element.setState(STATE)
    expect(element.getState()).toEqual(STATE)
    await disconnect(element)
    expect(element.getState()).toEqual(STATE)
    const early = made({ circles: TEXT, layers: 'hull', step: '2' })
    expect(early.element.getState()).toEqual({ circles: [], layers: { hull: true }, step: 2 })
  })

  it('with circles replaces all that the former had, and later changes of attributes keep its circles', async () => {
    const { element, told } = await shown({
      circles: '[[9, 9, 9]]',
      layers: 'dual',
      region: SQUARE,
      controls: 'player',
    })
    told()
    await element.setState({ circles: THREE })
    expect(element.getState()).toEqual({ circles: THREE, layers: {}, step: 0, method: undefined })
    expect(told()).not.toContain('input')
    element.setAttribute('region', SQUARE)
    await settled(element)
    expect(element.region).toBeDefined()
    expect([...element.circles]).toEqual(THREE.flat())
    const other = await shown({ step: '3' })
    await other.element.setState({ circles: THREE })
    expect(other.element.getState()).not.toHaveProperty('step')
    world.observers.at(-1)?.change()
    await settled(other.element)
    expect([...other.element.circles]).toEqual(THREE.flat())
  })

  it('without circles changes only what it names', async () => {
    const { element } = await shown({ circles: TEXT, layers: 'dual' })
    await element.setState({ view: { x: 4, y: 4, span: 20 } })
    await element.setState({ edits: [{ kind: 'remove', id: 1 }] })
    expect(element.getState()).toMatchObject({
      circles: [THREE[0], THREE[2]],
      layers: { dual: true },
      view: { x: 4, y: 4 },
    })
  })

  it('may be a link, with or without an address, and is an error if it names the data set of a page', async () => {
    const { element } = await shown()
    const link = await encodeLink({ circles: Float64Array.of(1, 1, 1), step: 3 })
    for (const text of [link, `https://example.org/page#${link}`]) {
      await element.setState({ circles: THREE })
      await element.setState(text)
      expect(element.getState()).toMatchObject({ circles: [[1, 1, 1]], step: 3 })
    }
    await expect(element.setState({ dataSet: 'cities' })).rejects.toThrow('The link names the data set cities')
    expect([...element.circles]).toEqual([1, 1, 1])
  })

  it('that is refused is an error of its call, and leaves the circles and the properties', async () => {
    const { element } = await shown()
    failures = [new CircleVoronoiError('negativeRadius', 'Circle 0 is negative.')]
    await expect(element.setState({ circles: [[0, 0, 1]] })).rejects.toThrow('Circle 0 is negative.')
    element.formResetCallback()
    await settled(element)
    expect([...element.circles]).toEqual(THREE.flat())
  })
})

describe('texts', () => {
  it('are in the language of the element, errors too, also if the language was loaded before', async () => {
    for (const isLoaded of [false, true]) {
      const { element, shell } = await shown({ circles: TEXT, controls: '', method: 'x' })
      const { words } = (world as unknown as { stepping: { words(): { lang: string } | undefined } }).stepping
      const said = () => {
        const [, , buttons] = world.mounted.at(-1) as [unknown, unknown, { lang: string }]
        return [shell.described[0].lang, buttons.lang, words()?.lang, shell.problem.startsWith('The method')]
      }
      expect(said()).toEqual(['en', 'en', undefined, true])
      world.calls.length = 0
      element.lang = 'de'
      if (isLoaded) expect(world.calls).toEqual(['redraw'])
      else await eventually(() => expect(shell.described[0].lang).toBe('de'))
      expect(world.calls).toContain('redraw')
      expect(said()).toEqual(['de', 'de', 'de', false])
      expect(figureOf().actions.words.added('1')).not.toContain('added')
      element.lang = null
      expect(said()).toEqual(['en', 'en', undefined, true])
    }
  })

  it('are in the language around the element, also across shadow roots, once it is in its page', async () => {
    await loadWords('de')
    const around = { getAttribute: () => 'de-AT' }
    const root = Object.create(ShadowRoot.prototype) as object
    const { element, shell } = made({})
    Object.assign(element, { getRootNode: () => root })
    Object.assign(root, { host: { closest: () => around } })
    expect(shell.described[0].lang).toBe('en')
    connect(element)
    expect(shell.described[0].lang).toBe('de-AT')
    const plain = made({})
    Object.assign(plain.element, { closest: () => around })
    connect(plain.element)
    expect(plain.shell.described[0].lang).toBe('de-AT')
    const none = made({})
    Object.assign(none.element, { getRootNode: () => ({}) })
    connect(none.element)
    expect(none.shell.described[0].lang).toBe('en')
  })
})

it('circles between the tags are read once the page has them all', async () => {
  vi.stubGlobal('document', Object.assign(new EventTarget(), { readyState: 'loading', visibilityState: 'visible' }))
  const window = new EventTarget()
  vi.stubGlobal('addEventListener', window.addEventListener.bind(window))
  const { element } = made({})
  connect(element)
  for (const start of world.idle.splice(0)) start()
  await aTurn()
  Object.assign(element, { childNodes: [{ nodeType: 3, textContent: '|1|2|3|' }] })
  expect([...element.circles]).toEqual([])
  window.dispatchEvent(new Event('DOMContentLoaded'))
  await element.ready
  expect([...element.circles]).toEqual([1, 2, 3])
})

it('a page defines the element once, by each name with its own modules, and Node defines none', () => {
  const defined = new Map<string, typeof CircleVoronoiElement>()
  expect(() => defineCircleVoronoi()).not.toThrow()
  vi.stubGlobal('customElements', {
    get: (name: string) => defined.get(name),
    define: (name: string, element: typeof CircleVoronoiElement) => {
      expect(defined.has(name)).toBe(false)
      defined.set(name, element)
    },
  })
  const wasm = new Uint8Array()
  defineCircleVoronoi({ wasm })
  defineCircleVoronoi({ name: 'other-figure' })
  defineCircleVoronoi()
  expect([...defined.keys()]).toEqual(['circle-voronoi', 'other-figure'])
  const [own, other] = [...defined.values()]
  expect([own?.load, other?.load]).toEqual([{ wasm }, {}])
  expect(new Set([own, other, CircleVoronoiElement]).size).toBe(3)
  for (const each of defined.values()) expect(each.prototype).toBeInstanceOf(CircleVoronoiElement)
})
