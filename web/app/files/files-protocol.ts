// SPDX-License-Identifier: GPL-3.0-or-later
// The messages between the page and the thread that reads and writes files and links, and generates circles.
import type { Attributes } from '../../editing/attributes.ts'
import type { Degrees, Headings } from '../../editing/history.ts'
import type { Float64s } from '../../lib/index.ts'
import type { LinkAttributes, LinkInput } from '../../lib/link.ts'
import type { RegionShape } from '../../lib/regions/region-shape.ts'
import type { Size } from '../../view/camera.ts'
import type { Domain } from '../../view/domain.ts'
import type { Catalogue, Recipe } from '../generators/generators.ts'
import type { RadiusScale } from './columns.ts'

/** `geojson` writes circles as points with a radius, `cells` writes cells as polygons; both are GeoJSON. */
export type SavedFormat = 'csv' | 'json' | 'geojson' | 'cells'

/** Circles with the names and other attributes of a file. */
export interface NamedCircles {
  readonly circles: Float64s
  readonly attributes?: Attributes | undefined
  /** Set if the columns of the centers are longitude and latitude. */
  readonly degrees?: Degrees | undefined
  /** The file's names of x, y and r, which saving keeps. */
  readonly headings?: Headings | undefined
}

/** The columns of a table, as options of `readCircleFile`, and the way to get radii from their column. */
export interface NamedColumns extends RadiusScale {
  readonly x: string
  readonly y: string
  /** A column, or one radius for all circles. */
  readonly radius: string | { readonly all: number }
}

export interface HowRead {
  /** Whether invalid rows are skipped, and counted as `skipped`. Default: false. */
  readonly skipsInvalid?: boolean
  /** The columns of centers and radii. Default: by their names. */
  readonly columns?: NamedColumns | undefined
  /** The indices of GeoJSON features that are no circles, because they are the region. */
  readonly polygons?: readonly number[] | undefined
}

/** The diagram of a table before it is opened. */
export interface Preview {
  /** The indices of the circles that others hide. */
  readonly hidden: readonly number[]
  /** The edges as SVG path data in the coordinates of `previewFrame`; empty if they are too many. */
  readonly edges: string
}

/** The contents of a file: circles and their region, or a link that was saved with them. */
export type Read =
  | (NamedCircles & { readonly skipped?: number | undefined; readonly region?: RegionShape | undefined })
  | { readonly link: string }

/** Circles in the colors of a photo, in pixels with y upward, and the size of the photo. */
export interface Stippled extends NamedCircles {
  readonly attributes: Attributes
  readonly size: Size
}

/** A photo, and how many circles were made from it. */
export interface Photo {
  readonly file: File
  readonly count: number
  readonly size: Size
}

/** The functions of the thread. */
export interface FilesCalls {
  /** @throws CircleVoronoiError as `readCircleFile`, `readDiagramFile` */
  read(bytes: Uint8Array<ArrayBuffer>, name: string, how?: HowRead): Read
  /** Converts a picture to circles. @throws CircleVoronoiError `internal` if the browser cannot read it */
  stipple(picture: Blob, count: number): Stippled
  /** @throws CircleVoronoiError as `compute` */
  preview(circles: Float64s): Preview
  /**
   * Writes circles or cells. `domain` has the clipping region or the periods, and `headings` the names of x, y and r.
   * @throws CircleVoronoiError as `compute`, `writeDiagram`
   */
  write(
    circles: Float64s,
    format: SavedFormat,
    domain?: Partial<Domain>,
    attributes?: LinkAttributes,
    headings?: Headings,
  ): string
  /** @throws CircleVoronoiError as `encodeLink` */
  link(state: LinkInput): string
  /** @throws CircleVoronoiError `badInput` if the family or figure is unknown */
  make(recipe: Recipe): Float64s
  catalogue(): Catalogue
  /** Draws a diagram as a small SVG, clipped to the rings of a region. @throws CircleVoronoiError as `compute` */
  thumbnail(circles: Float64s, name: string, rings: readonly (readonly (readonly number[])[])[]): string
}
