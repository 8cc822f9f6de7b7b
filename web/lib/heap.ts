// SPDX-License-Identifier: GPL-3.0-or-later

interface Entry {
  readonly item: number
  readonly key: number
}

/** A binary heap of indices, the one with the largest key first. */
export class Heap {
  readonly #entries: Entry[] = []

  get size(): number {
    return this.#entries.length
  }

  push(item: number, key: number): void {
    let place = this.size
    while (place > 0) {
      const parent = this.#at((place - 1) >> 1)
      if (parent.key >= key) break
      this.#entries[place] = parent
      place = (place - 1) >> 1
    }
    this.#entries[place] = { item, key }
  }

  /** Precondition: the heap is not empty. */
  pop(): Entry {
    const top = this.#at(0)
    const last = this.#entries.pop() as Entry
    if (this.size === 0) return top
    let place = 0
    for (let child = 1; child < this.size; child = 2 * place + 1) {
      if (child + 1 < this.size && this.#at(child + 1).key > this.#at(child).key) child += 1
      if (this.#at(child).key <= last.key) break
      this.#entries[place] = this.#at(child)
      place = child
    }
    this.#entries[place] = last
    return top
  }

  #at(place: number): Entry {
    return this.#entries[place] as Entry
  }
}
