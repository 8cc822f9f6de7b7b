// SPDX-License-Identifier: GPL-3.0-or-later
// What goes between the page and the thread that reads and writes files and links, and makes circles.
import type { PostedError } from '../../lib/base/errors.ts'
import type { Float64s } from '../../lib/index.ts'
import type { LinkInput } from '../../lib/link.ts'
import type { RegionShape } from '../../lib/regions/region-shape.ts'
import type { NamedCircles } from '../csv.ts'
import type { Recipe } from '../generators/generators.ts'

/** `geojson`: circles as points with a radius; `cells`: cells as polygons, in GeoJSON too. */
export type SavedFormat = 'csv' | 'json' | 'geojson' | 'cells'

/** What a file holds: circles, or a link that was saved with them. */
export type Read = NamedCircles | { readonly link: string }

export type FilesRequest =
  | { readonly kind: 'read'; readonly request: number; readonly bytes: Uint8Array<ArrayBuffer>; readonly name: string }
  | { readonly kind: 'stipple'; readonly request: number; readonly picture: Blob }
  | {
      readonly kind: 'write'
      readonly request: number
      readonly circles: Float64s
      readonly format: SavedFormat
      /** What cells are clipped to. */
      readonly region: RegionShape | undefined
    }
  | { readonly kind: 'link'; readonly request: number; readonly state: LinkInput }
  | { readonly kind: 'make'; readonly request: number; readonly recipe: Recipe }
  | { readonly kind: 'catalogue'; readonly request: number }

export interface FilesReply {
  readonly request: number
  readonly result?: unknown
  readonly error?: PostedError
}
