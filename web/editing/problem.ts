// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError } from '../lib/base/errors.ts'
import { ENGLISH_REFUSALS, type Refusals, type Telling } from '../view/refusal.ts'

/** How another language than English tells errors. */
export interface ProblemWords extends Refusals {
  /** An error of the library, whose message is English. */
  coded(error: CircleVoronoiError): string
}

/** What is wrong, as a reader is told; English by default. `hasCircles`: there are circles, which stay as they were. */
export function problemOf(error: Error, hasCircles: boolean, words?: ProblemWords): string {
  const isOfLibrary = error instanceof CircleVoronoiError
  const text = words === undefined ? error.message : told(error, words)
  return isOfLibrary || !hasCircles ? text : `${text} ${(words ?? ENGLISH_REFUSALS).nothingChanged}`
}

function told(error: Error, words: ProblemWords): string {
  if ('say' in error) return (error as Telling<ProblemWords>).say(words)
  return error instanceof CircleVoronoiError ? words.coded(error) : error.message
}
