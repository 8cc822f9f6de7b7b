// SPDX-License-Identifier: GPL-3.0-or-later
import type { EditorActions, Opened } from '../editing/editor-actions.ts'
import { type Circles, coordinatesOf } from '../lib/base/coordinates.ts'
import { CircleVoronoiError } from '../lib/base/errors.ts'
import type { Certificate, Float64s, Stats } from '../lib/base/types.ts'
import { decodeLink, type LayerValue, type LinkInput, type LinkView } from '../lib/link.ts'
import type { LoadOptions } from '../lib/wasm/load-options.ts'
import type { Options } from '../lib/wasm/options.ts'
import { checkLayers, keptLayers, type Layers, layersFrom } from '../view/layers.ts'
import { parseControls, parseLayers, parseStep, parseView } from './attributes.ts'
import { holds, idsOf, parseCheck, withIds } from './check.ts'
import type { Check } from './check-types.ts'
import { mountControls } from './controls.ts'
import { circlesWithin, opened, openedFrom, openedState } from './data-of.ts'
import { Figure } from './figure.ts'
import { readCircles } from './read-circles.ts'
import { Shell } from './shell.ts'
import { watchSight } from './sight.ts'
import { type Words, wordsOf } from './words.ts'

/** Numbers of circles, and how many there are of everything else. */
export interface DiagramCounts {
  readonly circles: number
  readonly hidden: number
  readonly vertices: number
  readonly edges: number
}

/** How a diagram was computed from nothing, and what the judge says of it. */
export interface Computation {
  readonly stats: Stats
  readonly certificate: Certificate
}

/** What an element shows, as `getState` gives it. */
export interface FigureState {
  /** x, y and r of each. */
  readonly circles: readonly (readonly number[])[]
  /** `undefined`: all circles are seen. */
  readonly view?: LinkView | undefined
  /** The settings of layers that are not as by default. */
  readonly layers: Readonly<Record<string, LayerValue>>
  /** The step of the method, if it is played. */
  readonly step?: number | undefined
  /** That method, where it is not the usual one. */
  readonly method?: string | undefined
}

/** The events of an element, by their names. All bubble and leave shadow roots. */
export interface CircleVoronoiEventMap {
  /** The circles are others: set, moved, added, deleted. `circles`: x, y and r of each; `numbers`: as of the element. */
  circleschange: CustomEvent<{ readonly circles: Float64s; readonly numbers: Int32Array }>
  /** The diagram is another, and how long that took. */
  diagramchange: CustomEvent<DiagramCounts & { readonly seconds: number }>
  /** What `check` asks for is reached, or no longer so. */
  checkchange: CustomEvent<{ readonly isMet: boolean }>
  /** Others are selected: the numbers of these circles. */
  selectionchange: CustomEvent<{ readonly selection: readonly number[] }>
  /** A step of the method is shown, and how many there are: the last one is the diagram. */
  stepchange: CustomEvent<{ readonly step: number; readonly steps: number }>
  /** Circles, or an attribute, that cannot be shown, and why. */
  error: CustomEvent<{ readonly error: Error }>
}

/** Which part of an element is what: for `HTMLElement` in Node, where there is none. */
const Base: typeof HTMLElement = globalThis.HTMLElement ?? (class {} as unknown as typeof HTMLElement)

const ATTRIBUTES = [
  'alt',
  'check',
  'circles',
  'controls',
  'lang',
  'layers',
  'method',
  'readonly',
  'samples',
  'src',
  'step',
  'view',
] as const

/**
 * `<circle-voronoi>`: circles and their Voronoi diagram, to be looked at, dragged and edited.
 *
 * @category Element
 */
export class CircleVoronoiElement extends Base {
  /** The browser's sign that this can be part of a form. */
  static readonly formAssociated = true
  /** The attributes that are listened to. */
  static readonly observedAttributes: readonly string[] = ATTRIBUTES
  /** How the WebAssembly is found, by the first of these elements on a page. */
  static load: LoadOptions = {}

  readonly #internals: ElementInternals
  readonly #shell: Shell
  #figure: Figure | undefined
  /** What was set in place of attributes and children. */
  #own: Opened | undefined
  /** What was set as layers. */
  #layers: Layers | undefined
  #view: LinkView | undefined
  #step: number | undefined
  #check: Check | undefined
  #isMet: boolean | undefined
  #isDisabled = false
  #isShown = true
  #counts: DiagramCounts | undefined
  #selection: readonly number[] = []
  #stopWatching: (() => void) | undefined
  #children: MutationObserver | undefined
  #loading: AbortController | undefined
  #update: Promise<void> = Promise.resolve()
  /** The arrays that came with events: who sets one again has not changed it. */
  readonly #given = new WeakSet<object>()
  #isReady: () => void = () => {}

  /** Settled once its first circles are shown, or could not be. */
  readonly ready: Promise<void>

  /** As `document.createElement` makes one. */
  constructor() {
    super()
    this.#internals = this.attachInternals()
    this.#shell = new Shell(this.attachShadow({ mode: 'open' }))
    this.ready = new Promise((resolve) => {
      this.#isReady = resolve
    })
    this.#describe()
    this.#shell.onrestyle = () => this.#figure?.restyle()
    // After the figure itself has heard of it.
    this.#shell.frame.addEventListener('wheel', (event) => {
      if (!event.defaultPrevented) this.#shell.hint(this.#words.wheelHint)
    })
  }

  /** Starts once it comes into sight. */
  connectedCallback(): void {
    for (const name of PROPERTIES) this.#upgrade(name)
    this.#applyControls()
    this.#children = new MutationObserver(() => {
      if (this.#figure !== undefined && this.#isOfChildren) this.#reload()
    })
    this.#children.observe(this, { childList: true, subtree: true, characterData: true })
    this.#stopWatching = watchSight(this, (sight) => {
      this.#isShown = sight === 'near'
      if (this.#isShown) this.#start()
      this.#show()
    })
  }

  /** Gives the thread back what it had for it, unless it is only moved. */
  disconnectedCallback(): void {
    this.#stopWatching?.()
    this.#children?.disconnect()
    queueMicrotask(() => {
      if (!this.isConnected) this.#stop()
    })
  }

  /** Takes what an attribute says. */
  attributeChangedCallback(name: (typeof ATTRIBUTES)[number]): void {
    const figure = this.#figure
    switch (name) {
      case 'alt':
        this.#describe()
        return
      case 'check':
        this.#readCheck()
        return
      case 'circles':
      case 'src':
        this.#own = undefined
        if (figure !== undefined) this.#reload()
        return
      case 'controls': {
        this.#applyControls()
        const own = this.#ownStep
        this.#play(own !== undefined || parseControls(this.controls).hasPlayer ? (figure?.step ?? own) : undefined)
        return
      }
      case 'lang':
      case 'readonly':
        this.#applyControls()
        return
      case 'method':
      case 'samples':
        figure?.stepping.restart()
        return
      case 'step':
        this.#step = undefined
        this.#try(() => this.#play(this.#ownStep))
        return
      case 'layers':
        this.#layers = undefined
        this.#try(() => figure?.view.setLayers(this.layers))
        return
      case 'view':
        this.#view = undefined
        this.#try(() => figure?.actions.look(this.view))
    }
  }

  /** Whether a form, or a group of its fields, is disabled. */
  formDisabledCallback(isDisabled: boolean): void {
    this.#isDisabled = isDisabled
    this.#applyControls()
  }

  /** Goes back to what attributes and children say. */
  formResetCallback(): void {
    this.#own = undefined
    if (this.#figure !== undefined) this.#reload()
  }

  /** Takes what the browser has kept. */
  formStateRestoreCallback(state: string): void {
    const { circles } = JSON.parse(state) as { circles: number[][] }
    this.circles = circles
  }

  /** x, y and r of each circle, as it is. It may be set in any form that `compute` takes. */
  get circles(): Float64s {
    if (this.#figure?.editing.scene !== undefined) return this.#figure.editing.circles.circles()
    return this.#own?.circles.slice() ?? new Float64Array()
  }

  set circles(circles: Circles) {
    if (typeof circles === 'object' && circles !== null && this.#given.has(circles)) return
    this.#own = opened(coordinatesOf(circles))
    if (this.#figure !== undefined) this.#reload()
  }

  /**
   * The number of each of `circles`, by which `selection` and `check` call it: its index when they were set, for one that is
   * added the next number. It keeps it when others are deleted, and when it comes back by undo.
   */
  get numbers(): Int32Array {
    const editing = this.#figure?.editing
    if (editing?.scene === undefined) return Int32Array.from({ length: this.circles.length / 3 }, (_, i) => i)
    return editing.circles.ids().map((id) => editing.numberOf(id))
  }

  /** Where the circles are: CSV, JSON or GeoJSON, or a link of the playground. */
  get src(): string {
    return this.getAttribute('src') ?? ''
  }

  set src(src: string) {
    this.setAttribute('src', src)
  }

  /** The part of the plane that is looked at; `undefined`: all circles. */
  get view(): LinkView | undefined {
    const text = this.getAttribute('view')
    return this.#view ?? (text === null ? undefined : parseView(text))
  }

  set view(view: LinkView | undefined) {
    this.#view = view
    this.#figure?.actions.look(view)
  }

  /** What is drawn. What is set is as by default where it says nothing. */
  get layers(): Layers {
    return this.#layers ?? parseLayers(this.getAttribute('layers') ?? '')
  }

  set layers(layers: Partial<Layers>) {
    const next = { ...layersFrom(layers), data: layers.data ?? [] }
    checkLayers(next)
    this.#layers = next
    this.#figure?.view.setLayers(next)
  }

  /**
   * The step of the method that is shown, from 0; `undefined`: the diagram. It is played as long as a step is set, and with
   * `controls="player"`.
   */
  get step(): number | undefined {
    return this.#figure?.step ?? this.#ownStep
  }

  set step(step: number | undefined) {
    this.#step = step === undefined || step === null ? undefined : parseStep(String(step))
    this.#play(this.#ownStep)
  }

  /** The method of `compute()`, by default `auto`, and of the player, by default `touching-disc`. */
  get method(): Exclude<Options['method'], undefined> {
    return (this.getAttribute('method') ?? 'auto') as Exclude<Options['method'], undefined>
  }

  set method(method: Exclude<Options['method'], undefined>) {
    this.setAttribute('method', method)
  }

  /** How many samples that method takes, as in the library. */
  get samples(): number | undefined {
    const text = this.getAttribute('samples')
    return text === null ? undefined : Number(text)
  }

  set samples(samples: number | undefined) {
    this.#reflect('samples', samples === undefined ? undefined : String(samples))
  }

  /** `null`: none; `player`: the player, below the figure; `buttons player`: also buttons; otherwise buttons. */
  get controls(): string | null {
    return this.getAttribute('controls')
  }

  set controls(controls: string | boolean | null) {
    this.#reflect('controls', controls === true ? '' : controls === false ? undefined : (controls ?? undefined))
  }

  /** Whether circles are only looked at. */
  get readonly(): boolean {
    return this.hasAttribute('readonly')
  }

  set readonly(isReadonly: boolean) {
    this.toggleAttribute('readonly', isReadonly)
  }

  /** What the figure is called, for who does not see it. */
  get alt(): string {
    return this.getAttribute('alt') ?? ''
  }

  set alt(alt: string) {
    this.setAttribute('alt', alt)
  }

  /** What the circles have to be for its form to be sent. */
  get check(): Check | undefined {
    return this.#check
  }

  set check(check: Check | string | undefined) {
    this.#reflect('check', typeof check === 'object' ? JSON.stringify(check) : check)
  }

  /** Its name in a form. */
  get name(): string {
    return this.getAttribute('name') ?? ''
  }

  set name(name: string) {
    this.setAttribute('name', name)
  }

  /** The form that it is a part of. */
  get form(): HTMLFormElement | null {
    return this.#internals.form
  }

  /** Whether its check, if it has one, is met. */
  get validity(): ValidityState {
    return this.#internals.validity
  }

  /** What is said if it is not. */
  get validationMessage(): string {
    return this.#internals.validationMessage
  }

  /** Whether a form may be sent, as far as this is concerned. */
  checkValidity(): boolean {
    return this.#internals.checkValidity()
  }

  /** The same; if it may not, the browser says why. */
  reportValidity(): boolean {
    return this.#internals.reportValidity()
  }

  /** The numbers of the circles that are selected. */
  get selection(): readonly number[] {
    return this.#selection
  }

  set selection(selection: readonly number[]) {
    const figure = this.#figure
    figure?.actions.select(selection.map((number) => figure.editing.idOf(number)))
  }

  /** Settled once all that was set is computed and painted. */
  get updateComplete(): Promise<void> {
    return this.#settled()
  }

  /** Moves the focus to the picture. */
  override focus(options?: FocusOptions): void {
    this.#shell.figure.focus(options)
  }

  /**
   * Computes the diagram of the circles as they are from nothing, by `method` and `samples`: how, and what the judge says. What
   * is shown stays the certified diagram.
   *
   * @throws CircleVoronoiError as `compute` of the library
   */
  async compute(): Promise<Computation> {
    const figure = await this.#started()
    const samples = this.samples === undefined ? {} : { samples: this.samples }
    const computed = await figure.view.compute({ method: this.method, ...samples })
    if (computed === undefined) throw new Error('The diagram could not be computed. Try again.')
    if ('problem' in computed) throw new CircleVoronoiError('badOption', -1, computed.problem)
    return computed
  }

  /** What is shown, to be kept: plain data, which `JSON.stringify` and `encodeLink` take. */
  getState(): FigureState {
    const circles = listOf(this.circles)
    const own = this.#own
    const { view, layers, step, method } = this.#figure?.actions.linkState() ?? {
      view: own?.view,
      layers: own?.layers ?? keptLayers(this.layers),
      step: this.step ?? own?.step,
      method: own?.method,
    }
    return {
      circles,
      ...(view && { view }),
      layers: layers ?? {},
      ...(step !== undefined && { step }),
      ...(method !== undefined && { method }),
    }
  }

  /**
   * Shows what was kept, or what a link says.
   *
   * @throws CircleVoronoiError if that cannot be shown; then all stays as it was
   */
  async setState(state: LinkInput | string): Promise<void> {
    const next =
      typeof state === 'string'
        ? openedState(await decodeLink(state.replace(/^.*#/, '')))
        : openedState({ ...state, circles: state.circles && coordinatesOf(state.circles) })
    const figure = await this.#started()
    await figure.open({ ...next, layers: next.layers ?? {}, step: next.step ?? this.#firstStep })
    this.#own = next
  }

  /** Plays the method from the step that is shown on, or from the beginning. Ends once it is played. */
  async play(): Promise<void> {
    const figure = await this.#started()
    figure.stepping.play()
    await figure.stepping.whenReady()
  }

  /** Stays at the step that is shown. */
  pause(): void {
    this.#figure?.stepping.pause()
  }

  /** Shows a step of the method, or the nearest one that there is. Ends once it is shown. */
  async stepTo(step: number): Promise<void> {
    parseStep(String(step))
    const figure = await this.#started()
    figure.stepping.pause()
    figure.actions.showStep(step)
    await figure.stepping.whenReady()
  }

  /** What is seen, as the text of an SVG. */
  async toSVG(): Promise<string> {
    return (await this.#started()).view.toSVG()
  }

  /** What is seen, as a PNG of `scale` pixels for each CSS pixel. */
  async toPNG(scale?: number): Promise<Blob> {
    return (await this.#started()).view.toPNG(scale)
  }

  override addEventListener<Name extends keyof CircleVoronoiEventMap>(
    name: Name,
    listener: (this: CircleVoronoiElement, event: CircleVoronoiEventMap[Name]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void
  override addEventListener<Name extends keyof HTMLElementEventMap>(
    name: Name,
    listener: (this: CircleVoronoiElement, event: HTMLElementEventMap[Name]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void
  override addEventListener(
    name: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void
  /** As of any element, with the types of its own events. */
  override addEventListener(
    name: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void {
    super.addEventListener(name, listener, options)
  }

  get #isReadonly(): boolean {
    return this.readonly || this.#isDisabled
  }

  get #isOfChildren(): boolean {
    return this.#own === undefined && !this.hasAttribute('circles') && !this.hasAttribute('src')
  }

  async #started(): Promise<Figure> {
    if (this.isConnected) this.#start()
    await this.#update
    if (this.#figure === undefined) throw new Error('The figure is in no page, or no longer.')
    return this.#figure
  }

  async #settled(): Promise<void> {
    await this.#update
    await this.#figure?.stepping.whenReady()
    await this.#figure?.whenPainted()
  }

  #start(): void {
    if (this.#figure !== undefined) return
    const { figure, frame, controls, player, said } = this.#shell
    const places = { figure, around: frame, controls, player, said }
    this.#figure = new Figure(places, (this.constructor as typeof CircleVoronoiElement).load, {
      onoutcome: ({ edited }) => {
        this.#shell.isRunning = true
        this.#counts = edited.counts
        this.#describe()
        this.#tellForm()
        this.#tell('circleschange', this.#detail())
        this.#tell('diagramchange', { ...edited.counts, seconds: edited.seconds })
      },
      onproblem: (error) => this.#tell('error', { error }),
      played: (kept = 'touching-disc') => {
        const { samples } = this
        const method = this.getAttribute('method') ?? kept
        return { method: method as this['method'], ...(samples !== undefined && { samples }) }
      },
      onstep: (step, steps) => this.#tell('stepchange', { step, steps }),
    })
    const { store, editing } = this.#figure
    let before: readonly number[] = []
    store.subscribe(({ selection, problem }) => {
      this.#shell.problem = problem
      if (selection === before) return
      before = selection
      const isSame = selection.length === 0 && this.#selection.length === 0
      this.#selection = selection.map((id) => editing.numberOf(id))
      if (!isSame) this.#tell('selectionchange', { selection: this.#selection })
    })
    this.#try(() => this.#figure?.view.setLayers(this.layers))
    this.#applyControls()
    this.#show()
    this.#reload()
  }

  #stop(): void {
    const figure = this.#figure
    if (figure === undefined) return
    if (figure.editing.scene !== undefined) {
      const { view, layers = {}, step, method } = figure.actions.linkState() ?? {}
      this.#own = opened(figure.editing.circles.circles(), { view, layers, step, method })
    }
    this.#loading?.abort()
    figure.dispose()
    this.#figure = undefined
    this.#shell.isRunning = false
  }

  #show(): void {
    if (this.#figure === undefined) return
    this.#figure.isShown = this.#isShown
    this.#shell.isShown = this.#isShown
  }

  /** Opens what attributes, properties and children say. */
  #reload(): void {
    this.#loading?.abort()
    const loading = new AbortController()
    this.#loading = loading
    const figure = this.#figure as Figure
    this.#update = this.#open(figure, loading.signal).then(this.#isReady)
  }

  async #open(figure: Figure, signal: AbortSignal): Promise<void> {
    try {
      const opened = await this.#opened(signal)
      if (signal.aborted || opened === undefined) return
      const view = opened.view ?? this.view
      const layers = opened.layers ?? keptLayers(this.layers)
      const step = opened.step ?? this.#ownStep ?? this.#firstStep
      await figure.open({ ...opened, view, layers, step })
      figure.view.setLayers({ data: this.#layers?.data ?? [] })
    } catch (error) {
      // What was refused is told already.
      if (!signal.aborted && !figure.isTold(error as Error)) this.#fail(error as Error)
    }
  }

  /** `undefined`: nothing is said of circles. */
  async #opened(signal: AbortSignal): Promise<Opened | undefined> {
    if (this.#own !== undefined) return this.#own
    const text = this.getAttribute('circles')
    if (text !== null) return opened(readCircles(text))
    if (this.src !== '') return openedFrom(new URL(this.src, this.baseURI).href, signal)
    const circles = circlesWithin(this)
    return circles && opened(circles)
  }

  /** What the page says. */
  get #ownStep(): number | undefined {
    const text = this.getAttribute('step')
    return this.#step ?? (text === null ? undefined : parseStep(text))
  }

  /** Where the method begins, if it is to be played at all. */
  get #firstStep(): number | undefined {
    return parseControls(this.controls).hasPlayer ? 0 : undefined
  }

  #play(step: number | undefined): void {
    const figure = this.#figure
    if (figure?.editing.scene !== undefined) figure.actions.showStep(step ?? this.#firstStep)
  }

  #applyControls(): void {
    const { controls, player } = this.#shell
    const { hasButtons, hasPlayer } = parseControls(this.controls)
    player.hidden = !hasPlayer
    this.#describe()
    const figure = this.#figure
    if (figure === undefined) return
    const actions: EditorActions = figure.actions
    actions.isReadonly = this.#isReadonly
    if (this.#isReadonly) actions.useTool('select')
    if (!hasButtons) controls.replaceChildren()
    else mountControls(this.#shell, figure, this.#words, this.#isReadonly)
  }

  #readCheck(): void {
    const text = this.getAttribute('check')
    this.#check = undefined
    this.#try(() => {
      this.#check = text === null ? undefined : parseCheck(text)
    })
    this.#tellForm()
  }

  /** What is sent with a form, and whether it may be. */
  async #tellForm(): Promise<void> {
    const figure = this.#figure
    const check = this.#check
    // It calls circles by their numbers.
    const asked = check && figure && withIds(check, (number) => figure.editing.idOf(number))
    const facts = asked && (await figure?.view.tell(idsOf(asked)))
    // Meanwhile there may be others.
    if (figure !== this.#figure || check !== this.#check) return
    const isMet = check && asked !== undefined && facts !== undefined && holds(asked, facts)
    const isOther = isMet !== this.#isMet
    if (isOther) {
      this.#isMet = isMet
      if (isMet === true) this.#internals.states?.add('met')
      else this.#internals.states?.delete('met')
      this.#describe()
    }
    if (isMet === false) this.#internals.setValidity({ customError: true }, this.#words.unmet, this.#shell.figure)
    else this.#internals.setValidity({})
    if (isOther) this.#tell('checkchange', { isMet: isMet === true })
    if (this.#internals.form === null || figure === undefined) return
    const circles = listOf(figure.editing.circles.circles())
    this.#internals.setFormValue(JSON.stringify(isMet === undefined ? { circles } : { circles, check: isMet }))
  }

  #describe(): void {
    const words = this.#words
    const said = this.#isMet === undefined ? '' : this.#isMet ? ` ${words.met}` : ` ${words.unmet}`
    const about = this.#counts === undefined ? '' : words.describe(this.#counts) + said
    this.#shell.describe(words, this.alt, about, this.#isReadonly)
  }

  /** Those of the page's language, as far as it is known. */
  get #words(): Words {
    let element: Element | undefined = this
    while (element !== undefined) {
      const known: Element | null = element.closest('[lang]')
      if (known !== null) return wordsOf(known.getAttribute('lang') as string)
      const root = element.getRootNode()
      element = root instanceof ShadowRoot ? root.host : undefined
    }
    return wordsOf('')
  }

  /** The circles are copied for whoever looks at them. */
  #detail(): CircleVoronoiEventMap['circleschange']['detail'] {
    let circles: Float64s | undefined
    const numbers = () => this.numbers
    const give = () => {
      circles ??= this.circles
      this.#given.add(circles)
      return circles
    }
    return {
      get circles() {
        return give()
      },
      get numbers() {
        return numbers()
      },
    }
  }

  #try(act: () => void): void {
    try {
      act()
    } catch (error) {
      this.#fail(error as Error)
    }
  }

  #fail(error: Error): void {
    if (this.#figure === undefined) this.#shell.problem = error.message
    else this.#figure.actions.complain(error.message)
    this.#tell('error', { error })
  }

  #tell<Name extends keyof CircleVoronoiEventMap>(name: Name, detail: CircleVoronoiEventMap[Name]['detail']): void {
    this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true, composed: true }))
  }

  #reflect(name: string, value: string | undefined): void {
    if (value === undefined) this.removeAttribute(name)
    else this.setAttribute(name, value)
  }

  /** A property may have been set before this was an element of this class. */
  #upgrade(name: (typeof PROPERTIES)[number]): void {
    if (!Object.hasOwn(this, name)) return
    const value = this[name]
    delete (this as Partial<Record<typeof name, unknown>>)[name]
    Object.assign(this, { [name]: value })
  }
}

function listOf(circles: Float64s): number[][] {
  return Array.from({ length: circles.length / 3 }, (_, i) => [...circles.subarray(3 * i, 3 * i + 3)])
}

const PROPERTIES = [
  'circles',
  'src',
  'view',
  'layers',
  'method',
  'samples',
  'step',
  'controls',
  'readonly',
  'alt',
  'check',
  'name',
] as const

declare global {
  interface HTMLElementTagNameMap {
    'circle-voronoi': CircleVoronoiElement
  }
}
