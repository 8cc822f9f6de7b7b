// SPDX-License-Identifier: GPL-3.0-or-later
import { checkNoOptions, refuseArgument, refuseOption } from '../base/check.ts'
import {
  type Accessor,
  type CircleLike,
  type Circles,
  circleRadius,
  circleX,
  circleY,
  coordinatesFrom,
  coordinatesOf,
} from '../base/coordinates.ts'
import type { Box, Certificate, DiagramData, Float64s } from '../base/types.ts'
import { Diagram, updatable } from '../diagram/diagram.ts'
import { type Lattice, latticeNumbers } from '../diagram/lattice.ts'
import type { PeriodicDiagram } from '../diagram/periodic-diagram.ts'
import createModule from '../generated/circle-voronoi.js'
import type { Comparison } from './comparison.ts'
import { type DiagramEditor, type EditorOptions, editorStart } from './editor.ts'
import { judgedArrays, type Verifiable } from './judged-arrays.ts'
import type { LoadOptions } from './load-options.ts'
import { editorsOf } from './module-editor.ts'
import { periodicOf } from './module-periodic.ts'
import { checkOptions, type Options, type Progress } from './options.ts'
import type { Regions } from './regions.ts'
import { Trace, type TraceOptions } from './trace.ts'
import { type CompiledWasm, instantiate, unwrap } from './wasm.ts'

/**
 * The known properties of circles that are not part of the input: their centers lie outside the box, whose sides may be
 * infinite, and their radii are at most `maxRadius`.
 *
 * @category Loading
 */
export interface Known {
  readonly box: Box
  readonly maxRadius: number
}

/**
 * The parts of a diagram that also belong to the diagram of all circles, regardless of the circles outside.
 *
 * @category Loading
 */
export interface FinalCells {
  /**
   * For each circle, how far the box has to be widened on all sides, and the diagram computed again, until the cell of
   * the circle (or the circle that hides it) is guaranteed to be final: 0 if it is final, `Infinity` for an unbounded
   * cell.
   */
  readonly neededHalo: Float64Array
  /** For each vertex 1 if it is final, otherwise 0. */
  readonly vertices: Uint8Array
  /** For each edge 1 if it is final, otherwise 0. */
  readonly edges: Uint8Array
}

/**
 * The loaded library.
 *
 * @category Loading
 */
export interface CircleVoronoi {
  /**
   * Computes the Voronoi diagram of any number of circles, given as x, y, r of each in one `Float64Array` or
   * `Float32Array`, or as a list of objects `{ x, y, r }` or arrays `[x, y, r]`. They may be disjoint, intersecting,
   * tangent, nested, equal or points, in any position. The input is copied.
   *
   * @throws CircleVoronoiError with one of the codes of `ErrorCode`.
   */
  compute(circles: Circles, options?: Options): Diagram
  /**
   * Computes the diagram of circles that three accessor functions find in data, like `Delaunay.from` of d3-delaunay.
   * Each function is called with a datum, its index and the data. By default x, y and r are the properties of an
   * object, or the first three items of an array.
   *
   * @throws CircleVoronoiError as `compute`; what the functions throw
   */
  from<Datum>(
    data: Iterable<Datum>,
    fx: Accessor<Datum>,
    fy: Accessor<Datum>,
    fr: Accessor<Datum>,
    options?: Options,
  ): Diagram
  /** Computes the diagram of data with the properties x, y and r, or of arrays [x, y, r]. */
  from<Datum extends CircleLike>(
    data: Iterable<Datum>,
    fx?: Accessor<Datum>,
    fy?: Accessor<Datum>,
    fr?: Accessor<Datum>,
    options?: Options,
  ): Diagram
  /**
   * Computes the Voronoi diagram of circles in a plane that repeats with two periods: in a box whose opposite sides are
   * glued together. The box is any parallelogram. The circles may lie anywhere, be larger than the box, and be their
   * own
   * neighbors.
   *
   * Centers and periods are rounded once, to multiples of 2^-50 of the largest coordinate. The result is checked:
   * borders
   * have twins across the sides of the box, Euler's formula holds, and the areas sum to that of the box.
   *
   * @throws CircleVoronoiError as `compute`; `badArgument` if the lattice is none; `badOption` if the periods are zero,
   *   parallel or not finite.
   *
   * @example
   * ```js
   * const box = library.computePeriodic([[1, 1, 1], [5, 4, 2]], { a: [8, 0], b: [0, 6] })
   * box.neighbors(0).some(({ circle, shift }) => circle === 1 && shift[0] === -1) // true
   * ```
   */
  computePeriodic(circles: Circles, lattice: Lattice, options?: Options): PeriodicDiagram
  /**
   * Computes the diagram of `circles` and records each step on the way: of the touching disc method, of flips (`method:
   * 'auto'` or `'flip'`), or, with the option `edits`, of edits to the diagram of `circles`.
   *
   * @throws CircleVoronoiError as `compute`, and `DiagramEditor.apply`
   */
  trace(circles: Circles, options?: TraceOptions): Trace
  /**
   * Creates an editor for the diagram of `circles`, or for the circles of a diagram. Circle i gets the id i.
   *
   * @throws CircleVoronoiError as `compute`; `badArgument`, if it is a diagram of another metric
   */
  edit(circles: Circles | DiagramData, options?: EditorOptions): DiagramEditor
  /**
   * Checks in linear time, with exact signs, whether a diagram is the Voronoi diagram of its `circles`, whatever made
   * it. Only its typed arrays are read. `compute` has already checked its results.
   *
   * @throws CircleVoronoiError if an array has the wrong type or length, or a circle is none.
   */
  certify(diagram: Verifiable): Certificate
  /**
   * Finds in linear time the parts of a certified diagram that stay the same in the diagram of all circles, whatever
   * circles there are outside the box. A cell is final if it is bounded and the discs of its vertices, widened by
   * `maxRadius`, lie inside the box.
   *
   * @throws CircleVoronoiError `badArgument` if the box or the radius is none; `badInput` if an array has the wrong
   * type or
   *   length; `badOption` if the box is empty or the radius negative or not finite.
   */
  finalCells(diagram: Verifiable, known: Known): FinalCells
  /**
   * Loads a second WebAssembly module, which computes two related diagrams: the ordinary Voronoi diagram of the
   * centers, and the power diagram.
   *
   * @param options `wasm`: the source of `circle-voronoi-comparison.wasm`. Default: the file beside the library.
   * @throws CircleVoronoiError `notLoaded`, `badOption`. Each as a rejection.
   *
   * @example
   * ```js
   * const { computeComparison } = await library.loadComparison()
   * computeComparison([[0, 0, 3], [10, 0, 1]], 'power').find(5.2, 0) // 0
   * ```
   */
  loadComparison(options?: LoadOptions): Promise<Comparison>
  /**
   * Loads a WebAssembly module that clips diagrams to regions, and fits cells to given areas.
   *
   * @param options `wasm`: the source of `circle-voronoi-regions.wasm`. Default: the file beside the library.
   * @throws CircleVoronoiError `notLoaded`, `badOption`. Each as a rejection.
   *
   * @example
   * ```js
   * const { region } = await library.loadRegions()
   * const triangle = region([[[0, 0], [9, 0], [0, 9]]])
   * diagram.cellArea(0, { region: triangle }) // 12
   * ```
   */
  loadRegions(options?: LoadOptions): Promise<Regions>
}

/** The part of the library that is there from the start. */
export type ComputingLibrary = Omit<CircleVoronoi, 'loadComparison' | 'loadRegions'>

/** The library on a compiled `circle-voronoi.wasm`, with a memory of its own. */
export async function circleVoronoiOf(wasm: CompiledWasm): Promise<ComputingLibrary> {
  const module = await instantiate(createModule, wasm)
  const edit = editorsOf(module)

  const certify = (diagram: Verifiable, ...others: readonly unknown[]) => {
    checkNoOptions(others, 'certify')
    return unwrap(module.certify(judgedArrays(diagram)))
  }

  const told = <Value>(options: Options, run: (options: WasmOptions) => Value): Value => {
    const { weights, method, candidates, samples, resample } = options
    const reporter = new Reporter(options.progress)
    const result = run({ weights, method, candidates, samples, resample, progress: reporter.progress })
    reporter.rethrow()
    return result
  }

  const dataOf = (coordinates: Float64s, options: Options): DiagramData => {
    const result = told(options, (chosen) => module.compute(coordinates, chosen))
    return { metric: 'circles', circles: coordinates, ...unwrap(result) }
  }

  const diagramOf = (coordinates: Float64s, options: Options): Diagram =>
    updatable(new Diagram(dataOf(coordinates, options)), (circles) => dataOf(circles, options))

  return {
    compute(circles, options = {}) {
      checkOptions(options, 'compute')
      return diagramOf(coordinatesOf(circles), options)
    },
    from(
      data: Iterable<never>,
      fx: Accessor<never> = circleX,
      fy: Accessor<never> = circleY,
      fr: Accessor<never> = circleRadius,
      options: Options = {},
    ) {
      checkOptions(options, 'from')
      if (![fx, fy, fr].every((accessor) => typeof accessor === 'function')) {
        refuseArgument('from takes three functions, for x, y and r of a datum.')
      }
      return diagramOf(coordinatesFrom(data, fx, fy, fr), options)
    },
    computePeriodic(circles, lattice, options = {}) {
      checkOptions(options, 'computePeriodic')
      const numbers = latticeNumbers(lattice, 'computePeriodic')
      const coordinates = coordinatesOf(circles)
      const computed = unwrap(told(options, (chosen) => module.computePeriodic(coordinates, numbers, chosen)))
      return periodicOf(computed, coordinates.length / 3)
    },
    trace(circles, options = {}) {
      checkOptions(options, 'trace', ['edits'])
      const { edits, ...others } = options
      const coordinates = coordinatesOf(circles)
      if (edits !== undefined) {
        const { weights = false, ...unusable } = others
        const unused = Object.entries(unusable).find(([, value]) => value !== undefined)
        if (unused !== undefined) refuseOption(`The option ${unused[0]} does not go with edits.`)
        const editor = edit({ circles: coordinates, weights })
        try {
          const events = editor.trace(edits)
          return new Trace(editor.snapshot(), events)
        } finally {
          editor.dispose()
        }
      }
      const method = options.method ?? 'touching-disc'
      const run = (chosen: WasmOptions) => module.trace(coordinates, { ...chosen, method })
      const { diagram, events } = unwrap(told(others, run))
      return new Trace(new Diagram({ metric: 'circles', circles: coordinates, ...diagram }), events)
    },
    edit: (circles, options = {}) => edit(editorStart(circles, options)),
    certify,
    finalCells(diagram, known) {
      const { box, maxRadius }: Partial<Known> = Object(known)
      const { minX, minY, maxX, maxY }: Partial<Box> = Object(box)
      const sides = [minX, minY, maxX, maxY] as number[]
      if (![...sides, maxRadius].every((value) => typeof value === 'number')) {
        refuseArgument('finalCells takes what is known as { box: { minX, minY, maxX, maxY }, maxRadius }, all numbers.')
      }
      return unwrap(module.finalCells(judgedArrays(diagram), Float64Array.from(sides), maxRadius as number))
    },
  }
}

/** Ends the computation when a callback throws, and keeps the exception: no exception of JavaScript passes the core. */
class Reporter {
  readonly progress: ((...told: Parameters<Progress>) => boolean) | undefined
  #thrown: { readonly error: unknown } | undefined

  constructor(callback: Progress | undefined) {
    if (callback === undefined) return
    this.progress = (stage, done) => {
      try {
        callback(stage, done)
      } catch (error) {
        this.#thrown = { error }
      }
      return this.#thrown === undefined
    }
  }

  rethrow(): void {
    if (this.#thrown !== undefined) throw this.#thrown.error
  }
}
