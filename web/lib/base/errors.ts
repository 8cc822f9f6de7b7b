// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * The codes of the C++ enumeration `ErrorCode` (circle_voronoi/error.h), in its order.
 *
 * @category Errors
 * @example
 * ERROR_CODES.includes('negativeRadius') // true
 */
export const ERROR_CODES = [
  'nonFinite',
  'negativeRadius',
  'coordinateTooLarge',
  'coordinateTooSmall',
  'tooManyCircles',
  'badOption',
  'notCertified',
  'notConverged',
  'unknownCircle',
  'badInput',
  'badArithmetic',
  'notWritten',
  'internal',
] as const

/**
 * The reason of an error.
 *
 * - `nonFinite`: a coordinate or a radius is NaN or infinite
 * - `negativeRadius`: a radius is negative
 * - `coordinateTooLarge`: a number exceeds 2^96 (7.9e28) in absolute value
 * - `coordinateTooSmall`: the largest number of the input is not 0 and below 2^-56 (1.4e-17)
 * - `tooManyCircles`: the input, or the requested number of candidates, does not fit in memory
 * - `badOption`: an option is invalid
 * - `notCertified`: no construction led to a certified diagram
 * - `notConverged`: an iteration did not reach its tolerance
 * - `unknownCircle`: an editor has no circle with this id
 * - `badInput`: the input cannot be read as circles, or another argument that is no option is invalid
 * - `badArithmetic`: the program does not round to nearest (in C++ only)
 * - `notWritten`: a stream did not accept the whole text (in C++ only)
 * - `linkTooLong`: a link or its state exceeds `LINK_LIMITS`
 * - `notLoaded`: the WebAssembly cannot be loaded; `cause` is the reason
 * - `internal`: the library itself failed; please report the input
 *
 * @category Errors
 */
export type ErrorCode = (typeof ERROR_CODES)[number] | 'linkTooLong' | 'notLoaded'

/**
 * The error that all functions of this library throw. `message` is one sentence.
 *
 * @category Errors
 * @example
 * try {
 *   library.compute([[0, 0, 1], [5, 0, -1]])
 * } catch (error) {
 *   error.code // 'negativeRadius'
 *   error.circle // 1
 * }
 */
export class CircleVoronoiError extends Error {
  override readonly name = 'CircleVoronoiError'
  /** The reason. */
  readonly code: ErrorCode
  /** The index of the circle with the problem (its id in an editor); `undefined` if there is no such circle. */
  readonly circle: number | undefined
  /**
   * The weight of each site after the last step of a fit of areas that did not converge (`notConverged`), from which
   * another fit can go on; otherwise `undefined`.
   */
  readonly weights: Float64Array | undefined

  /** Creates an error. `details` are optional. */
  constructor(code: ErrorCode, message: string, { circle, weights, ...options }: ErrorDetails = {}) {
    super(message, options)
    this.code = code
    this.circle = circle
    this.weights = weights
  }
}

/**
 * The details of an error. All are optional.
 *
 * @category Errors
 */
export interface ErrorDetails extends ErrorOptions {
  /** The index of the circle with the problem, or its id in an editor. */
  readonly circle?: number | undefined
  /** The weights of a fit that did not converge. */
  readonly weights?: Float64Array | undefined
}

/** An error as plain data, which threads post to each other. */
export interface PostedError {
  readonly code: ErrorCode
  readonly circle: number | undefined
  readonly message: string
  readonly weights?: Float64Array | undefined
}

/** Returns a caught value as plain data. */
export function postedError(caught: unknown): PostedError {
  if (!(caught instanceof CircleVoronoiError)) {
    return { code: 'internal', circle: undefined, message: `${reasonOf(caught)}.` }
  }
  const { code, circle, message, weights } = caught
  return { code, circle, message, weights }
}

/** Returns the error that another thread has posted. */
export function receivedError({ code, message, ...details }: PostedError): CircleVoronoiError {
  return new CircleVoronoiError(code, message, details)
}

/** Returns the message of a caught value, for use in a sentence. */
export function reasonOf(cause: unknown): string {
  return (cause instanceof Error ? cause.message : String(cause)).replace(/\.$/, '')
}

/** Returns the error for a task that could not finish because a worker failed. `cause`: as in `ThreadEvents`. */
export function workerFailure(cause: unknown): CircleVoronoiError {
  const reason = cause === undefined ? 'its file cannot be loaded' : reasonOf(cause)
  return new CircleVoronoiError('internal', `The worker failed: ${reason}.`, { cause })
}

/**
 * Calls a listener. An error of the listener becomes an uncaught error, as with events, so it cannot make its caller
 * fail.
 */
export function callListener<Event>(listener: ((event: Event) => void) | undefined, event: Event): void {
  try {
    listener?.(event)
  } catch (error) {
    queueMicrotask(() => {
      throw error
    })
  }
}
