// SPDX-License-Identifier: GPL-3.0-or-later

interface Entry {
  readonly item: number
  readonly key: number
}

/** A binary heap of indices. The largest key comes first; for equal keys, the largest index. */
export class Heap {
  readonly #entries: Entry[] = []

  get size(): number {
    return this.#entries.length
  }

  push(item: number, key: number): void {
    const entry = { item, key }
    let place = this.size
    while (place > 0) {
      const parent = this.#at((place - 1) >> 1)
      if (!isBefore(entry, parent)) break
      this.#entries[place] = parent
      place = (place - 1) >> 1
    }
    this.#entries[place] = entry
  }

  /** Precondition: the heap is not empty. */
  pop(): Entry {
    const top = this.#at(0)
    const last = this.#entries.pop() as Entry
    if (this.size === 0) return top
    let place = 0
    for (let child = 1; child < this.size; child = 2 * place + 1) {
      if (child + 1 < this.size && isBefore(this.#at(child + 1), this.#at(child))) child += 1
      if (!isBefore(this.#at(child), last)) break
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

function isBefore(one: Entry, other: Entry): boolean {
  return one.key > other.key || (one.key === other.key && one.item > other.item)
}
