// SPDX-License-Identifier: GPL-3.0-or-later
import type { Described } from '../view/protocol.ts'
import type { EditingWords } from './words.ts'

/** The texts about circles, and their names within these. */
export interface Speech {
  readonly words: EditingWords
  /** A circle within a sentence. */
  called(id: number): string
}

/** Describes a circle's cell in a sentence. Also returns the circles that the sentence names. */
export function describeCell(described: Described, { words, called }: Speech): [string, readonly number[]] {
  const { hiddenBy, isBounded } = described
  if (hiddenBy !== undefined) return [words.hidden(called(hiddenBy)), [hiddenBy]]
  const neighbors = [...described.neighbors]
  return [words.cell(isBounded, neighbors.length), neighbors]
}
