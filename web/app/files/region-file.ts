// SPDX-License-Identifier: GPL-3.0-or-later
import { isRecord } from '../../lib/base/check.ts'
import type { RegionShape } from '../../lib/regions/region-shape.ts'
import { isRegionText, readRegion, regionOfJson } from '../../view/region-text.ts'

/** Number of bytes that decide whether a file may contain polygons. */
const HEAD = 4096
const GEOJSON = /"type"\s*:\s*"(FeatureCollection|Feature|GeometryCollection|(Multi)?Polygon)"/
const RINGS = /^\s*\[\s*\[\s*[[{]/

/** Converts parsed text to a region. @throws CircleVoronoiError as `readRegion` */
export type ReadsRegion = () => RegionShape

/** The region in a file. */
export interface FoundRegion {
  readonly read: ReadsRegion
  /** The indices of the features that are the region, if the others are circles. */
  readonly polygons: readonly number[] | undefined
}

/** The region of a file with polygons; `undefined` for other files. */
export async function regionOfFile(file: Blob): Promise<FoundRegion | undefined> {
  if (file.type.startsWith('image/')) return undefined
  return mayBeRegion(await file.slice(0, HEAD).text()) ? regionOfText(await file.text()) : undefined
}

/** The region of a text, as in `regionOfFile`. JSON is parsed once. */
export function regionOfText(text: string): FoundRegion | undefined {
  if (!mayBeRegion(text.slice(0, HEAD))) return undefined
  if (!/^\s*[[{]/.test(text)) return { read: () => readRegion(text), polygons: undefined }
  try {
    const shape: unknown = JSON.parse(text)
    const types = typesIn(shape)
    const hasAny = (end: string) => types.some((type) => type.endsWith(end))
    if (!Array.isArray(shape) && !hasAny('Polygon')) return undefined
    const read = () => regionOfJson(shape)
    if (!hasAny('Point')) return { read, polygons: undefined }
    const features: unknown = isRecord(shape) ? shape.features : undefined
    // Points elsewhere are no circles of the readers, which report them.
    if (!Array.isArray(features)) return undefined
    const isPolygon = (feature: unknown) => {
      const types = typesIn(feature)
      return types.some((type) => type.endsWith('Polygon')) && !types.some((type) => type.endsWith('Point'))
    }
    return { read, polygons: features.flatMap((feature, k) => (isPolygon(feature) ? [k] : [])) }
  } catch {
    // The readers of circles report the error.
    return undefined
  }
}

function mayBeRegion(head: string): boolean {
  return /^\s*[[{]/.test(head) ? GEOJSON.test(head) || RINGS.test(head) : isRegionText(head)
}

/** The types of the geometries of a GeoJSON object. */
function typesIn(shape: unknown): string[] {
  if (!isRecord(shape)) return []
  if (Array.isArray(shape.features)) return shape.features.flatMap(typesIn)
  if (Array.isArray(shape.geometries)) return shape.geometries.flatMap(typesIn)
  return shape.type === 'Feature' ? typesIn(shape.geometry) : [String(shape.type)]
}
