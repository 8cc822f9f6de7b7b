// SPDX-License-Identifier: GPL-3.0-or-later
import { Editing, type Outcome, type Past } from '../editing/editing.ts'
import type { FigureActions, FigureParts } from '../editing/figure-actions.ts'
import { namesOf, ownColorsOf } from '../editing/identity.ts'
import { type KeyActions, listenToKeyboard } from '../editing/keyboard.ts'
import { mountLiveRegion } from '../editing/live-region.ts'
import type { OpenRequest } from '../editing/open-request.ts'
import { type Listening, listenToPointer } from '../editing/pointer.ts'
import { type ProblemWords, problemOf } from '../editing/problem.ts'
import { initialState, type State, showStep } from '../editing/state.ts'
import type { LinkState } from '../lib/link.ts'
import type { TraceOptions } from '../lib/wasm/trace.ts'
import type { Domain } from '../view/domain.ts'
import { layersFrom } from '../view/layers.ts'
import type { FigureLoadOptions } from '../view/load.ts'
import { mount } from '../view/mount.ts'
import { nextFrame } from '../view/next-frame.ts'
import { createStore, type Store } from '../view/store.ts'
import type { View } from '../view/view.ts'
import { Stepping } from './stepping.ts'
import type { PlayerWords } from './words.ts'

/** The elements that a figure consists of. */
export interface FigureElements {
  /** Shows the circles, takes the focus and receives keys. */
  readonly figure: HTMLElement
  /** Receives keyboard shortcuts that work wherever the focus is: the figure with its buttons, or the page. */
  readonly around: Document | HTMLElement
  /** Shows the player's controls and explanations during playback. */
  readonly player: HTMLElement
  /** The live region for screen readers. */
  readonly said: HTMLElement
}

/** The services that a figure needs from its surroundings, and how it behaves inside a page. */
export interface FigureOptions<Actions extends FigureActions> {
  readonly load?: FigureLoadOptions
  /** Whether the wheel and a finger scroll the page instead of moving the figure's viewport. */
  readonly scrolls?: boolean
  /** Additional keyboard shortcuts. */
  readonly keys?: KeyActions
  /** Returns the edits and camera moves that users can trigger. */
  actions(parts: FigureParts): Actions
  onoutcome(outcome: Outcome): void
  /** Called when an edit is refused or an operation fails. */
  onproblem?(error: Error): void
  /** Returns the options of the trace to play. `method` comes from a link. */
  played(method: string | undefined): TraceOptions
  onstep?(step: number, steps: number): void
  /** Returns translated texts, if the figure is not in English. */
  words?(): { readonly refusals: ProblemWords; readonly player: PlayerWords } | undefined
}

/** A view of circles that can be edited by pointer and keyboard, and whose method can be played. */
export class Figure<Actions extends FigureActions = FigureActions> implements FigureParts {
  readonly view: View
  readonly store: Store<State>
  readonly editing: Editing
  readonly actions: Actions
  readonly stepping: Stepping
  readonly #listening: Listening
  readonly #figure: HTMLElement
  readonly #keys = new AbortController()
  #refused: Error | undefined
  /** The most recent opening. */
  #opening: Promise<unknown> | undefined

  constructor({ figure, around, player, said }: FigureElements, options: FigureOptions<Actions>) {
    const { load, scrolls = false, keys = {}, onoutcome, onproblem, played, onstep, words } = options
    const store = createStore(initialState())
    const view = mount(figure, store, load)
    const confirmed = (outcome: Outcome) => {
      if (outcome.hasNewAttributes) view.setIdentities(namesOf(editing), ownColorsOf(editing))
      onoutcome(outcome)
    }
    const failed = (error: Error) => {
      // A disposed figure reports no errors.
      if (this.#keys.signal.aborted) return
      const problem = problemOf(error, editing.scene !== undefined, words?.()?.refusals)
      store.update((state) => ({ ...state, problem }))
      this.#refused = error
      onproblem?.(error)
    }
    const editing = new Editing(store, view.scene, confirmed, failed)
    view.on('failed', failed)
    this.#figure = figure
    this.view = view
    this.store = store
    this.editing = editing
    const actions = options.actions(this)
    this.actions = actions
    this.stepping = new Stepping({
      container: player,
      view,
      store,
      options: played,
      onstep,
      words: () => words?.()?.player,
      onproblem,
    })

    mountLiveRegion(store, said, actions.messages)
    this.#listening = listenToPointer(figure, { view, editing, actions }, { letsPageScroll: scrolls })
    const { signal } = this.#keys
    listenToKeyboard(figure, view, store, actions, keys, { around, signal })
  }

  /**
   * Opens other circles together with their viewport and style.
   * @throws Error that says why they could not be opened; the figure stays unchanged
   */
  async open(opened: OpenRequest): Promise<void> {
    this.#refused = undefined
    const opening = this.actions.opening.open(async () => opened)
    this.#opening = opening
    const how = await opening
    if (how === 'refused' && this.#refused !== undefined) throw this.#refused
  }

  /**
   * Changes only the given parts of the state, also while circles are being opened.
   * @throws Error that says why edits were refused; the figure stays unchanged
   */
  async change({
    edits = [],
    view,
    layers,
    step,
    method,
    region,
    lattice,
    areas,
  }: Omit<LinkState, 'circles'>): Promise<void> {
    await this.#opening
    this.#refused = undefined
    if (edits.length > 0 && (await this.editing.edit(edits)) === undefined && this.#refused !== undefined) {
      throw this.#refused
    }
    if (region !== undefined || lattice !== undefined || areas !== undefined) {
      const before = this.editing.domain
      await this.setDomain({
        region: region === undefined ? before.region : (region ?? undefined),
        lattice: lattice === undefined ? before.lattice : (lattice ?? undefined),
        areas: areas ?? this.editing.areas,
      })
    }
    const { data } = this.view.layers
    if (layers !== undefined) this.view.setLayers({ ...layersFrom(layers), data })
    if (view !== undefined) this.actions.camera.showView(view)
    if (step !== undefined) showStep(this.store, step, method)
  }

  /**
   * Clips cells to another region, or fits them to other areas.
   * @throws Error that says why the domain was refused; the figure stays unchanged
   */
  async setDomain(domain: Domain): Promise<void> {
    this.#refused = undefined
    if ((await this.actions.circles.setDomain(domain)) === undefined && this.#refused !== undefined) throw this.#refused
  }

  /** Whether an error has been reported through `onproblem`. */
  isReported(error: Error): boolean {
    return error === this.#refused
  }

  /** Continues the undo history of another figure that showed the same circles. */
  takeUp(past: Past): void {
    this.editing.takeUp(past)
  }

  /** The step shown during playback. */
  get step(): number | undefined {
    return this.store.get().step
  }

  /** Resolves once everything has been painted. */
  whenPainted(): Promise<void> {
    return new Promise((resolve) => {
      // A hidden tab paints nothing until it is shown.
      const isPainted = () =>
        !this.view.isShown ||
        this.view.size.width === 0 ||
        this.#figure.ariaBusy === 'false' ||
        document.visibilityState === 'hidden'
      const resolveIfPainted = () => {
        if (!isPainted()) return
        observer.disconnect()
        document.removeEventListener('visibilitychange', resolveIfPainted)
        resolve()
      }
      const observer = new MutationObserver(resolveIfPainted)
      // A change that was just made may not have started painting yet.
      nextFrame(() => {
        observer.observe(this.#figure, { attributeFilter: ['aria-busy'] })
        document.addEventListener('visibilitychange', resolveIfPainted)
        resolveIfPainted()
      })
    })
  }

  /** Whether a mouse button or a finger is pressed on the figure. */
  get isPressed(): boolean {
    return this.#listening.isPressed
  }

  dispose(): void {
    this.#listening.stop()
    this.#keys.abort()
    this.stepping.dispose()
    this.view.dispose()
  }
}
