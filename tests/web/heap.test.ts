// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { expect, it } from 'vitest'
import { Heap } from '../../web/lib/queries/heap.ts'

const entries = fc.array(fc.record({ item: fc.nat(20), key: fc.integer({ min: -4, max: 4 }) }), { maxLength: 60 })

it('a heap gives back what it was given, by falling keys, and by falling indices where these are equal', () => {
  fc.assert(
    fc.property(entries, fc.nat(60), (list, early) => {
      const sorted = (part: typeof list) => part.toSorted((a, b) => b.key - a.key || b.item - a.item)
      const heap = new Heap()
      const first = list.slice(0, early)
      for (const { item, key } of first) heap.push(item, key)
      expect(heap.size).toBe(first.length)
      // Removes half of the items, then the rest mixed with new ones.
      const half = sorted(first).slice(0, first.length >> 1)
      expect(half.map(() => heap.pop())).toEqual(half)
      for (const { item, key } of list.slice(early)) heap.push(item, key)
      const rest = sorted([...sorted(first).slice(half.length), ...list.slice(early)])
      expect(rest.map(() => heap.pop())).toEqual(rest)
      expect(heap.size).toBe(0)
    }),
  )
})
