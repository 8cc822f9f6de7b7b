// SPDX-License-Identifier: GPL-3.0-or-later
import type { Store } from '../view/store.ts'
import type { Editing } from './editing.ts'
import { nameIn } from './identity.ts'
import type { Remedy, State } from './state.ts'
import { ENGLISH_EDITING } from './words.ts'

/** The sentences that a user sees or hears. */
export class Messages {
  readonly #store: Store<State>
  readonly #editing: Editing
  /** The texts for screen readers. */
  words = ENGLISH_EDITING
  /** A circle within a sentence: its name, or its number. */
  readonly called = (id: number): string => this.words.called(id, nameIn(this.#editing.attributes, id))

  constructor(store: Store<State>, editing: Editing) {
    this.#store = store
    this.#editing = editing
  }

  /** Announces a text to screen readers. */
  say(text: string): void {
    this.#store.update((state) => ({ ...state, said: { text } }))
  }

  /** Shows a problem in one sentence. An empty text clears it. */
  complain(problem: string): void {
    this.#store.update((state) => ({ ...state, problem }))
  }

  /** Offers a remedy for the current problem. */
  offer(remedy: Remedy): void {
    this.#store.update((state) => ({ ...state, remedy }))
  }
}
