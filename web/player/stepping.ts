// SPDX-License-Identifier: GPL-3.0-or-later
import type { EditorActions } from '../editing/editor-actions.ts'
import type { State } from '../editing/state.ts'
import type { Store } from '../editing/store.ts'
import type { TraceOptions } from '../lib/wasm/trace.ts'
import type { View } from '../view/view.ts'
import type { Player } from './player.ts'
import type { PlayerWords } from './words.ts'

export interface SteppingOptions {
  /** The element that shows the player. */
  readonly container: HTMLElement
  readonly view: View
  readonly store: Store<State>
  readonly actions: EditorActions
  /** Returns the trace options whenever playback begins. `method` is the state's. */
  options(method: string | undefined): TraceOptions
  /** Called with each step shown and the number of steps. */
  readonly onstep?: ((step: number, steps: number) => void) | undefined
  /** Returns the player's texts, at each redraw. Default: English. */
  readonly words?: (() => PlayerWords | undefined) | undefined
  /** Called with the reason if there is nothing to play. */
  readonly onproblem?: ((error: Error) => void) | undefined
}

/** Loads the player when the state names a step, and removes it when the state names none. */
export class Stepping {
  readonly #options: SteppingOptions
  #isDisposed = false
  #player: Player | undefined
  #loading: Promise<void> | undefined
  /** Identifies the current player, so that a player that loads too late is dropped. */
  #turn = 0
  /** The last step on which player and state agreed. */
  #known: number | undefined
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
    if (this.#known === undefined) this.#options.actions.showStep(0)
    this.#player?.play()
  }

  pause(): void {
    this.#isPlaying = false
    this.#player?.pause()
  }

  /** Restarts from the beginning if a trace is playing, because the options may have changed. */
  restart(): void {
    if (this.#known === undefined) return
    this.#follow(undefined)
    this.#options.actions.showStep(0)
    this.#follow(0)
  }

  /** Redraws the player with other texts. */
  redraw(): void {
    this.#player?.redraw()
  }

  dispose(): void {
    this.#isDisposed = true
    this.#follow(undefined)
  }

  #followState(): void {
    const { step, method, edited } = this.#options.store.get()
    // Without circles there is nothing to play.
    if (edited === undefined || this.#isDisposed) return
    if (method !== this.#method) this.#follow(undefined)
    this.#method = method
    this.#follow(step)
  }

  #follow(step: number | undefined): void {
    if (step === this.#known) return
    const isNew = this.#known === undefined
    this.#known = step
    if (step === undefined) this.#end()
    else if (isNew) this.#loading = this.#load()
    else this.#player?.stepTo(step)
  }

  #end(): void {
    this.#turn += 1
    this.#isPlaying = false
    this.#player?.dispose()
    this.#player = undefined
  }

  async #load(): Promise<void> {
    this.#turn += 1
    const turn = this.#turn
    const { container, view, actions, options, onstep, words, onproblem = () => {} } = this.#options
    try {
      const { mountPlayer } = await import('./player.ts')
      // The state may have dropped the step while the player loaded.
      if (turn !== this.#turn) return
      const player = mountPlayer(container, {
        view,
        options: options(this.#method),
        step: this.#known,
        words,
        onstep: (step, steps) => {
          // The state may name another step by now, or none.
          const wanted = this.#options.store.get().step
          if (wanted !== this.#known && wanted !== step) return this.#followState()
          this.#known = step
          actions.showStep(step)
          onstep?.(step, steps)
        },
      })
      this.#player = player
      if (this.#isPlaying) player.play()
      await player.ready
    } catch (error) {
      if (turn === this.#turn) onproblem(error as Error)
    }
  }
}
