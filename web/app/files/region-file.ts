// SPDX-License-Identifier: GPL-3.0-or-later
import { isRecord } from '../../lib/base/check.ts'
import type { RegionShape } from '../../lib/regions/region-shape.ts'
import { isRegionText, readRegion, regionOfJson } from '../../view/region-text.ts'

/** So much of a file says whether it may be one of polygons, in bytes. */
const HEAD = 4096
const GEOJSON = /"type"\s*:\s*"(FeatureCollection|Feature|GeometryCollection|(Multi)?Polygon)"/
const RINGS = /^\s*\[\s*\[\s*[[{]/

/** Reads a region from what was parsed. @throws CircleVoronoiError as `readRegion` */
export type ReadsRegion = () => RegionShape

/** The region of a file that has polygons and no points, which are circles; `undefined`: it has none. */
export async function regionOfFile(file: Blob): Promise<ReadsRegion | undefined> {
  if (file.type.startsWith('image/')) return undefined
  return mayBeRegion(await file.slice(0, HEAD).text()) ? regionOfText(await file.text()) : undefined
}

/** The same of a text. JSON is parsed once. */
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
    // Readers say what is wrong with it.
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
