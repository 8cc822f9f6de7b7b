// SPDX-License-Identifier: GPL-3.0-or-later
import type { Seconds } from './diagram-data.ts'
import { CircleVoronoiError } from './errors.ts'

/**
 * A stage of the computation:
 * - `hide`: circles that another contains are found, and the centres of the rest are triangulated;
 * - `sample`, `pair`, `touch`: the touching disc method, its points on circles, its pairs of circles, its event loop;
 * - `flip`: edges of a triangulation are flipped;
 * - `repair`: what is wrong in places is computed anew;
 * - `certify`: the result is judged.
 */
export type Stage = Exclude<keyof Seconds, 'total'>

/**
 * Told when a stage begins (`done` is 0) and, in those of the touching disc method (`sample`, `pair`, `touch`), which
 * part of it is done, up to 1. Which stages there are depends on the method and the input.
 */
export type Progress = (stage: Stage, done: number) => void

/** How a diagram is computed. */
export interface Options {
  /**
   * How the diagram is built. `auto` (the default): the fastest construction that leads to a certified diagram.
   * `touching-disc`: the paper's method, candidate pairs and then the event loop. `flip`: edge flips from the Delaunay
   * triangulation of the centres. The last two may give a wrong diagram; its certificate then says so.
   */
  readonly method?: 'auto' | 'touching-disc' | 'flip'
  /**
   * For the touching disc method: which pairs of circles get an antipodal disc, neighbours in the Delaunay graph of
   * dynamically chosen samples, of equally spaced samples, or every pair (quadratic, at most 10,000 circles). Default:
   * `dynamic`.
   */
  readonly candidates?: 'dynamic' | 'uniform' | 'all-pairs'
  /**
   * `dynamic`: samples inside each angle of a Delaunay face, 0 to 1000, default 1.
   * `uniform`: samples on each circle, 1 to 1000, default 50.
   * `all-pairs` takes none.
   */
  readonly samples?: number
  /** `dynamic`: if the diagram is not certified, take more samples near what is wrong and try again. Default: false. */
  readonly resample?: boolean
  /** Called during the computation. If it throws, the computation ends, and `compute` throws the same. */
  readonly progress?: Progress
}

/**
 * Refuses options of another type than theirs: embind converts whatever it is given. The core judges their values.
 *
 * @throws CircleVoronoiError `badOption`
 */
export function checkOptions(options: Options): void {
  if (typeof options !== 'object' || options === null) {
    throw new CircleVoronoiError('badOption', -1, 'The options are not an object.')
  }
  const { method, candidates, samples, resample, progress }: { [Name in keyof Options]: unknown } = options
  const isText = (value: unknown) => value === undefined || typeof value === 'string'
  if (!isText(method) || !isText(candidates)) {
    throw new CircleVoronoiError('badOption', -1, 'The options method and candidates are strings.')
  }
  if (samples !== undefined && !(Number.isInteger(samples) && Math.abs(samples as number) < 2 ** 31)) {
    throw new CircleVoronoiError('badOption', -1, 'The option samples is a whole number.')
  }
  if (resample !== undefined && typeof resample !== 'boolean') {
    throw new CircleVoronoiError('badOption', -1, 'The option resample is true or false.')
  }
  if (progress !== undefined && typeof progress !== 'function') {
    throw new CircleVoronoiError('badOption', -1, 'The option progress is a function.')
  }
}
