// SPDX-License-Identifier: GPL-3.0-or-later
import { checkOptionNames, refuseOption, shown } from '../base/check.ts'
import type { Candidates, Method, Seconds } from '../base/types.ts'

/**
 * A stage of the computation.
 *
 * - `order`: brings the circles into spatial order
 * - `triangulate`: finds hidden circles and triangulates the centers of the others
 * - `sample`, `pair`, `touch`: the touching disc method: sample points, candidate pairs, event loop
 * - `flip`: flips edges of the triangulation
 * - `repair`: computes parts with flaws again
 * - `certify`: checks the result
 * - `assemble`: assembles the diagram
 *
 * @category Loading
 */
export type Stage = Exclude<keyof Seconds, 'total'>

/**
 * A callback for progress. It is called with `done` = 0 when a stage begins, and in the stages of the touching disc
 * method (`sample`, `pair`, `touch`) also with the completed fraction. The stages depend on the method and the input.
 * The callback may call any function of the library.
 *
 * @category Loading
 */
export type Progress = (stage: Stage, done: number) => void

/**
 * Options of `compute`.
 *
 * @category Loading
 */
export interface Options {
  /**
   * Whether the radii are additive weights, which may be negative. A point belongs to the circle with the least
   * distance minus weight, so adding one number to all weights changes nothing. Default: false; a negative radius is
   * then an error.
   */
  readonly weights?: boolean | undefined
  /**
   * The construction method. `auto` (default): the fastest construction that leads to a certified diagram.
   * `touching-disc`: the method of the paper, candidate pairs followed by the event loop. `flip`: edge flips that start
   * from the Delaunay triangulation of the centers. The last two may give a wrong diagram; its certificate says so.
   */
  readonly method?: Method | undefined
  /**
   * For the touching disc method: the pairs of circles that get an antipodal disc. They are neighbors in the Delaunay
   * graph of dynamically chosen samples (`dynamic`, default) or of equally spaced samples (`uniform`), or all pairs
   * (`all-pairs`: quadratic, at most 10,000 circles).
   */
  readonly candidates?: Candidates | undefined
  /**
   * The number of samples. `dynamic`: inside each angle of a Delaunay face, 0 to 1000, default 1. `uniform`: on each
   * circle, 1 to 1000, default 50. `all-pairs` uses none.
   */
  readonly samples?: number | undefined
  /**
   * For `dynamic` candidates: whether to add samples near flaws and try again if the diagram is not certified. Default:
   * false.
   */
  readonly resample?: boolean | undefined
  /** A callback for progress. If it throws, the computation ends and `compute` throws the same error. */
  readonly progress?: Progress | undefined
}

/** The names of the options of `compute`. */
const NAMES = ['weights', 'method', 'candidates', 'samples', 'resample', 'progress']
/** The names of the functions that find circles in data. */
export const ACCESSORS = ['x', 'y', 'r'] as const

/**
 * Checks the names and types of options, because embind would convert any value. The core checks the values. `more` has
 * the names of further options of the caller.
 *
 * @throws CircleVoronoiError `badOption`
 */
export function checkOptions(options: Options, caller: string, more: readonly string[] = []): void {
  checkOptionNames(options, caller, [...NAMES, ...more])
  const { weights, method, candidates, samples, resample }: { [Name in keyof Options]: unknown } = options
  const isText = (value: unknown) => value === undefined || typeof value === 'string'
  if (!isText(method) || !isText(candidates)) refuseOption('The options method and candidates are strings.')
  // -1 stands for the default in the core.
  if (
    samples !== undefined &&
    !(Number.isInteger(samples) && 0 <= (samples as number) && (samples as number) < 2 ** 31)
  ) {
    refuseOption(`The option samples is a whole number from 0, not ${shown(samples)}.`)
  }
  if (weights !== undefined) checkWeights(weights)
  if (resample !== undefined && typeof resample !== 'boolean') refuseOption('The option resample is true or false.')
  for (const name of ['progress', ...ACCESSORS]) {
    const value = (options as Record<string, unknown>)[name]
    if (value !== undefined && typeof value !== 'function') refuseOption(`The option ${name} is a function.`)
  }
}

/** @throws CircleVoronoiError `badOption` */
export function checkWeights(weights: unknown): asserts weights is boolean {
  if (typeof weights !== 'boolean') refuseOption('The option weights is true or false.')
}
