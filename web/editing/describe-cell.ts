// SPDX-License-Identifier: GPL-3.0-or-later
import type { Described } from '../view/protocol.ts'
import { ENGLISH_EDITING } from './words.ts'

/** What is known of a circle's cell as a sentence, and the circles that it names. */
export function describeCell(described: Described, words = ENGLISH_EDITING): [string, readonly number[]] {
  const { hiddenBy, isBounded } = described
  if (hiddenBy !== undefined) return [words.hidden(hiddenBy), [hiddenBy]]
  const neighbors = [...described.neighbors]
  return [words.cell(isBounded, neighbors.length), neighbors]
}
