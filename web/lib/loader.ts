// SPDX-License-Identifier: GPL-3.0-or-later
import { Diagram } from './diagram.ts'
import type { Certificate, Circle, DiagramData } from './diagram-data.ts'
import { CircleVoronoiError, type ErrorCode } from './errors.ts'
import createModule from './generated/circle-voronoi.js'

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
  /** `dynamic`: if the diagram is not certified, take more samples around what is wrong and try again. Default: false. */
  readonly repair?: boolean
}

export interface LoadOptions {
  /** Where circle-voronoi.wasm is. Default: beside the module. */
  readonly wasmUrl?: string | URL
  /** The bytes of circle-voronoi.wasm, for an environment without fetch or files. */
  readonly wasmBinary?: Uint8Array
}

export interface CircleVoronoi {
  /**
   * The Voronoi diagram of `circles`: x, y, r of each in one `Float64Array`, or objects. They may be disjoint,
   * intersecting, tangent, nested, equal or points, in any position, and any number from 0. The input is copied.
   *
   * @throws CircleVoronoiError with one of the codes of `ErrorCode`.
   */
  compute(circles: Float64Array | readonly Circle[], options?: Options): Diagram
  /**
   * Judges in linear time, with exact signs, whether a diagram is the Voronoi diagram of its `circles`, however it was
   * made; only its typed arrays are looked at.
   *
   * @throws CircleVoronoiError if an array has the wrong type or length, or a circle is none.
   */
  certify(diagram: Omit<DiagramData, 'metric' | 'certificate' | 'stats'>): Certificate
  /** The error codes of the C++ core, in order; the same as `ERROR_CODES`. */
  errorCodeNames(): readonly string[]
}

/** Loads the WebAssembly module. Works in a page, in a worker and in Node. */
export async function loadCircleVoronoi(options: LoadOptions = {}): Promise<CircleVoronoi> {
  const url = new URL(options.wasmUrl ?? new URL('./generated/circle-voronoi.wasm', import.meta.url))
  const wasmBinary = options.wasmBinary ?? readFromDisk(url)
  const module = await createModule(wasmBinary ? { wasmBinary } : { locateFile: () => url.href })

  return {
    compute(circles, { method, candidates, samples, repair } = {}) {
      const coordinates = flatten(circles)
      checkOptions({ method, candidates, samples, repair })
      const result = unwrap(module.compute(coordinates, { method, candidates, samples, repair }))
      return new Diagram({ metric: 'circles', circles: coordinates, ...result })
    },
    certify({ circles, vertices, vertexCircles, edges, hidden, hull }) {
      checkArray('circles', circles, Float64Array, 3)
      checkArray('vertices', vertices, Float64Array, 3)
      checkArray('vertexCircles', vertexCircles, Int32Array, 3)
      checkArray('edges', edges, Int32Array, 4)
      checkArray('hidden', hidden, Int32Array, 2)
      checkArray('hull', hull, Int32Array, 1)
      return unwrap(module.certify({ circles, vertices, vertexCircles, edges, hidden, hull }))
    },
    errorCodeNames: () => module.errorCodeNames(),
  }
}

/** A result of the module, or its error thrown. */
function unwrap<Value extends object>(result: Value | WasmError): Value {
  if (!('error' in result)) return result
  const { code, circle, message } = result.error
  throw new CircleVoronoiError(code as ErrorCode, circle, message)
}

/** Node's fetch does not read files. */
function readFromDisk(url: URL): Uint8Array | undefined {
  if (url.protocol !== 'file:') return undefined
  // Not an import, so that no bundler looks for node:fs in a page.
  return globalThis.process?.getBuiltinModule?.('node:fs').readFileSync(url)
}

/** A copy of the circles as x, y, r. embind converts whatever it is given, so types are checked here. */
function flatten(circles: Float64Array | readonly Circle[]): Float64Array {
  if (circles instanceof Float64Array) {
    if (circles.length % 3 !== 0) {
      throw new CircleVoronoiError(
        'badInput',
        -1,
        `Three numbers per circle are needed, but there are ${circles.length}.`,
      )
    }
    return circles.slice()
  }
  if (!Array.isArray(circles)) {
    throw new CircleVoronoiError('badInput', -1, 'The circles are neither a Float64Array nor an array.')
  }
  const flat = new Float64Array(3 * circles.length)
  circles.forEach((circle: Partial<Circle> | null, i) => {
    const { x, y, r } = circle ?? {}
    if (typeof x !== 'number' || typeof y !== 'number' || typeof r !== 'number') {
      throw new CircleVoronoiError('badInput', i, `Circle ${i} does not have three numbers x, y and r.`)
    }
    flat.set([x, y, r], 3 * i)
  })
  return flat
}

function checkOptions({ method, candidates, samples, repair }: { [Name in keyof Options]: unknown }): void {
  const isText = (value: unknown) => value === undefined || typeof value === 'string'
  if (!isText(method) || !isText(candidates)) {
    throw new CircleVoronoiError('badOption', -1, 'The options method and candidates are strings.')
  }
  if (samples !== undefined && !(Number.isInteger(samples) && Math.abs(samples as number) < 2 ** 31)) {
    throw new CircleVoronoiError('badOption', -1, 'The option samples is a whole number.')
  }
  if (repair !== undefined && typeof repair !== 'boolean') {
    throw new CircleVoronoiError('badOption', -1, 'The option repair is true or false.')
  }
}

function checkArray(
  name: string,
  array: unknown,
  type: Float64ArrayConstructor | Int32ArrayConstructor,
  size: number,
): void {
  if (array instanceof type && array.length % size === 0) return
  throw new CircleVoronoiError('badInput', -1, `${name} is not an ${type.name} of ${size} numbers each.`)
}
