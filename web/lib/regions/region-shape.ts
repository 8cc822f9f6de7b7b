// SPDX-License-Identifier: GPL-3.0-or-later
import { refuseOption, shown } from '../base/check.ts'
import { at } from '../base/diagram-data.ts'
import type { Float64s, Int32s, Point } from '../base/types.ts'

/**
 * A ring: its points in order. The last one may repeat the first one.
 *
 * @category Regions
 */
export type RingShape = readonly (readonly number[] | Point)[]

/**
 * The sources of a region: GeoJSON (a `Polygon`, `MultiPolygon`, `GeometryCollection`, `Feature` or
 * `FeatureCollection`), or a list of rings of points `[x, y]` or `{ x, y }`. Rings run in either direction, and the
 * last point may repeat the first one. In a list of rings, a ring inside another ring is a hole. A `MultiPolygon` with
 * the member `dissolve` is the union of its polygons, as with the option of this name.
 *
 * @category Regions
 */
export type RegionShape =
  | { readonly type: 'Polygon'; readonly coordinates: readonly RingShape[] }
  | {
      readonly type: 'MultiPolygon'
      readonly coordinates: readonly (readonly RingShape[])[]
      readonly dissolve?: true | undefined
    }
  | { readonly type: 'GeometryCollection'; readonly geometries: readonly RegionShape[] }
  | { readonly type: 'Feature'; readonly geometry: RegionShape | null }
  | { readonly type: 'FeatureCollection'; readonly features: readonly RegionShape[] }
  | readonly RingShape[]

/** Rings in flat arrays. Without `polygonOffsets` they belong to no polygon yet. */
export interface RingArrays {
  readonly points: Float64s
  readonly ringOffsets: Int32s
  readonly polygonOffsets: Int32s | undefined
}

/** @throws CircleVoronoiError `badOption`, if it is none. The shape of the rings is not checked. */
export function ringArraysOf(shape: RegionShape): RingArrays {
  const isList = isRingList(shape)
  const polygons = isList ? [shape] : polygonsOf(shape)
  const points: number[] = []
  const ringOffsets = [0]
  const polygonOffsets = [0]
  for (const rings of polygons) {
    if (!Array.isArray(rings)) refuseOption(`A polygon of the region is a list of rings, not ${shown(rings)}.`)
    for (const ring of rings) {
      const which = `Ring ${ringOffsets.length - 1} of the region`
      if (!Array.isArray(ring)) refuseOption(`${which} is a list of points, not ${shown(ring)}.`)
      ring.forEach((position: unknown, k: number) => {
        const [x, y] = Array.isArray(position) ? position : [Object(position).x, Object(position).y]
        if (typeof x !== 'number' || typeof y !== 'number') {
          refuseOption(`${which}: point ${k} does not have two numbers x and y.`)
        }
        points.push(x, y)
      })
      ringOffsets.push(points.length / 2)
    }
    polygonOffsets.push(ringOffsets.length - 1)
  }
  return {
    points: Float64Array.from(points),
    ringOffsets: Int32Array.from(ringOffsets),
    polygonOffsets: isList ? undefined : Int32Array.from(polygonOffsets),
  }
}

/** Whether a region is the union of its polygons, which may overlap. */
export function isDissolved(shape: RegionShape): boolean {
  return !isRingList(shape) && shape?.type === 'MultiPolygon' && shape.dissolve === true
}

/**
 * Copies a region to plain data: a list of rings, or a MultiPolygon. With `dissolve`, overlapping polygons are merged,
 * and the result is always a MultiPolygon. A list of rings is then one polygon, in which a ring inside another ring is
 * a hole.
 *
 * @throws CircleVoronoiError `badOption`, if it is none. The shape of the rings is not checked.
 */
export function plainRegion(shape: RegionShape, dissolve: boolean = isDissolved(shape)): RegionShape {
  const { points, ringOffsets, polygonOffsets } = ringArraysOf(shape)
  const parts =
    <Part>(offsets: Int32Array, part: (k: number) => Part) =>
    (k: number) =>
      Array.from({ length: at(offsets, k + 1) - at(offsets, k) }, (_, i) => part(at(offsets, k) + i))
  const ringAt = parts(ringOffsets, (k) => [at(points, 2 * k), at(points, 2 * k + 1)])
  const rings = () => Array.from({ length: ringOffsets.length - 1 }, (_, k) => ringAt(k))
  if (polygonOffsets === undefined) {
    return dissolve ? { type: 'MultiPolygon', coordinates: [rings()], dissolve } : rings()
  }
  const polygonAt = parts(polygonOffsets, ringAt)
  const coordinates = Array.from({ length: polygonOffsets.length - 1 }, (_, k) => polygonAt(k))
  return { type: 'MultiPolygon', coordinates, ...(dissolve && { dissolve }) }
}

function isRingList(shape: RegionShape): shape is readonly RingShape[] {
  return Array.isArray(shape)
}

/** The largest nesting depth of GeoJSON objects, because each level uses the stack. */
const MOST_NESTED = 100

function polygonsOf(shape: Exclude<RegionShape, readonly RingShape[]>, depth = 0): (readonly RingShape[])[] {
  if (depth === MOST_NESTED) {
    refuseOption(`The geometries and collections of the region are nested more than ${MOST_NESTED} deep.`)
  }
  const { type }: { type?: unknown } = Object(shape)
  const parts = (list: unknown): (readonly RingShape[])[] => {
    if (!Array.isArray(list)) refuseOption(`The ${type} of the region has no list of its parts.`)
    return list.flatMap((part) => polygonsOf(part, depth + 1))
  }
  switch (shape?.type) {
    case 'Polygon':
      return [shape.coordinates]
    case 'MultiPolygon':
      if (!Array.isArray(shape.coordinates)) refuseOption('The MultiPolygon of the region has no coordinates.')
      return [...shape.coordinates]
    case 'GeometryCollection':
      return parts(shape.geometries)
    case 'FeatureCollection':
      return parts(shape.features)
    case 'Feature':
      // A feature may have no geometry.
      return shape.geometry === null ? [] : polygonsOf(shape.geometry as typeof shape, depth + 1)
  }
  const what = typeof type === 'string' ? `a GeoJSON ${type}` : shown(shape)
  refuseOption(`A region is made of GeoJSON polygons or a list of rings, not ${what}.`)
}
