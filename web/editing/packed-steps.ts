// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../lib/base/diagram-data.ts'
import type { Edit } from '../lib/index.ts'

const KINDS = ['insert', 'remove', 'replace'] as const

/**
 * The steps that undo an edit, packed into arrays of numbers. As objects, the steps of 100,000 circles would take 35
 * MB.
 */
export class PackedSteps {
  readonly #kinds: Uint8Array
  readonly #ids: Int32Array
  /** x, y and r of each step, zeros for removals. */
  readonly #numbers: Float64Array

  private constructor(kinds: Uint8Array, ids: Int32Array, numbers: Float64Array) {
    this.#kinds = kinds
    this.#ids = ids
    this.#numbers = numbers
  }

  static of(steps: readonly Edit[]): PackedSteps {
    const kinds = Uint8Array.from(steps, ({ kind }) => KINDS.indexOf(kind))
    const ids = Int32Array.from(steps, ({ id }) => id as number)
    const numbers = new Float64Array(3 * steps.length)
    steps.forEach((step, k) => {
      if (step.kind === 'remove') return
      const { x, y, r } = step.circle as { x: number; y: number; r: number }
      numbers.set([x, y, r], 3 * k)
    })
    return new PackedSteps(kinds, ids, numbers)
  }

  get length(): number {
    return this.#kinds.length
  }

  get bytes(): number {
    return this.#kinds.byteLength + this.#ids.byteLength + this.#numbers.byteLength
  }

  /** The ids of circles that exist before the steps run. */
  known(): Set<number> {
    return new Set(this.#ids.filter((_, k) => this.#kinds[k] !== 0))
  }

  /** Returns the steps as objects. */
  unpacked(): Edit[] {
    return Array.from(this.#kinds, (kind, k): Edit => {
      const id = at(this.#ids, k)
      const circle = { x: at(this.#numbers, 3 * k), y: at(this.#numbers, 3 * k + 1), r: at(this.#numbers, 3 * k + 2) }
      if (kind === 1) return { kind: 'remove', id }
      return { kind: kind === 2 ? 'replace' : 'insert', id, circle }
    })
  }

  /** Prepends other steps. */
  after(steps: readonly Edit[]): PackedSteps {
    if (steps.length === 0) return this
    const first = PackedSteps.of(steps)
    const count = first.length + this.length
    const [kinds, ids, numbers] = [new Uint8Array(count), new Int32Array(count), new Float64Array(3 * count)]
    kinds.set(first.#kinds)
    kinds.set(this.#kinds, first.length)
    ids.set(first.#ids)
    ids.set(this.#ids, first.length)
    numbers.set(first.#numbers)
    numbers.set(this.#numbers, 3 * first.length)
    return new PackedSteps(kinds, ids, numbers)
  }
}
