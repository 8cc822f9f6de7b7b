// SPDX-License-Identifier: GPL-3.0-or-later
import { checkNoOptions, refuseOption } from '../base/check.ts'
import { type Accessors, type Circles, coordinatesOf } from '../base/coordinates.ts'
import { at } from '../base/diagram-data.ts'
import {
  CANDIDATES,
  type Certificate,
  type DiagramData,
  type Float64s,
  METHODS,
  METRICS,
  type Metric,
} from '../base/types.ts'
import { ComputedDiagram } from '../diagram/computed-diagram.ts'
import { type Lattice, latticeNumbers } from '../diagram/lattice.ts'
import { PeriodicDiagram } from '../diagram/periodic-diagram.ts'
import { judgedArrays, type Verifiable } from './judged-arrays.ts'
import type { CircleVoronoi } from './library.ts'
import { periodicOf } from './module-periodic.ts'
import { ACCESSORS, checkOptions, type Options, type Progress } from './options.ts'
import { reporting } from './reporting.ts'
import { type CompiledWasm, type EmscriptenOptions, instantiate, unwrap } from './wasm.ts'

/**
 * Options of `compute` for any metric.
 *
 * @category Metrics
 */
export interface MetricOptions extends Options {
  /**
   * The distance of a point p from a circle with center c, radius r and weight w, which defines the cells.
   *
   * - `circles` (default): |p - c| - r, or |p - c| - w
   * - `centers`: |p - c|, which gives the ordinary Voronoi diagram of the centers
   * - `power`: |p - c|² - r², or |p - c|² - w, which gives the power (Laguerre) diagram
   */
  readonly metric?: Metric | undefined
  /**
   * Whether the third number of a circle is the weight w, of any sign, instead of the radius. A power diagram takes
   * weights up to 2^192. Default: false; a negative radius is then an error.
   */
  readonly weights?: boolean | undefined
}

/**
 * Computes diagrams by any metric.
 *
 * @category Metrics
 */
export interface Metrics {
  /** Computes the diagram of circles that functions find in data, as `compute` of the library does. */
  compute<Datum>(data: Iterable<Datum>, options: MetricOptions & Accessors<Datum>): ComputedDiagram
  /**
   * Computes the diagram of `circles` by a metric. The result is certified. Its methods, and functions of cells and
   * curves, use this metric too.
   *
   * With `centers`, the radius of a vertex is its distance from its three centers, and if several circles have the same
   * center, the first one has the cell. With `power`, the radius of a vertex is the radius of the circle at right
   * angles to its three circles. Where the three circles overlap, it is minus the square root of their negative power.
   * A circle without a cell is listed as hidden by a visible circle beside its center, though no circle need contain
   * it. The center of a circle may lie outside its cell.
   *
   * @throws CircleVoronoiError with one of the codes of `ErrorCode`; `badOption`, if a metric other than `circles` has
   *   another method than `auto`
   */
  compute(circles: Circles, options?: MetricOptions): ComputedDiagram
  /** Computes the periodic diagram of circles that functions find in data, as `compute` does. */
  computePeriodic<Datum>(
    data: Iterable<Datum>,
    lattice: Lattice,
    options: MetricOptions & Accessors<Datum>,
  ): PeriodicDiagram
  /**
   * Computes the periodic diagram of circles by a metric, with the other arguments and the result of `computePeriodic`
   * of the library. A circle in a box has a power cell if the cell has an interior, wherever the box begins.
   *
   * @throws CircleVoronoiError as `compute` and `computePeriodic` of the library
   */
  computePeriodic(circles: Circles, lattice: Lattice, options?: MetricOptions): PeriodicDiagram
  /**
   * Checks in linear time, with exact signs, whether a diagram by any metric is that of its `circles`, as `certify` of the
   * library does.
   *
   * @throws CircleVoronoiError if an array has the wrong type or length, or a circle is invalid
   */
  certify(diagram: Verifiable): Certificate
}

/** The script of the module, as written by Emscripten. */
export type MetricsScript = (options: EmscriptenOptions) => Promise<object>

/** Returns the WebAssembly that this thread loaded last, for a worker. */
export function newestMetricsWasm(): CompiledWasm | undefined {
  return newest
}

let newest: CompiledWasm | undefined

/**
 * Checks the options of a computation by any metric. `more` has the names of further options of the caller.
 *
 * @throws CircleVoronoiError `badOption`
 */
export function checkMetricOptions(options: MetricOptions, caller: string, more: readonly string[] = []): void {
  checkOptions(options, caller, ['metric', ...more, ...ACCESSORS])
  const { metric = 'circles', method = 'auto', candidates = 'dynamic' } = options
  checkChoice('metric', metric, METRICS)
  if (metric === 'circles') return
  checkChoice('method', method, METHODS)
  checkChoice('candidates', candidates, CANDIDATES)
  if (method !== 'auto') refuseOption(`A diagram of the metric ${metric} is computed by the method auto only.`)
}

/** Refuses a value that is not known, in the words of the core. */
function checkChoice(name: string, value: string, known: readonly string[]): void {
  if (known.includes(value)) return
  refuseOption(`Unknown ${name}: the choice is ${known.slice(0, -1).join(', ')} or ${known.at(-1)}.`)
}

/**
 * Creates the functions for metrics from a module.
 *
 * @throws CircleVoronoiError `notLoaded`
 */
export async function metricsOf(
  createModule: MetricsScript,
  wasm: CompiledWasm | Promise<CompiledWasm>,
  library: CircleVoronoi | Promise<CircleVoronoi>,
): Promise<Metrics> {
  const [compiled, { compute, computePeriodic, certify }] = await Promise.all([wasm, library])
  const module = (await instantiate(createModule, compiled)) as WasmMetricsModule
  newest = compiled

  const powerOf = (coordinates: Float64s, { weights = false, progress }: MetricOptions): DiagramData => {
    const computed = reporting(progress, (reporter) => module.powerDiagram(coordinates, weights, reporter))
    const { circles, ...data } = unwrap(computed)
    coordinates.set(circles)
    return { metric: 'power', circles: coordinates, ...data }
  }

  const centersOf = (coordinates: Float64s, { weights = false, progress }: MetricOptions): DiagramData => {
    // Radii are checked before they are dropped, so that errors in them are reported.
    const { circles } = unwrap(module.validCircles(coordinates, weights))
    const diagram = compute(
      circles.map((value, k) => (k % 3 === 2 ? 0 : value)),
      { progress },
    )
    coordinates.set(circles)
    return { ...diagram, metric: 'centers', weights, circles: coordinates }
  }

  return {
    compute<Datum>(circles: Circles | Iterable<Datum>, options: MetricOptions & Partial<Accessors<Datum>> = {}) {
      checkMetricOptions(options, 'compute')
      const { metric = 'circles', x, y, r, ...others } = options
      const coordinates = coordinatesOf(circles, { x, y, r })
      if (metric === 'circles') return compute(coordinates, others)
      const dataOf = metric === 'power' ? powerOf : centersOf
      return new ComputedDiagram(coordinates, (current) => dataOf(current, others))
    },
    computePeriodic<Datum>(
      circles: Circles | Iterable<Datum>,
      lattice: Lattice,
      options: MetricOptions & Partial<Accessors<Datum>> = {},
    ) {
      checkMetricOptions(options, 'computePeriodic')
      const { metric = 'circles', x, y, r, ...others } = options
      const periods = latticeNumbers(lattice, 'computePeriodic')
      const coordinates = coordinatesOf(circles, { x, y, r })
      if (metric === 'circles') return computePeriodic(coordinates, lattice, others)
      const { weights = false, progress } = others
      if (metric === 'power') {
        const computed = reporting<Parameters<Progress>, ReturnType<typeof module.periodicPower>>(
          progress,
          (reporter) => module.periodicPower(coordinates, periods, weights, reporter),
        )
        return periodicOf(unwrap(computed), coordinates.length / 3, metric)
      }
      const { circles: valid } = unwrap(module.validCircles(coordinates, weights))
      const points = valid.map((value, k) => (k % 3 === 2 ? 0 : value))
      const { diagram, ...images } = computePeriodic(points, lattice, { progress })
      // Images have the radius of their circle.
      const radii = diagram.circles.map((value, k) =>
        k % 3 === 2 ? at(valid, 3 * at(images.circleOf, (k - 2) / 3) + 2) : value,
      )
      return new PeriodicDiagram({ ...images, diagram: { ...diagram, metric, weights, circles: radii } })
    },
    certify(diagram: Verifiable, ...others: readonly unknown[]) {
      checkNoOptions(others, 'certify')
      const { metric }: Partial<Verifiable> = Object(diagram)
      return metric === 'power' ? unwrap(module.certifyPower(judgedArrays(diagram))) : certify(diagram)
    },
  }
}
