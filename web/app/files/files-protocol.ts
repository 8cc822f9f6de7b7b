// SPDX-License-Identifier: GPL-3.0-or-later
// What goes between the page and the thread that reads and writes files and links, and makes circles.
import type { Float64s } from '../../lib/index.ts'
import type { LinkAttributes, LinkInput } from '../../lib/link.ts'
import type { RegionShape } from '../../lib/regions/region-shape.ts'
import type { NamedCircles } from '../csv.ts'
import type { Catalogue, Recipe } from '../generators/generators.ts'

/** `geojson`: circles as points with a radius; `cells`: cells as polygons, in GeoJSON too. */
export type SavedFormat = 'csv' | 'json' | 'geojson' | 'cells'

/** What a file holds: circles, or a link that was saved with them. */
export type Read = (NamedCircles & { readonly skipped?: number | undefined }) | { readonly link: string }

/** What the thread does. */
export interface FilesCalls {
  /**
   * `skipsInvalid`: whether rows that are no circles are left out, and counted as `skipped`.
   *
   * @throws CircleVoronoiError as `readCircleFile`, `readDiagramFile`
   */
  read(bytes: Uint8Array<ArrayBuffer>, name: string, skipsInvalid?: boolean): Read
  /** Circles that show a picture. @throws CircleVoronoiError `internal`, if the browser cannot read it */
  stipple(picture: Blob): Read
  /** `region`: what cells are clipped to. @throws CircleVoronoiError as `compute`, `writeDiagram` */
  write(circles: Float64s, format: SavedFormat, region?: RegionShape, attributes?: LinkAttributes): string
  /** @throws CircleVoronoiError as `encodeLink` */
  link(state: LinkInput): string
  /** @throws CircleVoronoiError `badInput`, if there is no family or figure of this name */
  make(recipe: Recipe): Float64s
  catalogue(): Catalogue
}
