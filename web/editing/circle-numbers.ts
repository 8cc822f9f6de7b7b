// SPDX-License-Identifier: GPL-3.0-or-later

/** Assigns numbers to circles. A circle that undo restores keeps its number but gets a new id. */
export interface Numbering {
  /** Exceptions, where the number is not `shift` more than the id. */
  readonly numbers: ReadonlyMap<number, number>
  readonly shift: number
  /** All numbers are below this one. */
  readonly end: number
}

/**
 * The numbers of circles. A circle's number is its first id. Undo restores a removed circle under a new id and its old
 * number.
 */
export class CircleNumbers {
  /** Maps numbers to ids and back, for circles whose number is not `#shift` more than their id. */
  readonly #ids = new Map<number, number>()
  readonly #numbers: Map<number, number>
  #shift: number

  constructor({ numbers, shift }: Pick<Numbering, 'numbers' | 'shift'> = { numbers: new Map(), shift: 0 }) {
    this.#numbers = new Map(numbers)
    this.#shift = shift
  }

  idOf(number: number): number {
    return this.#ids.get(number) ?? number - this.#shift
  }

  numberOf(id: number): number {
    return this.#numbers.get(id) ?? id + this.#shift
  }

  give(id: number, number: number): void {
    this.#ids.set(number, id)
    this.#numbers.set(id, number)
  }

  clear(): void {
    this.#ids.clear()
    this.#numbers.clear()
    this.#shift = 0
  }

  /** Gives the circles 0, 1 and so on the numbers that `ids` had. New circles get numbers from `end` on. */
  restore(ids: Int32Array, former: CircleNumbers, end: number): void {
    this.#shift = end - ids.length
    ids.forEach((id, k) => {
      if (former.numberOf(id) !== k + this.#shift) this.give(k, former.numberOf(id))
    })
  }

  /** A copy for circles whose ids are below `size`. */
  numbering(size: number): Numbering {
    return { numbers: new Map(this.#numbers), shift: this.#shift, end: size + this.#shift }
  }
}
