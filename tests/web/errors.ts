// SPDX-License-Identifier: GPL-3.0-or-later
import { expect } from 'vitest'
import { CircleVoronoiError } from '../../web/lib/index.ts'

/** The error of the library that a call throws. */
export function errorOf(run: () => unknown): CircleVoronoiError {
  try {
    run()
  } catch (error) {
    expect(error).toBeInstanceOf(CircleVoronoiError)
    return error as CircleVoronoiError
  }
  throw new Error('Nothing was thrown.')
}

/** The code and the message of the error that a call throws, or `no problem`. */
export function problemOf(run: () => unknown): string {
  try {
    run()
  } catch (error) {
    return error instanceof CircleVoronoiError ? `${error.code}: ${error.message}` : String(error)
  }
  return 'no problem'
}

/** Passes a value of a wrong type, as a program without types may do. */
export const untyped = (value: unknown) => value as never
