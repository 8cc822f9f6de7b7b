// SPDX-License-Identifier: GPL-3.0-or-later
import { isRecord } from '../../lib/base/check.ts'
import { isRegionText } from '../../view/region-text.ts'

/** So much of a file says whether it may be one of polygons, in bytes. */
const HEAD = 4096
const GEOJSON = /"type"\s*:\s*"(FeatureCollection|Feature|GeometryCollection|(Multi)?Polygon)"/
const RINGS = /^\s*\[\s*\[\s*[[{]/

/** Whether a file has polygons, and no points: those are circles. */
export async function isRegionFile(file: File): Promise<boolean> {
  if (file.type.startsWith('image/')) return false
  return mayBeRegion(await file.slice(0, HEAD).text()) && isRegion(await file.text())
}

/** The same of a text. */
export function isRegion(text: string): boolean {
  if (!mayBeRegion(text.slice(0, HEAD))) return false
  if (!/^\s*[[{]/.test(text)) return true
  try {
    const shape: unknown = JSON.parse(text)
    const types = typesIn(shape)
    return Array.isArray(shape) || (types.some((type) => type.endsWith('Polygon')) && !types.includes('Point'))
  } catch {
    // Readers say what is wrong with it.
    return false
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
