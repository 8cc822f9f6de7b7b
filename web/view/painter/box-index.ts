// SPDX-License-Identifier: GPL-3.0-or-later
import Flatbush from 'flatbush'
import { at } from '../../lib/base/diagram-data.ts'
import type { Box } from '../../lib/index.ts'
import { boxAt, clearBox, emptyBoxes } from './boxes.ts'

/** Number of changed boxes after which the index is rebuilt. */
const FEWEST_CHANGES = 2000
const CHANGED_SHARE = 0.02

/** A spatial index of numbered boxes. Boxes that have changed since the last rebuild are searched linearly. */
export class BoxIndex {
  /** Grows ahead of the number of boxes. Missing boxes are empty. */
  #boxes: Float64Array
  #packed: Flatbush | undefined
  #isPacked = false
  #numbers = new Uint32Array()
  readonly #changed = new Set<number>()

  /** Takes ownership of a list of boxes (boxes.ts). */
  constructor(boxes = emptyBoxes(0)) {
    this.#boxes = boxes
  }

  /** Changes a box. `make` gets the list with an empty box, and its index. */
  set(number: number, make: (boxes: Float64Array, k: number) => void): void {
    if (4 * number >= this.#boxes.length) {
      const larger = emptyBoxes(2 * number + 16)
      larger.set(this.#boxes)
      this.#boxes = larger
    }
    clearBox(this.#boxes, number)
    make(this.#boxes, number)
    this.#changed.add(number)
  }

  delete(number: number): void {
    if (4 * number >= this.#boxes.length) return
    clearBox(this.#boxes, number)
    this.#changed.add(number)
  }

  /** Returns a box, empty if it is missing. */
  get(number: number): Box {
    return 4 * number < this.#boxes.length ? boxAt(this.#boxes, number) : boxAt(emptyBoxes(1), 0)
  }

  search(box: Box): number[] {
    const most = Math.max(FEWEST_CHANGES, CHANGED_SHARE * this.#numbers.length)
    if (!this.#isPacked || this.#changed.size > most) this.#pack()
    const found: number[] = []
    this.#packed?.search(box.minX, box.minY, box.maxX, box.maxY, (k) => {
      const number = this.#numbers[k] as number
      if (!this.#changed.has(number)) found.push(number)
      return false
    })
    for (const number of this.#changed) if (this.#meets(number, box)) found.push(number)
    return found
  }

  #meets(number: number, { minX, minY, maxX, maxY }: Box): boolean {
    const boxes = this.#boxes
    return (
      at(boxes, 4 * number) <= maxX &&
      minX <= at(boxes, 4 * number + 2) &&
      at(boxes, 4 * number + 1) <= maxY &&
      minY <= at(boxes, 4 * number + 3)
    )
  }

  #pack(): void {
    const boxes = this.#boxes
    this.#changed.clear()
    this.#isPacked = true
    const places = new Uint32Array(boxes.length / 4).map((_, number) => number)
    this.#numbers = places.filter((number) => at(boxes, 4 * number) <= at(boxes, 4 * number + 2))
    this.#packed = this.#numbers.length === 0 ? undefined : new Flatbush(this.#numbers.length)
    if (this.#packed === undefined) return
    for (const number of this.#numbers) {
      const { minX, minY, maxX, maxY } = boxAt(boxes, number)
      this.#packed.add(minX, minY, maxX, maxY)
    }
    this.#packed.finish()
  }
}
