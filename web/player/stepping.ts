// SPDX-License-Identifier: GPL-3.0-or-later
import { type State, showStep } from '../editing/state.ts'
import type { TraceOptions } from '../lib/wasm/trace.ts'
import type { Store } from '../view/store.ts'
import type { View } from '../view/view.ts'
import type { Player } from './player.ts'
import type { PlayerWords } from './words.ts'

export interface SteppingOptions {
  /** The element that shows the player. */
  readonly container: HTMLElement
  readonly view: View
  readonly store: Store<State>
  /** Returns the options of the trace when playback begins. `method` is the method of the state. */
  options(method: string | undefined): TraceOptions
  /** Called with each step shown and the number of steps. */
  readonly onstep?: ((step: number, steps: number) => void) | undefined
  /** Returns the player's texts, at each redraw. Default: English. */
  readonly words?: (() => PlayerWords | undefined) | undefined
  /** Called with the reason if there is nothing to play. */
  readonly onproblem?: ((error: Error) => void) | undefined
}

/** Mounts the player while the state has a step, and loads its code only then. The state alone has the step. */
export class Stepping {
  readonly #options: SteppingOptions
  #isDisposed = false
  #player: Player | undefined
  #loading: Promise<void> | undefined
  /** Identifies the current player, so that a player that loads too late is dropped. */
  #turn = 0
  /** Whether a player is mounted or loading. */
  #isOpen = false
  #method: string | undefined
  #isPlaying = false

  constructor(options: SteppingOptions) {
    this.#options = options
    options.store.subscribe(() => this.#followState())
  }

  get steps(): number {
    return this.#player?.steps ?? 0
  }

  /** Resolves once the state's step is shown or has turned out to be impossible. */
  async whenReady(): Promise<void> {
    this.#followState()
    await this.#loading
    for (let ready = this.#player?.ready; ready !== undefined; ) {
      await ready.catch(() => {})
      ready = ready === this.#player?.ready ? undefined : this.#player?.ready
    }
  }

  /** Starts playback at the current step, or at the beginning. */
  play(): void {
    this.#isPlaying = true
    const { store } = this.#options
    if (store.get().step === undefined) showStep(store, 0)
    this.#player?.play()
  }

  pause(): void {
    this.#isPlaying = false
    this.#player?.pause()
  }

  /** Restarts playback, if there is any, with the current options. */
  restart(): void {
    if (!this.#isOpen || this.#options.store.get().step === undefined) return
    this.#end()
    showStep(this.#options.store, 0)
    this.#followState()
  }

  /** Redraws the player with other texts. */
  redraw(): void {
    this.#player?.redraw()
  }

  dispose(): void {
    this.#isDisposed = true
    this.#end()
  }

  #followState(): void {
    const { step, method, edited } = this.#options.store.get()
    // Without circles there is nothing to play.
    if (edited === undefined || this.#isDisposed) return
    if (this.#isOpen && (step === undefined || method !== this.#method)) this.#end()
    this.#method = method
    if (step === undefined) return
    if (this.#isOpen) this.#player?.follow()
    else this.#loading = this.#load()
  }

  #end(): void {
    this.#turn += 1
    this.#isOpen = false
    this.#isPlaying = false
    this.#player?.dispose()
    this.#player = undefined
  }

  async #load(): Promise<void> {
    this.#isOpen = true
    this.#turn += 1
    const turn = this.#turn
    const { container, view, store, options, onstep = () => {}, words, onproblem = () => {} } = this.#options
    try {
      const { mountPlayer } = await import('./player.ts')
      // The state may have dropped the step while the player loaded.
      if (turn !== this.#turn) return
      const player = mountPlayer(container, {
        view,
        options: options(this.#method),
        place: () => store.get(),
        go: (step, stage) => showStep(store, step, undefined, stage),
        words,
        onstep,
      })
      this.#player = player
      if (this.#isPlaying) player.play()
      await player.ready
    } catch (error) {
      if (turn === this.#turn) onproblem(error as Error)
    }
  }
}
