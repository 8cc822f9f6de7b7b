// SPDX-License-Identifier: GPL-3.0-or-later
import { checkNoOptions, refuseInput, refuseOption } from '../base/check.ts'
import { roundAll } from '../base/coordinate-limits.ts'
import { type Accessors, type Circles, coordinatesOf } from '../base/coordinates.ts'
import type { Box, Certificate, DiagramData, Float64s } from '../base/types.ts'
import { ComputedDiagram } from '../diagram/computed-diagram.ts'
import { Diagram } from '../diagram/diagram.ts'
import { type Lattice, latticeNumbers } from '../diagram/lattice.ts'
import type { PeriodicDiagram } from '../diagram/periodic-diagram.ts'
import createModule from '../generated/circle-voronoi.js'
import { type DiagramEditor, type EditorOptions, editorStart } from './editor.ts'
import { judgedCircles, type Verifiable } from './judged-arrays.ts'
import { editorsOf } from './module-editor.ts'
import { periodicOf } from './module-periodic.ts'
import { ACCESSORS, checkOptions, type Options } from './options.ts'
import { goingOn, reporting } from './reporting.ts'
import { Trace, type TraceOptions } from './trace.ts'
import { type CompiledWasm, instantiate, unwrap } from './wasm.ts'

/**
 * Known facts about circles that are not part of the input. Their centers lie outside the box, whose coordinates may be
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
   * For each circle, the width by which the box must grow on all sides so that the cell of the circle (or of the circle
   * that hides it) is certainly final in the new diagram. 0 if the cell is final, `Infinity` if it is unbounded.
   */
  readonly neededHalo: Float64Array
  /** For each vertex 1 if it is final, otherwise 0. */
  readonly vertices: Uint8Array
  /** For each edge 1 if it is final, otherwise 0. */
  readonly edges: Uint8Array
}

/**
 * The functions of the loaded library.
 *
 * @category Loading
 */
export interface CircleVoronoi {
  /**
   * Computes the diagram of circles that the functions `x`, `y` and `r` find in data, like `Delaunay.from` of
   * d3-delaunay. Each function is called with a datum, its index and the data.
   *
   * @throws CircleVoronoiError as for plain circles. Errors of the functions are passed on.
   *
   * @example
   * const cities = [{ at: [0, 0], people: 4 }, { at: [6, 0], people: 1 }]
   * library.compute(cities, { x: (d) => d.at[0], y: (d) => d.at[1], r: (d) => Math.sqrt(d.people) }).find(3.2, 0) // 0
   */
  compute<Datum>(data: Iterable<Datum>, options: Options & Accessors<Datum>): ComputedDiagram
  /**
   * Computes the Voronoi diagram of any number of circles, given as x, y, r of each in one `Float64Array` or
   * `Float32Array`, or as a list of objects `{ x, y, r }` or arrays `[x, y, r]`. The circles may be disjoint,
   * intersecting, tangent, nested, equal or points, in any position. The input is copied.
   *
   * @throws CircleVoronoiError with one of the codes of `ErrorCode`.
   */
  compute(circles: Circles, options?: Options): ComputedDiagram
  /** Computes the periodic diagram of circles that functions find in data, as `compute` does. */
  computePeriodic<Datum>(data: Iterable<Datum>, lattice: Lattice, options: Options & Accessors<Datum>): PeriodicDiagram
  /**
   * Computes the Voronoi diagram of circles in a plane that repeats with two periods: in a box whose opposite sides are
   * glued together. The box can be any parallelogram. The circles may lie anywhere, be larger than the box, and be
   * their own neighbors.
   *
   * Centers and periods are rounded once, to multiples of 2^-50 of the largest coordinate. The result is checked:
   * borders have twins across the sides of the box, Euler's formula holds, and the areas sum to that of the box.
   *
   * @throws CircleVoronoiError as `compute`; `badInput` if the lattice is invalid; `badOption` if the periods are zero,
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
   * Computes the diagram of `circles` and records each step of the touching disc method or of flips (`method: 'auto'`
   * or `'flip'`). With the option `edits`, records the steps of these edits to the diagram of `circles`.
   *
   * @throws CircleVoronoiError as `compute`, and `DiagramEditor.apply`
   */
  trace(circles: Circles, options?: TraceOptions): Trace
  /**
   * Creates an editor for the diagram of `circles`, or for the circles of a diagram. Circle i gets the id i, or the id
   * that the options give.
   *
   * @throws CircleVoronoiError as `compute`; `badInput`, if the diagram has another metric
   */
  edit(circles: Circles | DiagramData, options?: EditorOptions): DiagramEditor
  /**
   * Checks in linear time, with exact signs, whether a diagram is the Voronoi diagram of its `circles`, or of their
   * centers, whatever made it. Its certificate is not read. `compute` has already checked its results.
   *
   * @throws CircleVoronoiError if an array has the wrong type or length, a circle is invalid, or the diagram is a power
   *   diagram, which `certify` of `loadMetrics` checks
   */
  certify(diagram: Verifiable): Certificate
  /**
   * Finds in linear time the parts of a certified diagram that stay the same whatever circles are added outside the
   * box. A cell is final if it is bounded and the discs of its vertices, widened by `maxRadius`, lie inside the box.
   *
   * @throws CircleVoronoiError `badInput` if the box or the radius is not made of numbers, an array has the wrong
   *   type or length, or the diagram is a power diagram; `badOption` if the box is empty or the radius negative or not
   *   finite.
   */
  finalCells(diagram: Verifiable, known: Known): FinalCells
}

/** Creates a library from a compiled `circle-voronoi.wasm`, with its own memory. */
export async function circleVoronoiOf(wasm: CompiledWasm): Promise<CircleVoronoi> {
  const module = await instantiate(createModule, wasm)
  const edit = editorsOf(module)

  const certify = (diagram: Verifiable, ...others: readonly unknown[]) => {
    checkNoOptions(others, 'certify')
    return unwrap(module.certify(judgedCircles(diagram, 'certify')))
  }

  const told = <Value>(options: Options, run: (options: WasmOptions) => Value): Value => {
    const { weights, method, candidates, samples, resample } = options
    return reporting(options.progress, (reporter) => {
      const progress = reporter && goingOn(reporter)
      return run({ weights, method, candidates, samples, resample, progress })
    })
  }

  const dataOf = (coordinates: Float64s, options: Options): DiagramData => {
    const result = told(options, (chosen) => module.compute(coordinates, chosen))
    const data = unwrap(result)
    return { metric: 'circles', circles: roundAll(coordinates), ...data }
  }

  return {
    compute<Datum>(circles: Circles | Iterable<Datum>, options: Options & Partial<Accessors<Datum>> = {}) {
      checkOptions(options, 'compute', ACCESSORS)
      return new ComputedDiagram(coordinatesOf(circles, options), (coordinates) => dataOf(coordinates, options))
    },
    computePeriodic<Datum>(
      circles: Circles | Iterable<Datum>,
      lattice: Lattice,
      options: Options & Partial<Accessors<Datum>> = {},
    ) {
      checkOptions(options, 'computePeriodic', ACCESSORS)
      const numbers = latticeNumbers(lattice, 'computePeriodic')
      const coordinates = coordinatesOf(circles, options)
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
      return new Trace(new Diagram({ metric: 'circles', circles: roundAll(coordinates), ...diagram }), events)
    },
    edit: (circles, options = {}) => edit(editorStart(circles, options)),
    certify,
    finalCells(diagram, known) {
      const { box, maxRadius }: Partial<Known> = Object(known)
      const { minX, minY, maxX, maxY }: Partial<Box> = Object(box)
      const sides = [minX, minY, maxX, maxY] as number[]
      if (![...sides, maxRadius].every((value) => typeof value === 'number')) {
        refuseInput('finalCells takes what is known as { box: { minX, minY, maxX, maxY }, maxRadius }, all numbers.')
      }
      return unwrap(
        module.finalCells(judgedCircles(diagram, 'finalCells'), Float64Array.from(sides), maxRadius as number),
      )
    },
  }
}
