// SPDX-License-Identifier: GPL-3.0-or-later
import type { EditorActions } from '../editing/editor-actions.ts'
import type { State } from '../editing/state.ts'
import type { Store } from '../editing/store.ts'
import type { TraceOptions } from '../lib/wasm/trace.ts'
import type { View } from '../view/view.ts'
import type { Player } from './player.ts'
import type { PlayerWords } from './words.ts'

export interface SteppingOptions {
  /** Where the player is shown. */
  readonly container: HTMLElement
  readonly view: View
  readonly store: Store<State>
  readonly actions: EditorActions
  /** What is played, asked for whenever it begins. `method`: that of the state. */
  options(method: string | undefined): TraceOptions
  /** Called with each step that is shown, and how many there are. */
  readonly onstep?: ((step: number, steps: number) => void) | undefined
  /** What the player says, asked for whenever it is drawn. Default: English. */
  readonly words?: (() => PlayerWords | undefined) | undefined
  /** Called where nothing can be played, with the reason. */
  readonly onproblem?: ((error: Error) => void) | undefined
}

/** Has the player there as long as the state names a step; until then, nothing of it is loaded. */
export class Stepping {
  readonly #options: SteppingOptions
  #isDisposed = false
  #player: Player | undefined
  #loading: Promise<void> | undefined
  /** Which player is loaded: others are no longer wanted. */
  #turn = 0
  /** The step that the player and the state agree on. */
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

  /** Settled once what the state names is shown, or it is known that it cannot be. */
  async whenReady(): Promise<void> {
    this.#followState()
    await this.#loading
    for (let ready = this.#player?.ready; ready !== undefined; ) {
      await ready.catch(() => {})
      ready = ready === this.#player?.ready ? undefined : this.#player?.ready
    }
  }

  /** From the step that is shown on, or from the beginning. */
  play(): void {
    this.#isPlaying = true
    if (this.#known === undefined) this.#options.actions.showStep(0)
    this.#player?.play()
  }

  pause(): void {
    this.#isPlaying = false
    this.#player?.pause()
  }

  /** From the beginning, if anything is played: other options may be given now. */
  restart(): void {
    if (this.#known === undefined) return
    this.#follow(undefined)
    this.#options.actions.showStep(0)
    this.#follow(0)
  }

  /** Has it said in other words. */
  redraw(): void {
    this.#player?.redraw()
  }

  dispose(): void {
    this.#isDisposed = true
    this.#follow(undefined)
  }

  #followState(): void {
    const { step, method, edited } = this.#options.store.get()
    // Before there are circles, there is nothing to be played.
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
      // Meanwhile it may not be wanted any more.
      if (turn !== this.#turn) return
      const player = mountPlayer(container, {
        view,
        options: options(this.#method),
        step: this.#known,
        words,
        onstep: (step, steps) => {
          // The state may already name another step, or none.
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
