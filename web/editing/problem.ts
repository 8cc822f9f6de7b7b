// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError } from '../lib/base/errors.ts'
import { ENGLISH_REFUSALS, type LocalizedError, type Refusals } from '../view/refusal.ts'

/** Localized messages of errors. */
export interface ProblemWords extends Refusals {
  /** Localizes an error of the library. */
  coded(error: CircleVoronoiError): string
}

/**
 * The message of an error for users, in English by default. `hasCircles` means that circles are still shown, unchanged.
 */
export function problemOf(error: Error, hasCircles: boolean, words?: ProblemWords): string {
  const isOfLibrary = error instanceof CircleVoronoiError
  const text = words === undefined ? error.message : localized(error, words)
  return isOfLibrary || !hasCircles ? text : `${text} ${(words ?? ENGLISH_REFUSALS).nothingChanged}`
}

function localized(error: Error, words: ProblemWords): string {
  if ('say' in error) return (error as LocalizedError<ProblemWords>).say(words)
  return error instanceof CircleVoronoiError ? words.coded(error) : error.message
}
