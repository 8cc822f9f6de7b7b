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

/** The region of a file with polygons and without points, which are circles; `undefined` for other files. */
export async function regionOfFile(file: Blob): Promise<ReadsRegion | undefined> {
  if (file.type.startsWith('image/')) return undefined
  return mayBeRegion(await file.slice(0, HEAD).text()) ? regionOfText(await file.text()) : undefined
}

/** The region of a text, as in `regionOfFile`. JSON is parsed once. */
export function regionOfText(text: string): ReadsRegion | undefined {
  if (!mayBeRegion(text.slice(0, HEAD))) return undefined
  if (!/^\s*[[{]/.test(text)) return () => readRegion(text)
  try {
    const shape: unknown = JSON.parse(text)
    const types = typesIn(shape)
    const hasAny = (end: string) => types.some((type) => type.endsWith(end))
    const isRegion = Array.isArray(shape) || (hasAny('Polygon') && !hasAny('Point'))
    return isRegion ? () => regionOfJson(shape) : undefined
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
