// SPDX-License-Identifier: GPL-3.0-or-later
import { checkMemory, checkOptionNames, refuseInput, refuseOption, shown } from '../base/check.ts'
import { CircleVoronoiError } from '../base/errors.ts'
import { missingNumber } from '../base/missing-number.ts'
import type { Float64s } from '../base/types.ts'
import { checkWeights } from './options.ts'
import { type SphereData, SphereDiagram, type SphereModule } from './sphere-diagram.ts'
import { type CompiledWasm, type EmscriptenOptions, instantiate, unwrap, type WasmError } from './wasm.ts'

/**
 * The Earth's mean radius in kilometers.
 *
 * @category Spheres
 * @example
 * EARTH_RADIUS // 6371.0088
 */
export const EARTH_RADIUS = 6371.0088

/**
 * A circle on a sphere: the places within the distance `r` of its center, along the ground.
 *
 * @category Spheres
 */
export interface Cap {
  /** In degrees; any number. */
  readonly longitude: number
  /** In degrees, within 90. */
  readonly latitude: number
  /** Less than half of the sphere's circumference. */
  readonly r: number
}

/**
 * A function that finds a number in a datum.
 *
 * @category Spheres
 */
export type PlaceAccessor<Datum> = (datum: Datum, index: number, data: Iterable<Datum>) => number

/**
 * Options of `computeSphere`.
 *
 * @category Spheres
 */
export interface SphereOptions {
  /**
   * The radius of the sphere, whose unit is that of all lengths. Default: the Earth's mean radius in kilometers,
   * 6371.0088. The Earth is not quite a sphere: distances differ by up to 0.5 %.
   */
  readonly radius?: number | undefined
  /** Whether radii are additive weights, which may be negative. Default: false. */
  readonly weights?: boolean | undefined
}

/**
 * Options for data that are not caps: functions that find the numbers in a datum.
 *
 * @category Spheres
 */
export interface CapAccessors<Datum> {
  readonly longitude: PlaceAccessor<Datum>
  readonly latitude: PlaceAccessor<Datum>
  readonly r: PlaceAccessor<Datum>
}

/**
 * Caps, given as one typed array with longitude, latitude and r of each, or as any iterable of objects or arrays.
 *
 * @category Spheres
 */
export type Caps = Float64Array | Float32Array | Iterable<Cap | ArrayLike<number>>

/**
 * Computes diagrams on a sphere.
 *
 * @category Spheres
 */
export interface Spheres {
  /**
   * Computes the Voronoi diagram of circles on a sphere. Places have a longitude and a latitude in degrees, and radii
   * the unit of the sphere's radius. The circles may be disjoint, intersecting, nested, equal, points, or larger than
   * half of the sphere; one or two are enough.
   *
   * @throws CircleVoronoiError `badInput`, `badOption`, `nonFinite`, `negativeRadius`; `coordinateTooLarge`, if a
   *   latitude is beyond 90 degrees or a radius not below half of the circumference; the other codes of `compute`
   */
  computeSphere(places: Caps, options?: SphereOptions): SphereDiagram
  /**
   * Computes the diagram of circles that functions find in data. Each function is called with a datum, its index and
   * the data.
   *
   * @example
   * const { computeSphere } = await loadSphere()
   * const airports = [{ at: [8.57, 50.03], km: 4 }, { at: [103.99, 1.36], km: 6 }]
   * const fields = { longitude: (d) => d.at[0], latitude: (d) => d.at[1], r: (d) => d.km }
   * computeSphere(airports, fields).find(77.1, 28.6) // 1
   */
  computeSphere<Datum>(data: Iterable<Datum>, options: SphereOptions & CapAccessors<Datum>): SphereDiagram
}

/** The script of the module, as written by Emscripten. */
export type SphereScript = (options: EmscriptenOptions) => Promise<object>

/** The functions of the module beside those of diagrams. */
interface WasmSphereModule extends SphereModule {
  computeSphere(
    caps: Float64Array,
    radius: number,
    weights: boolean,
  ): WasmError | (SphereData & { readonly address: number })
  createGlobe(data: SphereData): WasmError | { readonly address: number }
  deleteGlobe(globe: number): void
}

/** Returns the WebAssembly that this thread loaded last, for a worker. */
export function newestSphereWasm(): CompiledWasm | undefined {
  return newest
}

let newest: CompiledWasm | undefined

/** The checked arguments of `computeSphere`. */
export interface SphereInput {
  readonly caps: Float64s
  readonly radius: number
  readonly weights: boolean
}

/** The functions of a loaded module. */
export interface SpheresOfModule extends Spheres {
  computed(input: SphereInput): SphereDiagram
  /** Takes a diagram that another thread has computed. */
  diagramOf(data: SphereData): SphereDiagram
}

const NAMES = ['radius', 'weights', 'longitude', 'latitude', 'r'] as const

/**
 * Checks the arguments of `computeSphere`, and finds the numbers.
 *
 * @throws CircleVoronoiError `badInput`, `badOption`
 */
export function sphereInput<Datum>(
  places: Caps | Iterable<Datum>,
  options: SphereOptions & Partial<CapAccessors<Datum>>,
  more: readonly string[] = [],
): SphereInput {
  checkOptionNames(options, 'computeSphere', [...NAMES, ...more])
  const { radius = EARTH_RADIUS, weights = false, longitude, latitude, r } = options
  if (typeof radius !== 'number') refuseOption(`The radius of the sphere is a number, not ${shown(radius)}.`)
  checkWeights(weights)
  for (const [name, find] of Object.entries({ longitude, latitude, r })) {
    if (find !== undefined && typeof find !== 'function') refuseOption(`The option ${name} is a function.`)
  }
  return { caps: capsOf(places, [longitude, latitude, r]), radius, weights }
}

const CAP_NAMES = ['longitude', 'latitude', 'r'] as const

type Finders<Datum> = readonly (PlaceAccessor<Datum> | undefined)[]

function capsOf<Datum>(places: Caps | Iterable<Datum>, finders: Finders<Datum>): Float64s {
  checkMemory(places, 'The places', 'their array')
  const isRead = finders.some((find) => find !== undefined)
  if (!isRead && (places instanceof Float64Array || places instanceof Float32Array)) {
    if (places.length % 3 !== 0) refuseInput(`Three numbers per place are needed, but there are ${places.length}.`)
    return new Float64Array(places)
  }
  if (typeof Object(places)[Symbol.iterator] !== 'function' || typeof places === 'string') {
    refuseInput(`The places are neither a typed array nor a list, but ${shown(places)}.`)
  }
  const numbers: number[] = []
  let i = 0
  for (const datum of places as Iterable<Datum>) {
    const parts = CAP_NAMES.map((name, k): unknown => {
      const find = finders[k]
      return find === undefined ? partOf(datum, k, name) : find(datum, i, places as Iterable<Datum>)
    })
    if (!parts.every((part) => typeof part === 'number')) {
      const message = missingNumber(`Cap ${i}`, CAP_NAMES, parts, datum, finders)
      throw new CircleVoronoiError('badInput', message, { circle: i })
    }
    numbers.push(...parts)
    i += 1
  }
  return new Float64Array(numbers)
}

function partOf(datum: unknown, k: number, name: keyof Cap): unknown {
  const record = Object(datum) as Record<string, unknown>
  return name in record || !('length' in record) ? record[name] : record[k]
}

/**
 * Creates the functions for spheres from a module.
 *
 * @throws CircleVoronoiError `notLoaded`
 */
export async function spheresOf(createModule: SphereScript, wasm: CompiledWasm): Promise<SpheresOfModule> {
  const module = (await instantiate(createModule, wasm)) as WasmSphereModule
  newest = wasm
  // Frees the memory of diagrams that are no longer used.
  const globes = new FinalizationRegistry((address: number) => module.deleteGlobe(address))

  const registered = (data: SphereData, address: number) => {
    const diagram = new SphereDiagram(data, module, address)
    globes.register(diagram, address)
    return diagram
  }
  const computed = ({ caps, radius, weights }: SphereInput) => {
    const { address, ...data } = unwrap(module.computeSphere(caps, radius, weights))
    return registered(data, address)
  }
  return {
    computeSphere: <Datum>(
      places: Caps | Iterable<Datum>,
      options: SphereOptions & Partial<CapAccessors<Datum>> = {},
    ) => computed(sphereInput(places, options)),
    computed,
    diagramOf: (data) => registered(data, unwrap(module.createGlobe(data)).address),
  }
}
