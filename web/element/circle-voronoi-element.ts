// SPDX-License-Identifier: GPL-3.0-or-later

import type { Past } from '../editing/editing.ts'
import { type FigureActions, figureActions } from '../editing/figure-actions.ts'
import { type OpenRequest, requestOf } from '../editing/open-request.ts'
import { problemOf } from '../editing/problem.ts'
import { showStep } from '../editing/state.ts'
import { type Circles, coordinatesOf } from '../lib/base/coordinates.ts'
import { CircleVoronoiError } from '../lib/base/errors.ts'
import type { Certificate, Float64s, Method, Stats } from '../lib/base/types.ts'
import type { Check } from '../lib/check-types.ts'
import type { Lattice } from '../lib/diagram/lattice.ts'
import type { LayerValue, LinkInput, LinkView } from '../lib/link.ts'
import { plainRegion, type RegionShape } from '../lib/regions/region-shape.ts'
import { Figure } from '../player/figure.ts'
import type { DiagramCounts } from '../view/diagram-counts.ts'
import { type Areas, type Domain, NO_DOMAIN } from '../view/domain.ts'
import { toPNG, toSVG } from '../view/export.ts'
import { keptLayers, type Layers } from '../view/layers.ts'
import type { FigureLoadOptions } from '../view/load.ts'
import { PrintDrawing } from '../view/print-drawing.ts'
import { shownValue } from '../view/refusal.ts'
import { Rings } from '../view/rings.ts'
import type { View } from '../view/view.ts'
import { checkCircles, holds, idsOf } from './check.ts'
import { mountControls, paddingBelow } from './controls.ts'
import {
  checkedState,
  circlesWithin,
  linkState,
  regionAt,
  requestAt,
  requestOfState,
  requestOfText,
} from './data-of.ts'
import type { CircleVoronoiProps } from './frameworks.ts'
import type { Goal } from './goal-types.ts'
import { goalRings, goalSentence, goalsOf } from './goals.ts'
import { whenIdle } from './idle.ts'
import { loadWords, wordsOf } from './language.ts'
import {
  attributeText,
  type Part,
  PROPERTIES,
  type Property,
  type PropertyName,
  type ValueOf,
  type Values,
} from './properties.ts'
import { circlesOfValue } from './read-circles.ts'
import { refuse } from './refusals.ts'
import { Shell } from './shell.ts'
import { watchVisibility } from './visibility.ts'
import type { Words } from './words.ts'

/** How a diagram was computed from scratch, and the certificate of the result. */
export interface Computation {
  readonly stats: Stats
  readonly certificate: Certificate
}

/** The state of an element, as `getState` returns it. */
export interface FigureState {
  /** The x, y and r of each circle. */
  readonly circles: readonly (readonly number[])[]
  /** The visible part of the plane; `undefined` if all circles are visible. */
  readonly view?: LinkView | undefined
  /** The layers that differ from the defaults. */
  readonly layers: Readonly<Record<string, LayerValue>>
  /** The step of the method that is visible; `undefined` if the method is not played. */
  readonly step?: number | undefined
  /** The method that is played; `undefined` for the default method. */
  readonly method?: string | undefined
  /** The region to which cells are clipped; `undefined` if there is none. */
  readonly region?: RegionShape | undefined
  /** The periods with which the circles repeat; `undefined` if they do not. */
  readonly lattice?: Lattice | undefined
  /** The areas of the cells, in the order of the circles; `undefined` if circles keep their radii. */
  readonly areas?: Areas | undefined
}

/** The events of an element, by name. All events bubble and leave shadow roots. */
export interface CircleVoronoiEventMap {
  /** Circles were set, moved, added or deleted. `circles` has x, y and r of each; `ids` has the id of each. */
  circleschange: CustomEvent<{ readonly circles: Float64s; readonly ids: Int32Array }>
  /** The diagram has changed. `seconds` is the time that the change took. */
  diagramchange: CustomEvent<DiagramCounts & { readonly seconds: number }>
  /** The circles now meet the `check`, or no longer do. */
  checkchange: CustomEvent<{ readonly isMet: boolean }>
  /** A value that the `check` asks for has changed. `text` says all values and goals in the language of the element. */
  goalschange: CustomEvent<{ readonly goals: readonly Goal[]; readonly text: string }>
  /** The selection has changed: the ids of the selected circles. */
  selectionchange: CustomEvent<{ readonly selection: readonly number[] }>
  /** A reader has changed the circles, also while dragging one: like the event of form controls. */
  input: Event
  /** A reader has changed the circles and released them. */
  change: Event
  /** Another step of the method is visible. `steps` is the number of steps; the last step is the diagram. */
  stepchange: CustomEvent<{ readonly step: number; readonly steps: number }>
  /** Circles, an attribute or a property cannot be shown. The message of `error` says why. */
  error: CustomEvent<{ readonly error: Error }>
}

/** With more circles, no drawing for print is kept, because each edit would take long. */
const MOST_DRAWN = 5000

/** A substitute for `HTMLElement` in Node, where this module can be imported but not used. */
const Base: typeof HTMLElement = globalThis.HTMLElement ?? (class {} as unknown as typeof HTMLElement)

/** The names of all properties that can be set before the class is defined, in the order in which they take effect. */
const NAMES = ['value', ...(Object.keys(PROPERTIES) as PropertyName[]), 'selection'] as const

/**
 * `<circle-voronoi>`: a figure of circles and their Voronoi diagram, which readers can explore and edit.
 *
 * @category Element
 * @slot - The circles, as a table or a script of type application/json; or the content to show where there is no figure.
 * @slot poster - A picture to show until the figure appears.
 * @slot caption - The caption, below the figure.
 * @csspart figure - The picture.
 * @csspart fallback - The content that is visible until the figure appears.
 * @csspart controls - The buttons.
 * @csspart player - The player: the text about the method, and its buttons.
 * @csspart hint - The hint that is visible for a moment.
 * @csspart problem - The error message.
 * @csspart rings - The rings around the circles of the check, with their labels.
 * @csspart ring-number - The number of the circle in a label.
 * @csspart ring-value - The current value in a label.
 * @cssState met - The circles meet the check.
 * @cssprop {<color>} --circle-voronoi-paper - The background.
 * @cssprop {<color>} --circle-voronoi-edge - Edges and vertices of the diagram.
 * @cssprop {<color>} --circle-voronoi-rim - Rims of circles. By default, rims are not drawn.
 * @cssprop {<color>} --circle-voronoi-hidden - Circles that others contain.
 * @cssprop {<color>} --circle-voronoi-accent - Hovered, selected and focused circles.
 * @cssprop {<color>} --circle-voronoi-selected-disc - The outline of the selected circle.
 * @cssprop {<color>} --circle-voronoi-selected-cell - The outline of the selected circle's cell.
 * @cssprop {<color>} --circle-voronoi-neighbor-cell - The outlines of the cells next to the selected circle's.
 * @cssprop {<color>} --circle-voronoi-hull - The layer hull.
 * @cssprop {<color>} --circle-voronoi-dual - The layer dual.
 * @cssprop {<color>} --circle-voronoi-delaunay - The layer delaunay.
 * @cssprop {<color>} --circle-voronoi-ordinary - The layer ordinary.
 * @cssprop {<color>} --circle-voronoi-power - The layer power.
 * @cssprop {<color>} --circle-voronoi-touching - The layers disc and largest-disc.
 * @cssprop {<color>} --circle-voronoi-path - The layer path.
 * @cssprop {<color>} --circle-voronoi-merged - Vertices that the layer near-zero merges.
 * @cssprop {<color>} --circle-voronoi-samples - The layer samples.
 * @cssprop {<color>} --circle-voronoi-sample-graph - The layer sample-graph.
 * @cssprop {<color>} --circle-voronoi-antipodal-discs - The layer antipodal-discs.
 * @cssprop {<color>} --circle-voronoi-directed-edges - The layer directed-edges.
 * @cssprop {<color>} --circle-voronoi-missed-edges - Edges that the touching disc method misses, if the page draws them.
 * @cssprop {<color>} --circle-voronoi-region - The border of the region.
 * @cssprop {<color>} --circle-voronoi-tint-0 - The first of the six colors for measures, such as cells=area: the color of the smallest value.
 * @cssprop {<color>} --circle-voronoi-tint-1 - The second color of the ramp.
 * @cssprop {<color>} --circle-voronoi-tint-2 - The third color of the ramp.
 * @cssprop {<color>} --circle-voronoi-tint-3 - The fourth color of the ramp.
 * @cssprop {<color>} --circle-voronoi-tint-4 - The fifth color of the ramp.
 * @cssprop {<color>} --circle-voronoi-tint-5 - The sixth color of the ramp: the color of the largest value.
 * @cssprop {<color>} --circle-voronoi-map-0 - One of eight colors by which circles differ.
 * @cssprop {<color>} --circle-voronoi-map-1 - One of eight colors by which circles differ.
 * @cssprop {<color>} --circle-voronoi-map-2 - One of eight colors by which circles differ.
 * @cssprop {<color>} --circle-voronoi-map-3 - One of eight colors by which circles differ.
 * @cssprop {<color>} --circle-voronoi-map-4 - One of eight colors by which circles differ.
 * @cssprop {<color>} --circle-voronoi-map-5 - One of eight colors by which circles differ.
 * @cssprop {<color>} --circle-voronoi-map-6 - One of eight colors by which circles differ.
 * @cssprop {<color>} --circle-voronoi-map-7 - One of eight colors by which circles differ.
 * @cssprop {<color>} --circle-voronoi-cell-opacity - A color whose alpha value is the opacity of the circles' colors in their cells.
 * @cssprop {<ratio>} [--circle-voronoi-aspect-ratio=3 / 2] - The aspect ratio of the picture, if its height is not set.
 */
// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: its static members define the accessors of the interface
export class CircleVoronoiElement extends Base {
  /** Tells the browser that the element can be part of a form. */
  static readonly formAssociated = true
  /** The attributes that the element observes, one for each property. */
  static readonly observedAttributes: readonly string[] = (Object.keys(PROPERTIES) as PropertyName[]).map((name) => {
    CircleVoronoiElement.#define(name)
    return name
  })
  /** The sources of the WebAssembly, used by the first element of a page. */
  static load: FigureLoadOptions = {}

  /**
   * Defines the accessors of a property. No static block calls this: bundlers that rewrite such a block for older browsers
   * may name it like a private member that was renamed here (SWC, "duplicate private name #_").
   */
  static #define(name: PropertyName): void {
    if (Object.hasOwn(CircleVoronoiElement.prototype, name)) return
    Object.defineProperty(CircleVoronoiElement.prototype, name, {
      get(this: CircleVoronoiElement) {
        return this.#get(name)
      },
      set(this: CircleVoronoiElement, value: unknown) {
        this.#set(name, value)
      },
      configurable: true,
    })
  }

  readonly #internals: ElementInternals
  readonly #shell: Shell
  #figure: Figure | undefined
  /** The values of attributes. */
  readonly #parsed: Values = {}
  /** The values of properties, which replace those of attributes. */
  readonly #assigned: Values = {}
  /** The data that was set by properties instead of attributes and children. */
  #request: OpenRequest | undefined
  #isMet: boolean | undefined
  #goals: readonly Goal[] = []
  /** The goals in a sentence, as the last event told them. */
  #goalText = ''
  /** The rings around the circles of the check, once there is one. */
  #rings: Rings | undefined
  #isDisabled = false
  #isShown = true
  /** The selection of the last event, perhaps in a figure that has ended. */
  #lastSelection: readonly number[] = []
  /** A selection that waits for its circles. */
  #nextSelection: readonly number[] | undefined
  #stopWatching: (() => void) | undefined
  #stopWaiting: (() => void) | undefined
  /** The undo history of a figure that has ended, for when its circles are shown again. */
  #past: { readonly request: OpenRequest; readonly past: Past } | undefined
  #printed: PrintDrawing | undefined
  /** The cached `value`, and the number of its change. */
  #cached: { readonly circles: Float64s; readonly change: number } | undefined
  /** The number of running changes by programs. Without any, changes are a reader's. */
  #programs = 0
  /** Whether a reader still holds the circles that they have changed. */
  #isHeld = false
  #children: MutationObserver | undefined
  #loading: AbortController | undefined
  /** Whether circles are being opened. */
  #isOpening = false
  /** Whether a change of region or areas is pending. */
  #isChanging = false
  /** The download of the element's language. */
  #speaking: Promise<void> | undefined
  #update: Promise<void> = Promise.resolve()
  /** The pending update of the form's value and validity. */
  #telling: Promise<void> = Promise.resolve()
  /** The array of the last event. Setting it again changes nothing. */
  #newest: object | undefined
  #changes = 0
  #ready = new Deferred()
  /** The errors of attributes and properties, by name. */
  readonly #errors = new Map<string, Error>()
  /** Updates each part of the figure that a property changes. */
  readonly #updates: Readonly<Record<Part, () => void>> = {
    check: () => {
      this.#tellForm()
      this.#checkCircles()
    },
    circles: () => this.#setRequest(undefined),
    controls: () => {
      this.#applyControls()
      const isPlayed = this.#value('step') !== undefined || this.#value('controls').hasPlayer
      this.#play(isPlayed ? this.step : undefined)
    },
    description: () => this.#describe(),
    domain: () => this.#changeDomain(),
    editing: () => this.#applyControls(),
    form: () => {},
    language: () => this.#speak(),
    layers: () => this.#figure?.view.setLayers(this.#value('layers')),
    method: () => this.#figure?.stepping.restart(),
    step: () => this.#play(this.#value('step')),
    view: () => this.#figure?.actions.camera.showView(this.view),
  }

  /** Creates an element, as `document.createElement` does. */
  constructor() {
    super()
    this.#internals = this.attachInternals()
    this.#shell = new Shell(this.attachShadow({ mode: 'open' }))
    this.#describe()
    this.#shell.onrestyle = () => this.#figure?.view.restyle()
    // Listens after the figure itself.
    for (const name of ['pointerup', 'pointercancel', 'lostpointercapture']) {
      this.#shell.figure.addEventListener(name, () => queueMicrotask(() => this.#tellReleased(0)))
    }
    this.#shell.frame.addEventListener('wheel', (event) => {
      if (!event.defaultPrevented) this.#shell.hint(this.#words.wheelHint)
    })
  }

  /** Starts the figure when it comes into view, or when the browser has nothing else to do. */
  connectedCallback(): void {
    for (const name of NAMES) this.#upgrade(name)
    this.#speak()
    this.#children = new MutationObserver(() => {
      if (this.#figure !== undefined && this.#isOfChildren) this.#reload()
    })
    this.#children.observe(this, { childList: true, subtree: true, characterData: true })
    // Printing needs the whole page, and a hidden tab never becomes visible first.
    const { connection } = navigator as { readonly connection?: { readonly saveData?: boolean } }
    if (connection?.saveData !== true) this.#stopWaiting = whenIdle(() => this.#start())
    this.#stopWatching = watchVisibility(this, (sight) => {
      this.#isShown = sight === 'near'
      if (this.#isShown) this.#start()
      this.#show()
    })
  }

  /** Ends the figure, unless the element is only moved. The undo history is kept in both cases. */
  disconnectedCallback(): void {
    this.#stopWatching?.()
    this.#stopWaiting?.()
    this.#children?.disconnect()
    queueMicrotask(() => {
      if (this.isConnected) return
      this.#stop()
      this.#ready.settle()
      this.#ready = new Deferred()
    })
  }

  /** Applies an attribute. A wrong value is an `error` event and changes nothing. */
  attributeChangedCallback(name: string, _before: string | null, text: string | null): void {
    this.#try(name, () => {
      const parsed = text === null ? undefined : PROPERTIES[name as PropertyName].parse(text)
      Object.assign(this.#parsed, { [name]: parsed })
      Object.assign(this.#assigned, { [name]: undefined })
      this.#updates[PROPERTIES[name as PropertyName].part]()
    })
  }

  /** The value of a property or of its attribute; `undefined` if neither is set. */
  #given<Name extends PropertyName>(name: Name): Values[Name] {
    return this.#assigned[name] ?? this.#parsed[name]
  }

  #value<Name extends PropertyName>(name: Name): ValueOf<Name> {
    return (this.#given(name) ?? (PROPERTIES[name] as Property).none) as ValueOf<Name>
  }

  #get(name: PropertyName): unknown {
    if (name === 'controls') return this.getAttribute(name)
    const isOfDomain = name === 'areas' || name === 'lattice' || name === 'region'
    return structuredClone(isOfDomain ? this.#currentDomain[name] : this.#value(name))
  }

  #set(name: PropertyName, given: unknown): void {
    const { copied, none, part }: Property = PROPERTIES[name]
    const value = none === false ? given === true : (given ?? undefined)
    if (copied !== undefined && typeof value !== 'string') {
      this.#try(name, () => {
        Object.assign(this.#assigned, { [name]: value === undefined ? undefined : copied(value as never) })
        this.#updates[part]()
      })
      return
    }
    let text: string | undefined
    try {
      text = attributeText(value)
    } catch (error) {
      this.#fail(name, error as Error)
      return
    }
    if (text !== undefined) this.setAttribute(name, text)
    else if (this.hasAttribute(name)) this.removeAttribute(name)
    else this.#clearError(name)
  }

  /** Disables editing while the form, or a group of its fields, is disabled. */
  formDisabledCallback(isDisabled: boolean): void {
    this.#isDisabled = isDisabled
    this.#applyControls()
  }

  /** Restores the circles of the attributes and children. */
  formResetCallback(): void {
    this.#setRequest(undefined)
  }

  /** Restores the circles that the browser has kept. */
  formStateRestoreCallback(state: string): void {
    const { circles } = JSON.parse(state) as { circles: number[][] }
    this.circles = circles
  }

  /**
   * A promise that resolves when the first circles are visible, or when they cannot be shown. It is pending until the
   * element comes into view or you call one of its methods. It resolves at once if the element is in no page.
   */
  get ready(): Promise<void> {
    return this.#whenReady()
  }

  async #whenReady(): Promise<void> {
    // The calling script may insert the element afterwards.
    await new Promise((resolve) => setTimeout(resolve))
    if (this.isConnected) await this.#ready.promise
  }

  /**
   * The current x, y and r of each circle. Set circles in any form that `compute` takes, or as text like the attribute:
   * JSON (`[[x, y, r], ...]`, or objects with x, y and r), GeoJSON or CSV. `undefined` or `null` restores the circles
   * of the attributes and children. Circles that cannot be shown cause an `error` event.
   */
  get circles(): Float64s {
    if (this.#figure?.editing.scene !== undefined) return this.#figure.editing.circles.circles()
    return this.#request?.circles.slice() ?? new Float64Array()
  }

  set circles(circles: CircleVoronoiProps['circles']) {
    if (typeof circles === 'string') this.#set('circles', circles)
    else if (!isSet(circles) || circles !== this.#newest) this.#try('circles', () => this.#setCircles(circles))
  }

  /**
   * An alias of `circles`, by the name that form libraries use. Between two changes it is one object. Setting the
   * current circles again changes nothing, and `''` means "not set".
   */
  get value(): Float64s {
    if (this.#cached?.change !== this.#changes) this.#cached = { circles: this.circles, change: this.#changes }
    return this.#cached.circles
  }

  set value(value: CircleVoronoiProps['value']) {
    if (value === '') this.circles = undefined
    else if (typeof value === 'string' || !isSet(value)) this.circles = value
    else this.#try('circles', () => this.#setValue(value))
  }

  #setValue(value: Circles): void {
    const [given, known] = [coordinatesOf(value), this.value]
    if (given.length !== known.length || given.some((number, k) => number !== known[k])) this.#setCircles(value)
  }

  /**
   * The id of each of `circles`, which `selection` and `check` use. The circles that you set have the ids 0, 1 and so on;
   * each added circle gets the next id. A circle keeps its id when others are deleted, and when undo brings it back.
   */
  get ids(): Int32Array {
    const editing = this.#figure?.editing
    if (editing?.scene !== undefined) return editing.circles.ids()
    return this.#request?.kept?.ids.slice() ?? Int32Array.from({ length: this.circles.length / 3 }, (_, i) => i)
  }

  /**
   * The step of the method that is visible, from 0, or `undefined` if the figure shows the diagram. The figure shows the
   * method while a step is set, and with `controls="player"`.
   */
  get step(): number | undefined {
    return this.#figure?.step ?? this.#value('step')
  }

  set step(step: number | undefined | null) {
    // Removing a missing attribute causes no callback.
    if (!isSet(step) && !this.hasAttribute('step')) this.#play(undefined)
    else this.#set('step', step)
  }

  /** The form that the element belongs to. */
  get form(): HTMLFormElement | null {
    return this.#internals.form
  }

  /** The validity of the field: invalid while the circles do not meet the `check`. */
  get validity(): ValidityState {
    return this.#internals.validity
  }

  /** The message of an invalid field. */
  get validationMessage(): string {
    return this.#internals.validationMessage
  }

  /** Returns whether the circles meet the `check`. */
  checkValidity(): boolean {
    return this.#internals.checkValidity()
  }

  /** Returns whether the circles meet the `check`; if they do not, the browser shows the message. */
  reportValidity(): boolean {
    return this.#internals.reportValidity()
  }

  /** The ids of the selected circles. A selection that you set before the circles are visible is applied when they are. */
  get selection(): readonly number[] {
    return (this.#nextSelection ?? this.#figure?.store.get().selection ?? []).slice()
  }

  set selection(selection: CircleVoronoiProps['selection']) {
    this.#try('selection', () => {
      const ids: unknown = selection ?? []
      if (!Array.isArray(ids)) {
        refuse((words) => words.must(words.selection, words.listOfIds, shownValue(ids)))
      }
      this.#nextSelection = ids.slice()
      if (!this.#isOpening) this.#select()
    })
  }

  /** Applies a pending selection once there are circles. */
  #select(): void {
    const figure = this.#figure
    const next = this.#nextSelection
    if (next === undefined || figure?.editing.scene === undefined) return
    this.#nextSelection = undefined
    figure.actions.selection.select(next)
  }

  /** A promise that resolves when everything that you set is computed, checked and painted. */
  get updateComplete(): Promise<void> {
    return this.#settled()
  }

  /** Moves the focus to the figure. */
  override focus(options?: FocusOptions): void {
    this.#shell.figure.focus(options)
  }

  /**
   * Computes the diagram of the current circles from scratch, by `method` and `samples`, and returns how it was computed
   * and its certificate. The figure keeps showing the certified diagram.
   *
   * @throws CircleVoronoiError as `compute` of the library
   */
  async compute(): Promise<Computation> {
    const figure = await this.#started()
    for (const name of ['method', 'samples']) {
      const wrong = this.#errors.get(name)
      if (wrong !== undefined) throw wrong
    }
    const { method, samples } = this
    const computed = await figure.view.scene.ask('compute', [{ method, ...(samples !== undefined && { samples }) }])
    if (computed === undefined) refuse((words) => words.notComputedAgain, 'internal')
    if ('problem' in computed) throw new CircleVoronoiError('badOption', computed.problem)
    return computed
  }

  /** Returns the state of the figure as plain data, which `JSON.stringify` and `encodeLink` take. */
  getState(): FigureState {
    const circles = listOf(this.circles)
    const request = this.#request
    const { region, lattice, areas } = this
    const { view, layers, step, method } = this.#figure?.actions.opening.linkState() ?? {
      ...request,
      layers: request?.layers ?? keptLayers(this.layers),
      step: this.step ?? request?.step,
    }
    return {
      circles,
      ...(view && { view }),
      layers: layers ?? {},
      ...(step !== undefined && { step }),
      ...(method !== undefined && { method }),
      ...(region && { region }),
      ...(lattice && { lattice }),
      ...(areas && { areas }),
    }
  }

  /**
   * Restores a state, or opens a link. Without circles, a state changes only the parts that it names.
   *
   * @throws CircleVoronoiError if the state cannot be shown, or if its view, a layer or its step is wrong. The figure
   * then stays unchanged
   */
  async setState(state: LinkInput | string): Promise<void> {
    const said = typeof state === 'string' ? await linkState(state.replace(/^.*#/, '')) : checkedState(state)
    const figure = await this.#started()
    if (said.circles === undefined && said.dataSet === undefined && figure.editing.scene !== undefined) {
      await this.#byProgram(() => figure.change(said))
      return
    }
    const next = requestOfState(said)
    const opening = { ...next, layers: next.layers ?? {}, step: next.step ?? this.#firstStep }
    await this.#byProgram(() => figure.open(opening))
    this.#request = next
  }

  /** Plays the method from the visible step, or from the beginning. The promise resolves when playback has begun. */
  async play(): Promise<void> {
    const figure = await this.#started()
    figure.stepping.play()
    await figure.stepping.whenReady()
  }

  /** Pauses playback at the visible step. */
  pause(): void {
    this.#figure?.stepping.pause()
  }

  /** Shows a step of the method, or the nearest existing one. The promise resolves when the step is visible. */
  async stepTo(step: number): Promise<void> {
    PROPERTIES.step.parse(String(step))
    const figure = await this.#started()
    figure.stepping.pause()
    showStep(figure.store, step)
    await figure.stepping.whenReady()
  }

  /** Returns the visible picture, without the selection, as the text of an SVG. */
  async toSVG(): Promise<string> {
    return toSVG(await this.#shownView())
  }

  /** Returns the visible picture, without the selection, as a PNG with `scale` pixels for each CSS pixel. */
  async toPNG(scale?: number): Promise<Blob> {
    return toPNG(await this.#shownView(), scale)
  }

  get #isReadonly(): boolean {
    return this.#value('readonly') || this.#isDisabled
  }

  get #isOfChildren(): boolean {
    return this.#request === undefined && !this.hasAttribute('circles') && !this.hasAttribute('src')
  }

  async #started(): Promise<Figure> {
    if (this.isConnected) this.#start()
    await this.#update
    if (this.#figure === undefined) refuse((words) => words.notInPage)
    return this.#figure
  }

  /** Resolves to the view once the requested step is visible. */
  async #shownView(): Promise<View> {
    const { stepping, view } = await this.#started()
    await stepping.whenReady()
    return view
  }

  async #settled(): Promise<void> {
    await this.#update
    await this.#telling
    await this.#figure?.stepping.whenReady()
    // Without circles, nothing may ever be painted.
    if (this.#figure?.editing.scene !== undefined) await this.#figure.whenPainted()
  }

  #start(): void {
    if (this.#figure !== undefined) return
    const { figure, picture, print, controls, player, said } = this.#shell
    const places = { figure, around: picture, player, said }
    this.#figure = new Figure(places, {
      load: (this.constructor as typeof CircleVoronoiElement).load,
      scrolls: true,
      actions: (parts) => figureActions(parts, () => paddingBelow(controls)),
      onoutcome: ({ edited, isOpened }) => {
        this.#shell.isRunning = true
        if (isOpened) this.#checkCircles()
        this.#describe()
        this.#tellForm()
        this.#tell('circleschange', this.#detail())
        if (this.#programs === 0) this.#tellInput()
        this.#tell('diagramchange', { ...edited.counts, seconds: edited.seconds })
      },
      onproblem: (error) => this.#tell('error', { error }),
      played: (kept = 'touching-disc') => {
        const { samples } = this
        const method = this.#given('method') ?? (kept as Method)
        return { method, ...(samples !== undefined && { samples }) }
      },
      onstep: (step, steps) => this.#tell('stepchange', { step, steps }),
      words: () => this.#words.others,
    })
    const { store, editing, view } = this.#figure
    this.#printed = new PrintDrawing(print, async () =>
      view.size.width === 0 || editing.circles.count > MOST_DRAWN ? '' : toSVG(view),
    )
    for (const name of ['camera', 'layers', 'diagram', 'style', 'found', 'changed'] as const) {
      view.on(name, () => this.#printed?.change())
    }
    store.subscribe(({ selection }) => {
      this.#showProblems()
      const isSame = selection === this.#lastSelection || selection.length + this.#lastSelection.length === 0
      this.#lastSelection = selection
      if (!isSame) this.#tell('selectionchange', { selection: selection.slice() })
    })
    view.setLayers(this.#value('layers'))
    this.#applyControls()
    this.#show()
    this.#reload()
  }

  /** Runs a change that is not made by a reader. */
  async #byProgram(act: () => Promise<unknown>): Promise<void> {
    this.#programs += 1
    try {
      await act()
    } finally {
      this.#programs -= 1
    }
  }

  #tellInput(): void {
    this.#isHeld = true
    this.dispatchEvent(new Event('input', { bubbles: true, composed: true }))
    // The edit being reported counts as unfinished.
    this.#tellReleased(1)
  }

  /** Reports the release once at most `unfinished` edits are running. */
  #tellReleased(unfinished: number): void {
    const figure = this.#figure
    if (!this.#isHeld || figure === undefined || figure.isPressed || figure.editing.unfinished > unfinished) return
    this.#isHeld = false
    this.dispatchEvent(new Event('change', { bubbles: true }))
  }

  #stop(): void {
    const figure = this.#figure
    if (figure === undefined) return
    this.#printed?.dispose()
    this.#printed = undefined
    if (figure.editing.scene !== undefined) {
      const { view, layers = {}, step, method } = figure.actions.opening.linkState() ?? {}
      const { region = null, lattice = null } = figure.editing.domain
      const { circles, areas, colors, attributes, past } = figure.editing
      const rest = { view, layers, step, method, region, lattice, areas, colors }
      const request = { ...requestOf({ circles: circles.circles(), ...rest }), kept: circles.keptIds, attributes }
      this.#request = request
      this.#past = { request, past }
    }
    this.#loading?.abort()
    this.#rings?.dispose()
    this.#rings = undefined
    figure.dispose()
    this.#figure = undefined
    this.#shell.isRunning = false
  }

  #show(): void {
    if (this.#figure === undefined) return
    // Many circles are printed as existing pixels.
    const isShown = this.#isShown || this.#figure.editing.circles.count > MOST_DRAWN
    this.#figure.view.isShown = isShown
    this.#shell.isShown = isShown
  }

  /** Opens the data of attributes, properties and children. */
  #reload(): void {
    this.#loading?.abort()
    const loading = new AbortController()
    this.#loading = loading
    const figure = this.#figure as Figure
    this.#isOpening = true
    this.#update = this.#byProgram(() => this.#open(figure, loading.signal)).then(() => {
      // A newer opening has replaced this one.
      if (loading.signal.aborted) return
      this.#isOpening = false
      this.#select()
      this.#ready.settle()
    })
  }

  async #open(figure: Figure, signal: AbortSignal): Promise<void> {
    this.#clearError('circles')
    try {
      await this.#speaking
      const given = await this.#opened(signal)
      if (signal.aborted) return
      // Without data, the figure becomes empty.
      const opened = given ?? (figure.editing.scene && requestOf({}))
      if (opened === undefined) return
      const view = opened.view ?? this.view
      const layers = opened.layers ?? keptLayers(this.#value('layers'))
      const step = opened.step ?? this.#value('step') ?? this.#firstStep
      const domain = opened.domain ?? (await this.#domain(signal))
      if (signal.aborted) return
      await this.#openIn(figure, domain, { ...opened, view, layers, step })
      if (this.#past?.request === opened) figure.takeUp(this.#past.past)
      this.#past = undefined
      figure.view.setLayers({ data: this.#value('layers').data })
    } catch (error) {
      if (signal.aborted) return
      if (figure.editing.scene === undefined) this.#shell.fail()
      // A refusal has been reported already.
      if (!figure.isReported(error as Error)) this.#fail('circles', error as Error)
    }
  }

  /** Opens circles in a domain, leaving out the parts of the domain that are refused. */
  async #openIn(figure: Figure, { region, lattice, areas }: Domain, opened: OpenRequest): Promise<void> {
    const attempts = [
      ...(lattice === undefined ? [] : [{ name: 'lattice', domain: { region, lattice, areas } }]),
      ...(areas === undefined ? [] : [{ name: 'areas', domain: { region, areas } }]),
      ...(region === undefined ? [] : [{ name: 'region', domain: { region, areas: undefined } }]),
      { name: undefined, domain: NO_DOMAIN },
    ]
    for (const { name, domain } of attempts) {
      try {
        await figure.open({ ...opened, domain })
        return
      } catch (error) {
        if (name === undefined || !figure.isReported(error as Error)) throw error
        // If the opening succeeds without the areas, they caused the error.
        this.#errors.delete('areas')
        this.#errors.set(name, error as Error)
      }
    }
  }

  /** The domain of attributes and properties, with a region from the address of a file. */
  async #domain(signal: AbortSignal): Promise<Domain> {
    const domain = this.#givenDomain
    const given = this.#value('region')
    let { region } = domain
    try {
      if (typeof given === 'string') region = await regionAt(new URL(given, this.baseURI).href, signal)
      if (region !== undefined && this.dissolve) region = plainRegion(region, true)
    } catch (error) {
      // A file that cannot be loaded is reported once.
      if (!signal.aborted && !this.#errors.has('region')) this.#fail('region', error as Error)
    }
    return { ...domain, region }
  }

  /** The domain of attributes and properties, without a region from the address of a file. */
  get #givenDomain(): Domain {
    const region = this.#value('region')
    return {
      region: typeof region === 'string' ? undefined : region,
      lattice: this.#value('lattice'),
      areas: this.#value('areas'),
    }
  }

  /** The domain of the circles that are visible, or will be. Areas are in the order of the circles. */
  get #currentDomain(): Domain {
    const editing = this.#figure?.editing
    if (editing?.scene !== undefined) return { ...editing.domain, areas: editing.areas }
    return this.#request?.domain ?? this.#givenDomain
  }

  /** Applies region and areas from attributes and properties. Simultaneous changes are applied together. */
  #changeDomain(): void {
    if (this.#request !== undefined) this.#request = { ...this.#request, domain: undefined }
    const figure = this.#figure
    if (figure === undefined || this.#isChanging) return
    this.#isChanging = true
    const { signal } = this.#loading as AbortController
    this.#update = this.#update.then(async () => {
      this.#isChanging = false
      if (figure !== this.#figure || figure.editing.scene === undefined) return
      const domain = await this.#domain(signal)
      // A newer opening reads both again.
      if (!signal.aborted) await this.#byProgram(() => figure.setDomain(domain)).catch(() => {})
    })
  }

  /** Returns the circles of properties, attributes or children; `undefined` if there are none. */
  async #opened(signal: AbortSignal): Promise<OpenRequest | undefined> {
    if (this.#request !== undefined) return this.#request
    const read = this.#value('circles')
    if (read !== undefined) return read()
    if (this.src !== '') return requestAt(new URL(this.src, this.baseURI).href, signal)
    // While the page is loading, the children of the element may be incomplete.
    if (document.readyState === 'loading') {
      await new Promise((resolve) => addEventListener('DOMContentLoaded', resolve, { signal, once: true }))
    }
    const circles = circlesWithin(this)
    return circles && requestOfText(circles)
  }

  /** The first step to show, if the method is to be played. */
  get #firstStep(): number | undefined {
    return this.#value('controls').hasPlayer ? 0 : undefined
  }

  #play(step: number | undefined): void {
    const figure = this.#figure
    if (figure?.editing.scene !== undefined) showStep(figure.store, step ?? this.#firstStep)
  }

  #applyControls(): void {
    const { controls, player } = this.#shell
    const { hasButtons, hasPlayer } = this.#value('controls')
    player.hidden = !hasPlayer
    this.#describe()
    const figure = this.#figure
    if (figure === undefined) return
    const actions: FigureActions = figure.actions
    actions.circles.isReadonly = this.#isReadonly
    actions.messages.words = this.#words.editing
    if (this.#isReadonly) actions.tools.useTool('select')
    if (!hasButtons) controls.replaceChildren()
    else mountControls(this.#shell, figure, this.#words, this.#isReadonly)
  }

  /** Reports a check that names missing circles. */
  #checkCircles(): void {
    const check = this.#value('check')
    const editing = this.#figure?.editing
    this.#try('circles of check', () => {
      if (check !== undefined && editing?.scene !== undefined) checkCircles(check, editing.circles.size)
    })
  }

  #setCircles(circles: Circles | undefined | null): void {
    this.#cached = undefined
    this.#setRequest(isSet(circles) ? requestOfText(circlesOfValue(circles)) : undefined)
  }

  /** Opens data in place of the data of attributes and children. `undefined` opens these. */
  #setRequest(request: OpenRequest | undefined): void {
    this.#request = request
    if (this.#figure !== undefined) this.#reload()
  }

  #tellForm(): void {
    this.#telling = this.#tellFormNow()
  }

  /** Updates the form's value and validity. */
  async #tellFormNow(): Promise<void> {
    const figure = this.#figure
    const check = this.#value('check')
    const facts = check && (await figure?.view.scene.ask('tell', [idsOf(check)]))
    // The figure or the check may have been replaced in the meantime.
    if (figure !== this.#figure || check !== this.#value('check')) return
    const isMet = check && facts !== undefined && holds(check, facts)
    this.#goals = check === undefined || facts === undefined ? [] : goalsOf(check, facts)
    const isOther = isMet !== this.#isMet
    if (isOther) {
      this.#isMet = isMet
      if (isMet === true) this.#internals.states?.add('met')
      else this.#internals.states?.delete('met')
    }
    const areOtherGoals = this.#showGoals()
    if (isOther || areOtherGoals) this.#describe()
    if (areOtherGoals) this.#tellGoals()
    if (isMet === false) this.#internals.setValidity({ customError: true }, this.#words.unmet, this.#shell.figure)
    else this.#internals.setValidity({})
    if (isOther) this.#tell('checkchange', { isMet: isMet === true })
    if (this.#internals.form === null || figure === undefined) return
    const circles = listOf(figure.editing.circles.circles())
    this.#internals.setFormValue(JSON.stringify(isMet === undefined ? { circles } : { circles, check: isMet }))
  }

  /** Shows the goals. Returns whether their text has changed. */
  #showGoals(): boolean {
    const { goals: words } = this.#words
    const check = this.#value('check')
    const figure = this.#figure
    if (check !== undefined && figure !== undefined) this.#rings ??= new Rings(this.#shell.frame, figure.view)
    this.#rings?.show(check === undefined ? [] : goalRings(check, this.#goals, this.#isMet === true, words))
    const before = this.#goalText
    this.#goalText = goalSentence(this.#goals, words)
    return this.#goalText !== before
  }

  #tellGoals(): void {
    this.#tell('goalschange', { goals: this.#goals, text: this.#goalText })
  }

  #describe(): void {
    const words = this.#words
    const goals = this.#goalText === '' ? '' : ` ${this.#goalText}.`
    const said = this.#isMet === undefined ? '' : this.#isMet ? ` ${words.met}` : ` ${words.unmet}${goals}`
    const counts = this.#figure?.store.get().edited?.counts
    const about = counts === undefined ? '' : words.describe(counts) + said
    this.#shell.describe(words, this.alt, about, this.#isReadonly)
  }

  get #words(): Words {
    return wordsOf(this.#language)
  }

  /** Shows all texts in the element's language, now and once it is loaded. */
  #speak(): void {
    const show = () => {
      const areOtherGoals = this.#showGoals()
      this.#applyControls()
      this.#showProblems()
      if (areOtherGoals) this.#tellGoals()
      this.#figure?.stepping.redraw()
    }
    show()
    this.#speaking = loadWords(this.#language)?.then(show)
  }

  /** The language of the page, if it is known. */
  get #language(): string {
    let element: Element | undefined = this
    while (element !== undefined) {
      const known: Element | null = element.closest('[lang]')
      if (known !== null) return known.getAttribute('lang') as string
      const root = element.getRootNode()
      element = root instanceof ShadowRoot ? root.host : undefined
    }
    return ''
  }

  /** Returns the detail of an event, with a copy of the circles. */
  #detail(): CircleVoronoiEventMap['circleschange']['detail'] {
    const element = this
    this.#changes += 1
    const turn = this.#changes
    this.#newest = undefined
    let circles: Float64s | undefined
    return {
      get circles() {
        circles ??= element.circles
        if (turn === element.#changes) element.#newest = circles
        return circles
      },
      get ids() {
        return element.ids
      },
    }
  }

  /** Reports an error, and shows it until the property gets a valid value. */
  #try(name: string, act: () => void): void {
    try {
      act()
      this.#clearError(name)
    } catch (error) {
      this.#fail(name, error as Error)
    }
  }

  #clearError(name: string): void {
    if (this.#errors.delete(name)) this.#showProblems()
  }

  #fail(name: string, error: Error): void {
    this.#errors.set(name, error)
    this.#showProblems()
    this.#tell('error', { error })
  }

  #showProblems(): void {
    const refusals = this.#words.others?.refusals
    const wrong = Array.from(this.#errors.values(), (error) => problemOf(error, false, refusals))
    const problem = this.#figure?.store.get().problem ?? ''
    this.#shell.problem = [...wrong, problem].filter((text) => text !== '').join(' ')
  }

  #tell<Name extends keyof CircleVoronoiEventMap>(
    name: Name,
    detail: CircleVoronoiEventMap[Name] extends CustomEvent<infer Detail> ? Detail : never,
  ): void {
    this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true, composed: true }))
  }

  /** Moves a property that was set before the class was defined. */
  #upgrade(name: (typeof NAMES)[number]): void {
    if (!Object.hasOwn(this, name)) return
    const value = this[name]
    delete (this as Partial<Record<typeof name, unknown>>)[name]
    Object.assign(this, { [name]: value })
  }
}

/** Whether a property is set. Frameworks unset a property with `undefined` or `null`. */
function isSet<Value>(value: Value | undefined | null): value is Value {
  return value !== undefined && value !== null
}

/** A promise with external resolve and reject. */
class Deferred {
  settle: () => void = () => {}
  readonly promise = new Promise<void>((resolve) => {
    this.settle = resolve
  })
}

function listOf(circles: Float64s): number[][] {
  return Array.from({ length: circles.length / 3 }, (_, i) => [...circles.subarray(3 * i, 3 * i + 3)])
}

/** The properties that the class defines from the table. */
export interface CircleVoronoiElement {
  /** The name of the figure for screen readers. */
  get alt(): string
  set alt(alt: CircleVoronoiProps['alt'])
  /**
   * The areas of the cells inside the region: `equal`, or a list of numbers above 0 in the order of the circles, which
   * are scaled to the area of the region. In the attribute, numbers are separated by spaces. The figure chooses the
   * radii of the circles as weights that give each cell its area, and shows the circles as points. The cells keep their
   * areas while points are moved; an added circle gets the mean of the others. `undefined` if circles keep their radii.
   */
  get areas(): Areas | undefined
  set areas(areas: CircleVoronoiProps['areas'])
  /** The condition that the circles must meet before the form can be submitted, for example `{ cell: 3, edges: 3 }`. */
  get check(): Check | undefined
  set check(check: CircleVoronoiProps['check'])
  /**
   * The controls: `player` is the player below the figure, `buttons player` adds buttons, and any other text shows
   * buttons. `null` for no controls.
   */
  get controls(): string | null
  set controls(controls: CircleVoronoiProps['controls'])
  /** Whether polygons of the region that share borders or overlap, as administrative areas do, are merged. */
  get dissolve(): boolean
  set dissolve(isDissolved: CircleVoronoiProps['dissolve'])
  /** The language of the element: German (`de`) or English (anything else). Default: the language of the page. */
  get lang(): string
  set lang(lang: string | undefined | null)
  /**
   * The two periods with which the circles repeat: the sides of a box whose opposite sides are glued together, as `{ a:
   * [ax, ay], b: [bx, by] }`. The attribute has the four numbers, separated by spaces. The figure shows the box with a
   * corner at the origin, and dimmed images around it. A circle that is dragged out of the box comes in on the other
   * side. A lattice takes no region. Periods that are parallel cause an `error` event. `undefined` if circles do not
   * repeat.
   */
  get lattice(): Lattice | undefined
  set lattice(lattice: CircleVoronoiProps['lattice'])
  /**
   * The layers that the figure draws. The attribute has words, such as `hull`, `no-edges`, `cells=degree` and
   * `max-distance=2`, or an object in JSON. Layers that you do not name have their defaults. `undefined` restores the
   * layers of the attribute.
   */
  get layers(): Layers
  set layers(layers: CircleVoronoiProps['layers'])
  /** The method of `compute()` (default: `auto`) and of the player (default: `touching-disc`). */
  get method(): Method
  set method(method: CircleVoronoiProps['method'])
  /** The name of the field in a form. Its value is JSON: `{ "circles": [[x, y, r], ...], "check": true }`. */
  get name(): string
  set name(name: CircleVoronoiProps['name'])
  /** Whether readers cannot edit the circles. */
  get readonly(): boolean
  set readonly(isReadonly: CircleVoronoiProps['readonly'])
  /**
   * The region to which cells are clipped: polygons with holes. Set GeoJSON (`Polygon`, `MultiPolygon`, `Feature`,
   * `FeatureCollection`), a list of rings of points, or text like the attribute: GeoJSON, rings in JSON, well-known
   * text (`POLYGON ((0 0, 9 0, 9 9, 0 9))`) or the address of such a file. `undefined` if there is none. Areas of cells
   * are measured inside the region. A region whose rings cross causes an `error` event, unless `dissolve` is set.
   */
  get region(): RegionShape | undefined
  set region(region: CircleVoronoiProps['region'])
  /** The number of samples of the touching disc method, as in the options of the library. */
  get samples(): number | undefined
  set samples(samples: number | undefined | null)
  /** The address of a file of circles (CSV, JSON or GeoJSON), or a link to the playground. */
  get src(): string
  set src(src: CircleVoronoiProps['src'])
  /**
   * The visible part of the plane: `x` and `y` of its center, and `span`, the number of units that are visible at least
   * in both directions. The attribute has these three numbers. `undefined` shows all circles.
   */
  get view(): LinkView | undefined
  set view(view: CircleVoronoiProps['view'])
  /** Adds a listener for an event of this element. */
  addEventListener<Name extends keyof CircleVoronoiEventMap>(
    name: Name,
    listener: (this: CircleVoronoiElement, event: CircleVoronoiEventMap[Name]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void
  /** Adds a listener for an event that all elements have. */
  addEventListener<Name extends keyof HTMLElementEventMap>(
    name: Name,
    listener: (this: CircleVoronoiElement, event: HTMLElementEventMap[Name]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void
  /** Adds a listener for an event of any name. */
  addEventListener(
    name: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void
}

declare global {
  interface HTMLElementTagNameMap {
    'circle-voronoi': CircleVoronoiElement
  }
}
