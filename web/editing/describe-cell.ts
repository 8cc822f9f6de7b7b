// SPDX-License-Identifier: GPL-3.0-or-later
import type { Described } from '../view/protocol.ts'

/** What is known of a circle's cell as a sentence, and the circles that it names. */
export function describeCell(described: Described): [string, readonly number[]] {
  const { hiddenBy, isBounded } = described
  if (hiddenBy !== undefined) return [`Hidden inside circle ${hiddenBy}: it has no cell.`, [hiddenBy]]
  const neighbors = [...described.neighbors]
  const kind = isBounded ? 'Bounded cell' : 'Unbounded cell'
  return [`${kind}, ${neighbors.length} ${neighbors.length === 1 ? 'neighbor' : 'neighbors'}`, neighbors]
}
