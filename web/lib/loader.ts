// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle, Diagram } from './diagram.ts'
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
  /** The error codes of the C++ core, in order; the same as `ERROR_CODES`. */
  errorCodeNames(): readonly string[]
}

/** Loads the WebAssembly module. Works in a page, in a worker and in Node. */
export async function loadCircleVoronoi(options: LoadOptions = {}): Promise<CircleVoronoi> {
  const url = new URL(options.wasmUrl ?? new URL('./generated/circle-voronoi.wasm', import.meta.url))
  const wasmBinary = options.wasmBinary ?? readFromDisk(url)
  const module = await createModule(wasmBinary ? { wasmBinary } : { locateFile: () => url.href })

  return {
    compute(circles, { method, candidates, samples } = {}) {
      const coordinates = flatten(circles)
      checkOptions({ method, candidates, samples })
      const result = module.compute(coordinates, { method, candidates, samples })
      if ('error' in result) {
        const { code, circle, message } = result.error
        throw new CircleVoronoiError(code as ErrorCode, circle, message)
      }
      return { circles: coordinates, ...result }
    },
    errorCodeNames: () => module.errorCodeNames(),
  }
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

function checkOptions({ method, candidates, samples }: { [Name in keyof Options]: unknown }): void {
  const isText = (value: unknown) => value === undefined || typeof value === 'string'
  if (!isText(method) || !isText(candidates)) {
    throw new CircleVoronoiError('badOption', -1, 'The options method and candidates are strings.')
  }
  if (samples !== undefined && !(Number.isInteger(samples) && Math.abs(samples as number) < 2 ** 31)) {
    throw new CircleVoronoiError('badOption', -1, 'The option samples is a whole number.')
  }
}
