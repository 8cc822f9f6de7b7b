// SPDX-License-Identifier: GPL-3.0-or-later
// Reads regions in the common formats: GeoJSON, a JSON list of rings, or well-known text.
import { isRecord } from '../lib/base/check.ts'
import { reasonOf } from '../lib/base/errors.ts'
import { plainRegion, type RegionShape } from '../lib/regions/region-shape.ts'
import { ENGLISH_REFUSALS, Refusal, type Refusals, shownValue } from './refusal.ts'

// Matches trimmed text. Allowing white space before the end at each parenthesis would make matching slow.
const WKT = /^(?:SRID=\d+;\s*)?(MULTI)?POLYGON\s*(?:ZM?\s*|M\s*)?(\(.*\))$/is
const NUMBERS = /[^(),]+/g

/** Whether a text contains a region and is not an address. */
export function isRegionText(text: string): boolean {
  return /^\s*[[{]/.test(text) || /^\s*(SRID=\d+;\s*)?(MULTI)?POLYGON\b/i.test(text)
}

/**
 * Reads a region. Crossing rings are not detected here.
 * @throws CircleVoronoiError `badInput` or `badOption`
 */
export function readRegion(text: string): RegionShape {
  return /^\s*[[{]/.test(text) ? regionOfJson(fromJson(text)) : plainRegion(fromWkt(text))
}

/** Reads a region from parsed JSON. */
export function regionOfJson(given: unknown): RegionShape {
  return plainRegion(polygonsIn(given as RegionShape))
}

function fromJson(text: string): RegionShape {
  try {
    return JSON.parse(text)
  } catch (error) {
    refuse((words) => words.notRegion(reasonOf(error)))
  }
}

/** The polygons of a collection; its points and lines are ignored. */
function polygonsIn(shape: RegionShape): RegionShape {
  if (!isRecord(shape) || shape.type !== 'FeatureCollection' || !Array.isArray(shape.features)) return shape
  const features = shape.features.filter((feature) => {
    const type: unknown = Object(Object(feature).geometry).type
    return type === 'Polygon' || type === 'MultiPolygon' || type === 'GeometryCollection'
  })
  return features.length === 0 ? shape : { type: 'FeatureCollection', features }
}

function fromWkt(text: string): RegionShape {
  const [, isMulti, body] = WKT.exec(text.trim().replace(/;$/, '').trimEnd()) ?? []
  if (body === undefined) refuse((words) => words.notRegion(shownValue(text.trim())))
  const json = body
    .replace(/EMPTY/gi, '()')
    .replace(NUMBERS, (point) => (point.trim() === '' ? '' : `[${point.trim().split(/\s+/).slice(0, 2).join()}]`))
    .replaceAll('(', '[')
    .replaceAll(')', ']')
  const coordinates = fromJson(json) as never
  return isMulti === undefined ? { type: 'Polygon', coordinates } : { type: 'MultiPolygon', coordinates }
}

function refuse(say: (words: Refusals) => string): never {
  throw new Refusal(ENGLISH_REFUSALS, say)
}
