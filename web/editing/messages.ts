// SPDX-License-Identifier: GPL-3.0-or-later
import type { FigureParts } from './figure-actions.ts'
import { nameIn } from './identity.ts'
import type { Remedy } from './state.ts'
import { ENGLISH_EDITING } from './words.ts'

/** The sentences that a user sees or hears. */
export class Messages {
  readonly #figure: FigureParts
  /** The texts for screen readers. */
  words = ENGLISH_EDITING
  /** A circle within a sentence: its name, or its number. */
  readonly called = (id: number): string => this.words.called(id, nameIn(this.#figure.editing.attributes, id))

  constructor(figure: FigureParts) {
    this.#figure = figure
  }

  /** Announces a text to screen readers. */
  say(text: string): void {
    this.#figure.store.update((state) => ({ ...state, said: { text } }))
  }

  /** Shows a problem in one sentence. An empty text clears it. */
  complain(problem: string): void {
    this.#figure.store.update((state) => ({ ...state, problem }))
  }

  /** Offers a remedy for the current problem. */
  offer(remedy: Remedy): void {
    this.#figure.store.update((state) => ({ ...state, remedy }))
  }
}
