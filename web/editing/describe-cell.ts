// SPDX-License-Identifier: GPL-3.0-or-later
import type { Described } from '../view/protocol.ts'
import { ENGLISH_EDITING } from './words.ts'

/** Describes a circle's cell in a sentence. Also returns the circles that the sentence names. */
export function describeCell(described: Described, words = ENGLISH_EDITING): [string, readonly number[]] {
  const { hiddenBy, isBounded } = described
  if (hiddenBy !== undefined) return [words.hidden(hiddenBy), [hiddenBy]]
  const neighbors = [...described.neighbors]
  return [words.cell(isBounded, neighbors.length), neighbors]
}
