// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../lib/base/diagram-data.ts'
import type { Circle, Edit } from '../lib/index.ts'

/** What was opened, and what has become of it: enough for another thread to have the same circles by the same ids. */
export class CircleLog {
  readonly opened: Float64Array
  /** What each circle is now that has changed; `undefined`: gone. */
  readonly #changed = new Map<number, Circle | undefined>()
  #lastId: number

  /** The circles are not copied; circle i has id i. */
  constructor(opened: Float64Array) {
    this.opened = opened
    this.#lastId = opened.length / 3 - 1
  }

  /** A circle as it is; `undefined`: there is none. */
  circle(id: number): Circle | undefined {
    if (this.#changed.has(id)) return this.#changed.get(id)
    if (!(id >= 0 && id < this.opened.length / 3)) return undefined
    return { x: at(this.opened, 3 * id), y: at(this.opened, 3 * id + 1), r: at(this.opened, 3 * id + 2) }
  }

  /** `inserted`: the ids of the circles that came. */
  add(edits: readonly Edit[], inserted: Int32Array): void {
    let next = 0
    for (const edit of edits) {
      const id = edit.kind === 'insert' ? at(inserted, next++) : edit.id
      this.#changed.set(id, edit.kind === 'remove' ? undefined : (edit.circle as Circle))
      this.#lastId = Math.max(this.#lastId, id)
    }
  }

  /** The edits that make of what was opened what it is now. Ids are given in order: those that are gone come and go. */
  edits(): Edit[] {
    const first = this.opened.length / 3
    const edits: Edit[] = []
    const gone: Edit[] = []
    for (const [id, circle] of this.#changed) {
      if (circle === undefined) gone.push({ kind: 'remove', id })
      else if (id < first) edits.push({ kind: 'replace', id, circle })
    }
    for (let id = first; id <= this.#lastId; id++) {
      const circle = this.#changed.get(id)
      edits.push({ kind: 'insert', circle: circle ?? PLACEHOLDER })
      if (!this.#changed.has(id)) gone.push({ kind: 'remove', id })
    }
    return [...edits, ...gone]
  }
}

const PLACEHOLDER: Circle = { x: 0, y: 0, r: 0 }
