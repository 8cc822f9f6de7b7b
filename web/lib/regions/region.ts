// SPDX-License-Identifier: GPL-3.0-or-later
import { checkNumber, refuseOption, shown } from '../base/check.ts'
import type { Box, DiagramData, Float64s, Int32s, Point, Vertex } from '../base/types.ts'

/** A diagram clipped to a region by the WebAssembly module for regions. Row i belongs to circle i. */
export interface ClippedDiagram {
  readonly cells: ClippedCells
  readonly edges: ClippedEdges
  readonly areas: Float64Array
  readonly centroids: Float64Array
  readonly perimeters: Float64Array
  polygons(tolerance: number): ClippedPolygons
  /** The largest disc with its center in the region that overlaps no circle, and the circles that it touches. */
  largestEmptyDisc(): { readonly disc: Vertex; readonly circles: readonly number[] } | undefined
  /** The largest disc in the region that overlaps no circle. */
  largestEmptyDiscInside(): { readonly disc: Vertex; readonly circles: readonly number[] } | undefined
  /** The clearest path between two points of the region; `undefined` between different parts. */
  clearestPath(p: Point, q: Point): ClippedPath | undefined
}

/** A path, with its curves in flat arrays. */
export interface ClippedPath {
  readonly clearance: number
  readonly edges: Int32Array
  /** x and y of the entry and of the exit. */
  readonly ends: Float64Array
  /** The edge of each curve, or `NONE` for a straight one on no edge. */
  readonly curveEdges: Int32Array
  /** For each curve whether it runs in the direction of its edge. */
  readonly isForward: Uint8Array
  /** For each curve both parameters, and x and y of the start and the end. */
  readonly numbers: Float64Array
}

/**
 * The loops of cells, row by row. `loopOffsets` has the first loop of each row, and `pieceOffsets` the first piece of
 * each loop. A piece ends where the next piece of its loop starts.
 */
export interface ClippedCells {
  readonly loopOffsets: Int32s
  readonly isHole: Uint8Array
  readonly pieceOffsets: Int32s
  readonly x: Float64s
  readonly y: Float64s
  readonly side: Int32s
  readonly regionSide: Int32s
  readonly r: Float64s
}

/** Parts of edges, in increasing order of edges. `start` and `end` have x and y of each part. */
export interface ClippedEdges {
  readonly edge: Int32s
  readonly from: Float64s
  readonly to: Float64s
  readonly start: Float64s
  readonly end: Float64s
  readonly startSide: Int32s
  readonly endSide: Int32s
}

/** Polygons by row, rings by polygon, points by ring. */
export interface ClippedPolygons {
  readonly polygonOffsets: Int32s
  readonly ringOffsets: Int32s
  readonly pointOffsets: Int32s
  readonly points: Float64s
}

/** The functions of the module that a region calls. */
export interface RegionModule {
  contains(x: number, y: number): boolean
  clip(diagram: DiagramData, maxDistance: number | undefined): ClippedDiagram
  /**
   * Clips one cell that has sides; the result has one row. Returns `undefined` if the cell cannot be clipped without
   * all others.
   */
  clipCell(diagram: DiagramData, circle: number, maxDistance: number | undefined): ClippedCells | undefined
  /** Clips a counter-clockwise convex polygon; row 0 has the result. Returns `undefined` if the polygon has no area. */
  clipConvex(corners: readonly Point[]): ClippedPolygons | undefined
}

/**
 * A region to clip to: one or more polygons with holes. `Regions.region` makes it and checks it once; it can be used for
 * many diagrams. Pass it as the option `region` in place of `bounds`.
 *
 * @category Regions
 * @example
 * const { region } = await loadRegions()
 * const hall = region([[[0, 0], [9, 0], [9, 9], [0, 9]], [[3, 3], [6, 3], [6, 6], [3, 6]]])
 * hall.area // 72
 * hall.contains(4, 4) // false
 */
export class Region {
  /** The points of all rings, x and y of each, without repetitions. */
  readonly points: Float64s
  /** The index of the first point of each ring, and the number of points. */
  readonly ringOffsets: Int32s
  /**
   * The index of the first ring of each polygon, and the number of rings. The first ring of a polygon is its outer
   * ring.
   */
  readonly polygonOffsets: Int32s
  readonly area: number
  /** The total length of all rings. */
  readonly perimeter: number
  /** The bounding box. */
  readonly box: Box
  readonly #module: RegionModule

  /** @internal `Regions.region` makes regions. */
  constructor(
    arrays: Pick<Region, 'points' | 'ringOffsets' | 'polygonOffsets' | 'area' | 'perimeter'>,
    module: RegionModule,
  ) {
    this.points = arrays.points
    this.ringOffsets = arrays.ringOffsets
    this.polygonOffsets = arrays.polygonOffsets
    this.area = arrays.area
    this.perimeter = arrays.perimeter
    const [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity]
    const box = { minX, minY, maxX, maxY }
    for (let k = 0; k < this.points.length; k += 2) {
      const [x, y] = this.points.subarray(k, k + 2) as unknown as [number, number]
      box.minX = Math.min(box.minX, x)
      box.minY = Math.min(box.minY, y)
      box.maxX = Math.max(box.maxX, x)
      box.maxY = Math.max(box.maxY, y)
    }
    this.box = box
    this.#module = module
  }

  /**
   * Returns whether a point lies inside or on the boundary. The point is rounded like the corners of the region; the
   * result is exact.
   */
  contains(x: number, y: number): boolean {
    checkNumber(x, 'contains', 'x')
    checkNumber(y, 'contains', 'y')
    return this.#module.contains(x, y)
  }

  /** @internal The module that clips diagrams, for the methods of `Diagram`. */
  get module(): RegionModule {
    return this.#module
  }
}

/**
 * Returns the region of the options; `undefined` if they have none.
 *
 * @throws CircleVoronoiError `badOption`, if `region` is not a `Region`, or there are also `bounds`
 */
export function regionOption(options: { readonly region?: unknown; readonly bounds?: unknown }, caller: string) {
  const { region, bounds } = options
  if (region === undefined) return undefined
  if (!(region instanceof Region)) {
    refuseOption(`The region of ${caller} is made by loadRegions().region, not ${shown(region)}.`)
  }
  if (bounds !== undefined) refuseOption(`${caller} takes bounds or a region, not both.`)
  return region
}
