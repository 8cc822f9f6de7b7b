// SPDX-License-Identifier: GPL-3.0-or-later
import { refuseArgument, refuseOption } from '../base/check.ts'
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
import { Diagram } from '../diagram/diagram.ts'
import createModule from '../generated/circle-voronoi.js'
import { type DiagramEditor, editedCircles } from './editor.ts'
import { judgedArrays, type Verifiable } from './judged-arrays.ts'
import { editorsOf } from './module-editor.ts'
import { checkOptions, type Options, type Progress } from './options.ts'
import { Trace, type TraceOptions } from './trace.ts'
import { type CompiledWasm, instantiate, unwrap } from './wasm.ts'

/**
 * What is known of the circles that a diagram has not been told of: their centres are outside the box, whose sides may be
 * infinite, and their radii are at most `maxRadius`.
 *
 * @category Loading
 */
export interface Known {
  readonly box: Box
  readonly maxRadius: number
}

/**
 * Which parts of a diagram are those of the whole diagram, whatever lies outside.
 *
 * @category Loading
 */
export interface FinalCells {
  /**
   * Of each circle by how much the box has to be widened on all sides, with the diagram computed anew, until its cell, or
   * what hides it, is sure to be final. 0: it is; `Infinity` for an unbounded cell.
   */
  readonly neededHalo: Float64Array
  /** Of each vertex 1 if it is final, else 0. */
  readonly vertices: Uint8Array
  /** Of each edge likewise. */
  readonly edges: Uint8Array
}

/**
 * The library, loaded.
 *
 * @category Loading
 */
export interface CircleVoronoi {
  /**
   * The Voronoi diagram of `circles`: x, y, r of each in one `Float64Array` or `Float32Array`, or a list of objects
   * `{ x, y, r }` or arrays `[x, y, r]`. They may be disjoint, intersecting, tangent, nested, equal or points, in any
   * position, and any number from 0. The input is copied.
   *
   * @throws CircleVoronoiError with one of the codes of `ErrorCode`.
   */
  compute(circles: Circles, options?: Options): Diagram
  /**
   * The same of the circles that three functions find in data, as `Delaunay.from` of d3-delaunay: each is called with a
   * datum, its index and the data. Default: x, y and r of an object, or the first three items of an array.
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
  /** The same of data that have x, y and r, or are arrays of them. */
  from<Datum extends CircleLike>(
    data: Iterable<Datum>,
    fx?: Accessor<Datum>,
    fy?: Accessor<Datum>,
    fr?: Accessor<Datum>,
    options?: Options,
  ): Diagram
  /**
   * The diagram of `circles`, and all that was done on the way to it: by the touching disc method, by flips (`method: 'auto'`
   * or `'flip'`), or by the option `edits` from the diagram before them.
   *
   * @throws CircleVoronoiError as `compute`, and `DiagramEditor.apply`
   */
  trace(circles: Circles, options?: TraceOptions): Trace
  /**
   * An editor of the diagram of `circles`, or of a diagram's: circle i gets id i. Additive weights cannot be edited.
   *
   * @throws CircleVoronoiError as `compute`; `badArgument`, if it is a diagram with weights or of another metric
   */
  edit(circles: Circles | DiagramData): DiagramEditor
  /**
   * Judges in linear time, with exact signs, whether a diagram is the Voronoi diagram of its `circles`, however it was
   * made; only its typed arrays are looked at. `compute` has done so for its results.
   *
   * @throws CircleVoronoiError if an array has the wrong type or length, or a circle is none.
   */
  certify(diagram: Verifiable): Certificate
  /**
   * Tells in linear time what of a certified diagram is final: the same in the diagram of all circles, whatever others
   * there are outside. A cell is final if it is bounded and the discs of its vertices, widened by `maxRadius`, lie within
   * the box.
   *
   * @throws CircleVoronoiError `badArgument` if the box or the radius is none; `badInput` if an array has the wrong type or
   *   length; `badOption` if the box is empty or the radius negative or not finite.
   */
  finalCells(diagram: Verifiable, known: Known): FinalCells
}

/** The library on a compiled `circle-voronoi.wasm`, with a memory of its own. */
export async function circleVoronoiOf(wasm: CompiledWasm): Promise<CircleVoronoi> {
  const module = await instantiate(createModule, wasm)
  const edit = editorsOf(module)

  const certify = (diagram: Verifiable) => unwrap(module.certify(judgedArrays(diagram)))

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
    new Diagram(dataOf(coordinates, options), (circles) => dataOf(circles, options))

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
    trace(circles, options = {}) {
      checkOptions(options, 'trace', ['edits'])
      const { edits, ...others } = options
      const coordinates = coordinatesOf(circles)
      if (edits !== undefined) {
        const unused = Object.entries(others).find(([, value]) => value !== undefined)
        if (unused !== undefined) refuseOption(`The option ${unused[0]} does not go with edits.`)
        const editor = edit(coordinates)
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
    edit: (circles) => edit(editedCircles(circles)),
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

/** Ends the computation when a callback throws, and keeps what it threw: no exception of JavaScript passes the core. */
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
