// SPDX-License-Identifier: GPL-3.0-or-later
import Flatbush from 'flatbush'
import type { Box } from '../../lib/index.ts'
import { meets } from './boxes.ts'

/** So many boxes may have changed before the index of all is made anew. */
const FEWEST_CHANGES = 2000
const CHANGED_SHARE = 0.02

/** Boxes by number, and which of them meet a box. They may change: those that did since the last packing are kept apart. */
export class BoxIndex {
  readonly #boxes = new Map<number, Box>()
  #packed: Flatbush | undefined
  #numbers: number[] = []
  readonly #changed = new Set<number>()

  set(number: number, box: Box): void {
    this.#boxes.set(number, box)
    this.#changed.add(number)
  }

  delete(number: number): void {
    this.#boxes.delete(number)
    this.#changed.add(number)
  }

  get(number: number): Box | undefined {
    return this.#boxes.get(number)
  }

  search(box: Box): number[] {
    if (this.#changed.size > Math.max(FEWEST_CHANGES, CHANGED_SHARE * this.#boxes.size)) this.#pack()
    const found: number[] = []
    this.#packed?.search(box.minX, box.minY, box.maxX, box.maxY, (k) => {
      const number = this.#numbers[k] as number
      if (!this.#changed.has(number)) found.push(number)
      return false
    })
    for (const number of this.#changed) {
      const own = this.#boxes.get(number)
      if (own !== undefined && meets(own, box)) found.push(number)
    }
    return found
  }

  #pack(): void {
    this.#changed.clear()
    this.#packed = undefined
    this.#numbers = [...this.#boxes.keys()]
    if (this.#numbers.length === 0) return
    const packed = new Flatbush(this.#numbers.length)
    for (const { minX, minY, maxX, maxY } of this.#boxes.values()) packed.add(minX, minY, maxX, maxY)
    packed.finish()
    this.#packed = packed
  }
}
