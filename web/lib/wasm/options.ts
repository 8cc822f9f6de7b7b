// SPDX-License-Identifier: GPL-3.0-or-later
import { checkOptionNames, refuseOption, shown } from '../base/check.ts'
import type { Seconds } from '../base/types.ts'

/**
 * A stage of the computation:
 * - `triangulate`: the hidden circles are found, and the centers of the others are triangulated;
 * - `sample`, `pair`, `touch`: the touching disc method, its points on circles, its pairs of circles, its event loop;
 * - `flip`: edges of a triangulation are flipped;
 * - `repair`: what is wrong in places is computed anew;
 * - `certify`: the result is judged.
 *
 * @category Loading
 */
export type Stage = Exclude<keyof Seconds, 'total'>

/**
 * Told when a stage begins (`done` is 0) and, in those of the touching disc method (`sample`, `pair`, `touch`), which
 * part of it is done, up to 1. Which stages there are depends on the method and the input.
 *
 * @category Loading
 */
export type Progress = (stage: Stage, done: number) => void

/**
 * How a diagram is computed.
 *
 * @category Loading
 */
export interface Options {
  /**
   * Whether the radii are additive weights, which may be negative: a point belongs to the circle of least distance less
   * weight, so that one number added to all changes nothing. Default: false, and a negative radius is an error.
   */
  readonly weights?: boolean | undefined
  /**
   * How the diagram is built. `auto` (the default): the fastest construction that leads to a certified diagram.
   * `touching-disc`: the paper's method, candidate pairs and then the event loop. `flip`: edge flips from the Delaunay
   * triangulation of the centres. The last two may give a wrong diagram; its certificate then says so.
   */
  readonly method?: 'auto' | 'touching-disc' | 'flip' | undefined
  /**
   * For the touching disc method: which pairs of circles get an antipodal disc, neighbours in the Delaunay graph of
   * dynamically chosen samples, of equally spaced samples, or every pair (quadratic, at most 10,000 circles). Default:
   * `dynamic`.
   */
  readonly candidates?: 'dynamic' | 'uniform' | 'all-pairs' | undefined
  /**
   * `dynamic`: samples inside each angle of a Delaunay face, 0 to 1000, default 1.
   * `uniform`: samples on each circle, 1 to 1000, default 50.
   * `all-pairs` takes none.
   */
  readonly samples?: number | undefined
  /** `dynamic`: if the diagram is not certified, take more samples near what is wrong and try again. Default: false. */
  readonly resample?: boolean | undefined
  /** Called during the computation. If it throws, the computation ends, and `compute` throws the same. */
  readonly progress?: Progress | undefined
}

/** The names of the options of `compute`. */
const NAMES = ['weights', 'method', 'candidates', 'samples', 'resample', 'progress']

/**
 * Refuses options of another name or type than theirs: embind converts whatever it is given. The core judges the other
 * values. `more`: names of options that the caller takes besides.
 *
 * @throws CircleVoronoiError `badOption`
 */
export function checkOptions(options: Options, caller: string, more: readonly string[] = []): void {
  checkOptionNames(options, caller, [...NAMES, ...more])
  const { weights, method, candidates, samples, resample, progress }: { [Name in keyof Options]: unknown } = options
  const isText = (value: unknown) => value === undefined || typeof value === 'string'
  if (!isText(method) || !isText(candidates)) refuseOption('The options method and candidates are strings.')
  // -1 is what the core has for the default.
  if (
    samples !== undefined &&
    !(Number.isInteger(samples) && 0 <= (samples as number) && (samples as number) < 2 ** 31)
  ) {
    refuseOption(`The option samples is a whole number from 0, not ${shown(samples)}.`)
  }
  if (weights !== undefined && typeof weights !== 'boolean') refuseOption('The option weights is true or false.')
  if (resample !== undefined && typeof resample !== 'boolean') refuseOption('The option resample is true or false.')
  if (progress !== undefined && typeof progress !== 'function') refuseOption('The option progress is a function.')
}
