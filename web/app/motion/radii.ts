// SPDX-License-Identifier: GPL-3.0-or-later
import type { Editing } from '../../editing/editing.ts'
import type { State } from '../../editing/state.ts'
import type { Edit } from '../../lib/index.ts'
import type { Store } from '../../view/store.ts'

interface Scaling {
  readonly gesture: number
  /** The original radii by circle id. */
  readonly radii: ReadonlyMap<number, number>
  share: number
}

/** Scales all radii by a share from 0 to 1. Consecutive changes are one undo step. */
export class Radii {
  readonly #store: Store<State>
  readonly #editing: Editing
  #scaling: Scaling | undefined
  /** The number of pending edits. */
  #asked = 0

  constructor(store: Store<State>, editing: Editing) {
    this.#store = store
    this.#editing = editing
  }

  /** The current share. */
  get share(): number {
    return this.#isLast ? (this.#scaling as Scaling).share : 1
  }

  async scale(share: number): Promise<void> {
    const { circles } = this.#editing
    if (!this.#isLast) {
      const radii = new Map(Array.from(circles.ids(), (id) => [id, circles.get(id)?.r ?? 0]))
      this.#scaling = { gesture: this.#editing.beginGesture(), radii, share }
    }
    const scaling = this.#scaling as Scaling
    scaling.share = share
    const edits = Array.from(scaling.radii).flatMap(([id, r]): Edit[] => {
      const circle = circles.get(id)
      return circle === undefined ? [] : [{ kind: 'replace', id, circle: { ...circle, r: share * r } }]
    })
    this.#asked += 1
    await this.#editing.edit(edits, scaling.gesture)
    this.#asked -= 1
  }

  /** Whether the last edit was made here. */
  get #isLast(): boolean {
    if (this.#asked > 0) return true
    const last = this.#store.get().history.done.at(-1)
    return last?.kind === 'edits' && last.gesture === this.#scaling?.gesture
  }
}
