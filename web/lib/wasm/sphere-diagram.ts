// SPDX-License-Identifier: GPL-3.0-or-later
import { checkIndex, checkNoOptions, checkOptionNames, refuseInput, refuseOption, shown } from '../base/check.ts'
import { at, NONE } from '../base/diagram-data.ts'
import type { Float64s, Int32s } from '../base/types.ts'
import { type MultiPolygon, multiPolygonOf } from '../drawing/draw-clipped.ts'
import type { ClosestPair } from '../queries/queries.ts'
import type { ClippedPolygons } from '../regions/region.ts'
import { unwrap } from './wasm.ts'

/**
 * The arrays of a diagram on a sphere. Indices are those of the given circles, which are called caps.
 *
 * @category Spheres
 */
export interface SphereData {
  /** The radius of the sphere, in the unit of all lengths. */
  readonly radius: number
  /** Whether radii of caps are additive weights. */
  readonly weights: boolean
  /** The diagram is proven for caps that differ from the given ones by at most this length, in place and radius. */
  readonly rounding: number
  /** Longitude, latitude and radius of each cap. */
  readonly caps: Float64s
  /** Longitude and latitude of each vertex, and its distance from its three caps. */
  readonly vertices: Float64s
  /** The three caps of each vertex, counter-clockwise as seen from outside. */
  readonly vertexCaps: Int32s
  /**
   * The caps on the left and on the right of each edge, and its first and its last vertex, `NONE` for the border between
   * the only two caps.
   */
  readonly edges: Int32s
  /** The caps without a cell, each with a cap that contains it. */
  readonly hidden: Int32s
  /** The side after each side of a cell. Side 2 e is on the left of edge e, side 2 e + 1 on its right. */
  readonly nextSide: Int32s
  /** For each vertex the sides that begin there. */
  readonly vertexSides: Int32s
  /** One side of each cap, `NONE` without a cell or if the cell is the whole sphere. */
  readonly firstSide: Int32s
}

/**
 * Options of cells on a sphere.
 *
 * @category Spheres
 */
export interface SphereCellOptions {
  /** Cells are cut at this distance from their caps. */
  readonly maxDistance?: number | undefined
}

/**
 * Options of polygons on a sphere.
 *
 * @category Spheres
 */
export interface SpherePolygonOptions extends SphereCellOptions {
  /**
   * The largest distance between polygons and true borders, along the ground. Default: a hundred-thousandth of the
   * sphere's radius, 64 m on the Earth.
   */
  readonly tolerance?: number | undefined
}

/**
 * The place that is farthest from all caps.
 *
 * @category Spheres
 */
export interface FarthestPlace {
  readonly longitude: number
  readonly latitude: number
  /** The distance from the nearest caps, negative if the caps cover the sphere. */
  readonly distance: number
  /** The nearest caps, up to three. */
  readonly caps: readonly number[]
}

/**
 * The cells of a sphere as a GeoJSON FeatureCollection.
 *
 * @category Spheres
 */
export interface CellCollection {
  readonly type: 'FeatureCollection'
  readonly features: readonly {
    readonly type: 'Feature'
    readonly properties: Record<string, unknown>
    readonly geometry: { readonly type: 'MultiPolygon'; readonly coordinates: MultiPolygon } | null
  }[]
}

/** The functions of the module that answer questions about a diagram in its memory. */
export interface SphereModule {
  findCap(globe: number, longitude: number, latitude: number): number
  distanceFromCap(globe: number, cap: number, longitude: number, latitude: number): number
  neighborsOfCap(globe: number, cap: number): WasmError | Int32Array
  areasOfCaps(globe: number, maxDistance: number | undefined): WasmError | Float64Array
  perimetersOfCaps(globe: number, maxDistance: number | undefined): WasmError | Float64Array
  polygonsOfCaps(
    globe: number,
    tolerance: number | undefined,
    maxDistance: number | undefined,
  ): WasmError | ClippedPolygons
  farthestPlace(globe: number): WasmError | { readonly place: Float64Array; readonly caps: Int32Array }
  closestPair(globe: number): WasmError | ClosestPair | undefined
}

type WasmError = import('./wasm.ts').WasmError

/**
 * The Voronoi diagram of circles on a sphere: a place belongs to the circle with the smallest distance along the ground
 * to its center, minus its radius. Lengths are in the unit of `radius`, angles in degrees. The diagram is proven.
 *
 * The methods do not read the arrays, and changes of the arrays have no effect on them. All methods throw a
 * `CircleVoronoiError`: `badOption` for options that make no sense, `badInput` for other arguments.
 *
 * @category Spheres
 * @example
 * const { computeSphere } = await loadSphere()
 * const cities = computeSphere([[-134.42, 58.3, 0], [30.31, 59.94, 0], [144.96, -37.81, 0]])
 * cities.find(115.9, -31.9) // 2
 * Math.round(cities.cellArea(0)) // 140477737
 */
export class SphereDiagram implements SphereData {
  readonly radius: number
  readonly weights: boolean
  readonly rounding: number
  readonly caps: Float64s
  readonly vertices: Float64s
  readonly vertexCaps: Int32s
  readonly edges: Int32s
  readonly hidden: Int32s
  readonly nextSide: Int32s
  readonly vertexSides: Int32s
  readonly firstSide: Int32s
  readonly #module: SphereModule
  readonly #globe: number
  #areas: Measured<Float64Array> | undefined
  #perimeters: Measured<Float64Array> | undefined
  #polygons: Measured<ClippedPolygons> | undefined

  /** `computeSphere` makes diagrams. `globe` is the diagram in the memory of `module`. */
  constructor(data: SphereData, module: SphereModule, globe: number) {
    this.radius = data.radius
    this.weights = data.weights
    this.rounding = data.rounding
    this.caps = data.caps
    this.vertices = data.vertices
    this.vertexCaps = data.vertexCaps
    this.edges = data.edges
    this.hidden = data.hidden
    this.nextSide = data.nextSide
    this.vertexSides = data.vertexSides
    this.firstSide = data.firstSide
    this.#module = module
    this.#globe = globe
  }

  /**
   * Returns the nearest cap of a place, one of them if several are equally near up to rounding, and `NONE` if there are
   * no caps. Any number is a longitude. Takes few steps, however many caps there are.
   */
  find(longitude: number, latitude: number): number {
    checkPlace(longitude, latitude, 'find')
    return this.#module.findCap(this.#globe, longitude, latitude)
  }

  /** Returns the distance of a place from a cap: along the ground to its center, minus its radius. */
  distanceFrom(cap: number, longitude: number, latitude: number): number {
    this.#checkCap(cap, 'distanceFrom')
    checkPlace(longitude, latitude, 'distanceFrom')
    return this.#module.distanceFromCap(this.#globe, cap, longitude, latitude)
  }

  /**
   * Returns the caps across the sides of a cell, counter-clockwise. A cap recurs if the two cells share several edges.
   */
  neighbors(cap: number): Int32Array
  neighbors(cap: number, ...others: readonly unknown[]): Int32Array {
    checkNoOptions(others, 'neighbors')
    this.#checkCap(cap, 'neighbors')
    return unwrap(this.#module.neighborsOfCap(this.#globe, cap))
  }

  /** Returns the area of a cell, or of its part within `maxDistance`; 0 for a hidden cap. */
  cellArea(cap: number, options: SphereCellOptions = {}): number {
    this.#checkCap(cap, 'cellArea')
    return at(this.#areasWith(options, 'cellArea'), cap)
  }

  /** Returns the areas of all cells, which sum to that of the sphere. */
  cellAreas(options: SphereCellOptions = {}): Float64Array {
    return this.#areasWith(options, 'cellAreas').slice()
  }

  /** Returns the length of the border of a cell, or of its part within `maxDistance`. */
  cellPerimeter(cap: number, options: SphereCellOptions = {}): number {
    this.#checkCap(cap, 'cellPerimeter')
    return at(this.#perimetersWith(options, 'cellPerimeter'), cap)
  }

  /** Returns the lengths of the borders of all cells. */
  cellPerimeters(options: SphereCellOptions = {}): Float64Array {
    return this.#perimetersWith(options, 'cellPerimeters').slice()
  }

  /**
   * Returns the polygons of a cell as the coordinates of a GeoJSON MultiPolygon (RFC 7946): longitudes and latitudes,
   * cut at the antimeridian, with a pole inside where it is. Returns `undefined` for a hidden cap, and if `maxDistance`
   * leaves nothing. Neighbors share their points. The polygons of all cells are computed at once, and kept until the
   * options change.
   */
  cellPolygon(cap: number, options: SpherePolygonOptions = {}): MultiPolygon | undefined {
    this.#checkCap(cap, 'cellPolygon')
    return multiPolygonOf(this.#polygonsWith(options, 'cellPolygon'), cap)
  }

  /**
   * Returns the cells as a GeoJSON FeatureCollection. The properties are `circle`, `r`, `area`, `neighbors`, and for
   * hidden caps `hiddenBy`. The geometry is a MultiPolygon, or `null` without a cell.
   */
  toGeoJSON(options: SpherePolygonOptions = {}): CellCollection {
    const polygons = this.#polygonsWith(options, 'toGeoJSON')
    const areas = this.cellAreas({ maxDistance: options.maxDistance })
    const hiders = new Map<number, number>()
    for (let k = 0; k < this.hidden.length; k += 2) hiders.set(at(this.hidden, k), at(this.hidden, k + 1))
    const features = Array.from(areas, (area, circle) => {
      const hiddenBy = hiders.get(circle)
      const coordinates = multiPolygonOf(polygons, circle)
      return {
        type: 'Feature' as const,
        properties: {
          circle,
          r: at(this.caps, 3 * circle + 2),
          area,
          neighbors: [...this.neighbors(circle)],
          ...(hiddenBy === undefined ? {} : { hiddenBy }),
        },
        geometry: coordinates === undefined ? null : { type: 'MultiPolygon' as const, coordinates },
      }
    })
    return { type: 'FeatureCollection', features }
  }

  /**
   * Returns the place that is farthest from all caps: the center of the largest disc that overlaps none. Returns
   * `undefined` if there are no caps.
   */
  farthestPlace(): FarthestPlace | undefined {
    const { place, caps } = unwrap(this.#module.farthestPlace(this.#globe))
    if (place.length === 0) return undefined
    const [longitude, latitude, distance] = place as unknown as [number, number, number]
    return { longitude, latitude, distance, caps: Array.from(caps).filter((cap) => cap !== NONE) }
  }

  /** Returns the two visible caps with the smallest gap; `undefined` if fewer than two are visible. */
  closestPair(): ClosestPair | undefined {
    const pair = this.#module.closestPair(this.#globe)
    return pair && unwrap(pair)
  }

  #areasWith(options: SphereCellOptions, caller: string): Float64Array {
    const maxDistance = distanceIn(options, caller)
    this.#areas = kept(this.#areas, [maxDistance], () => this.#module.areasOfCaps(this.#globe, maxDistance))
    return this.#areas.value
  }

  #perimetersWith(options: SphereCellOptions, caller: string): Float64Array {
    const maxDistance = distanceIn(options, caller)
    const measure = () => this.#module.perimetersOfCaps(this.#globe, maxDistance)
    this.#perimeters = kept(this.#perimeters, [maxDistance], measure)
    return this.#perimeters.value
  }

  #polygonsWith(options: SpherePolygonOptions, caller: string): ClippedPolygons {
    const maxDistance = distanceIn(options, caller, ['tolerance'])
    const { tolerance } = options
    if (tolerance !== undefined && typeof tolerance !== 'number') {
      refuseOption(`The tolerance is a finite number above 0, not ${shown(tolerance)}.`)
    }
    const draw = () => this.#module.polygonsOfCaps(this.#globe, tolerance, maxDistance)
    this.#polygons = kept(this.#polygons, [tolerance, maxDistance], draw)
    return this.#polygons.value
  }

  #checkCap(cap: number, caller: string): void {
    checkIndex(cap, this.caps.length / 3, caller, 'cap')
  }
}

/** A result with the options that it was made for. */
interface Measured<Value> {
  readonly options: readonly (number | undefined)[]
  readonly value: Value
}

/** Returns the last result, or a new one for other options. */
function kept<Value extends object>(
  last: Measured<Value> | undefined,
  options: Measured<Value>['options'],
  make: () => Value | WasmError,
): Measured<Value> {
  if (last?.options.every((option, k) => Object.is(option, options[k]))) return last
  return { options, value: unwrap(make()) }
}

function distanceIn(options: SphereCellOptions, caller: string, more: readonly string[] = []): number | undefined {
  checkOptionNames(options, caller, ['maxDistance', ...more])
  const { maxDistance } = options
  if (maxDistance !== undefined && !Number.isFinite(maxDistance)) {
    refuseOption(`The maximum distance is a finite number, not ${shown(maxDistance)}.`)
  }
  return maxDistance
}

function checkPlace(longitude: number, latitude: number, caller: string): void {
  if (!Number.isFinite(longitude) || !Number.isFinite(latitude) || Math.abs(latitude) > 90) {
    refuseInput(
      `${caller} takes a longitude and a latitude within 90 degrees, not ${shown(longitude)} and ${shown(latitude)}.`,
    )
  }
}
