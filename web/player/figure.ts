// SPDX-License-Identifier: GPL-3.0-or-later
import { editView } from '../editing/edited-view.ts'
import type { Editing, Outcome, Past } from '../editing/editing.ts'
import type { EditorActions, Opened } from '../editing/editor-actions.ts'
import { type KeyActions, listenToKeyboard } from '../editing/keyboard.ts'
import { type ProblemWords, problemOf } from '../editing/problem.ts'
import { mountSaid } from '../editing/said.ts'
import type { State } from '../editing/state.ts'
import type { Store } from '../editing/store.ts'
import type { Point } from '../lib/index.ts'
import type { LinkState } from '../lib/link.ts'
import type { TraceOptions } from '../lib/wasm/trace.ts'
import type { Domain } from '../view/domain.ts'
import { layersFrom } from '../view/layers.ts'
import type { FigureLoadOptions } from '../view/load.ts'
import { mount } from '../view/mount.ts'
import { nextFrame } from '../view/next-frame.ts'
import { type Listening, listenToPointer } from '../view/pointer.ts'
import type { View } from '../view/view.ts'
import { Stepping } from './stepping.ts'
import type { PlayerWords } from './words.ts'

/** Where a figure is. */
export interface Places {
  /** What shows circles, takes the focus and hears keys. */
  readonly figure: HTMLElement
  /** Where some keys are heard, wherever the focus is in it: the figure and its buttons, or the page. */
  readonly around: Document | HTMLElement
  /** Where the method is told of while it is played. */
  readonly player: HTMLElement
  /** What is read out. */
  readonly said: HTMLElement
}

/** What is told of a figure, and how it gets on with what is around it. */
export interface FigureOptions<Actions extends EditorActions> {
  readonly load?: FigureLoadOptions
  /** Whether the page around it scrolls, by the wheel and by a finger. */
  readonly scrolls?: boolean
  /** What keys do beside. */
  readonly keys?: KeyActions
  /** What a user can do with its circles. */
  actions(store: Store<State>, editing: Editing, view: View): Actions
  onoutcome(outcome: Outcome): void
  /** What was refused, or failed. */
  onproblem?(error: Error): void
  /** What is played. `method`: that of a link. */
  played(method: string | undefined): TraceOptions
  onstep?(step: number, steps: number): void
  /** What it says in another language than English. */
  words?(): { readonly refusals: ProblemWords; readonly player: PlayerWords } | undefined
}

/** A view with circles that are edited by pointer and keys, and whose method can be played. */
export class Figure<Actions extends EditorActions = EditorActions> {
  readonly view: View
  readonly store: Store<State>
  readonly editing: Editing
  readonly actions: Actions
  readonly stepping: Stepping
  readonly #listening: Listening
  readonly #figure: HTMLElement
  readonly #keys = new AbortController()
  #refused: Error | undefined
  /** The opening that was asked last. */
  #opening: Promise<unknown> | undefined

  constructor({ figure, around, player, said }: Places, options: FigureOptions<Actions>) {
    const { load, scrolls = false, keys = {}, onoutcome, onproblem, played, onstep, words } = options
    const view = mount(figure, load)
    const { store, editing } = editView(view, onoutcome, (error) => {
      // What was asked of a figure that goes is not missed.
      if (this.#keys.signal.aborted) return
      const problem = problemOf(error, editing.scene !== undefined, words?.()?.refusals)
      store.update((state) => ({ ...state, problem }))
      this.#refused = error
      onproblem?.(error)
    })
    const actions = options.actions(store, editing, view)
    this.#figure = figure
    this.view = view
    this.store = store
    this.editing = editing
    this.actions = actions
    this.stepping = new Stepping({
      container: player,
      view,
      store,
      actions,
      options: played,
      onstep,
      words: () => words?.()?.player,
      onproblem,
    })

    mountSaid(store, said, () => actions.words)
    const isGrabbed = (point: Point, within: number) => !actions.isReadonly && editing.circles.hasAt(point, within)
    this.#listening = listenToPointer(figure, view, actions, scrolls ? { isGrabbed } : {})
    const { signal } = this.#keys
    listenToKeyboard(figure, view, this.#listening, store, actions, keys, { around, signal })
  }

  /**
   * Other circles, and what is said of how they are looked at.
   *
   * @throws Error that says why they could not be opened; then all stays as it was
   */
  async open(opened: Opened): Promise<void> {
    this.#refused = undefined
    const opening = this.actions.open(async () => opened)
    this.#opening = opening
    const how = await opening
    if (how === 'refused' && this.#refused !== undefined) throw this.#refused
  }

  /**
   * Changes what is said of the circles that there are, or of those that are being opened, and leaves the rest.
   *
   * @throws Error that says why edits were refused; then all stays as it was
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
    if (view !== undefined) this.actions.look(view)
    if (step !== undefined) this.actions.showStep(step, method)
  }

  /**
   * Cuts cells to another region, or gives them other areas.
   *
   * @throws Error that says why that was refused; then all stays as it was
   */
  async setDomain(domain: Domain): Promise<void> {
    this.#refused = undefined
    if ((await this.actions.setDomain(domain)) === undefined && this.#refused !== undefined) throw this.#refused
  }

  /** Whether an error was told of as a problem. */
  isTold(error: Error): boolean {
    return error === this.#refused
  }

  /** Has undo and redo go on with what was done to the circles that were opened last, when another figure showed them. */
  takeUp(past: Past): void {
    const history = this.editing.takeUp(past)
    this.store.update((state) => ({ ...state, history }))
  }

  /** The step of the method that is shown, if it is played. */
  get step(): number | undefined {
    return this.store.get().step
  }

  /** Ends once there is nothing left to be painted. */
  whenPainted(): Promise<void> {
    return new Promise((resolve) => {
      // In a hidden tab nothing is painted until it is shown.
      const isPainted = () =>
        !this.view.isShown ||
        this.view.size.width === 0 ||
        this.#figure.ariaBusy === 'false' ||
        document.visibilityState === 'hidden'
      const look = () => {
        if (!isPainted()) return
        observer.disconnect()
        document.removeEventListener('visibilitychange', look)
        resolve()
      }
      const observer = new MutationObserver(look)
      // What was set may not have begun.
      nextFrame(() => {
        observer.observe(this.#figure, { attributeFilter: ['aria-busy'] })
        document.addEventListener('visibilitychange', look)
        look()
      })
    })
  }

  /** Whether a button or a finger is down on it. */
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
