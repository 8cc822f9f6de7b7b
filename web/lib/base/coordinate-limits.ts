// SPDX-License-Identifier: GPL-3.0-or-later

/** The largest coordinate or radius of a circle, in absolute value (kCoordinateLimit of circle_voronoi/limits.h). */
export const COORDINATE_LIMIT = 1e150
/** The limit in error messages. */
export const COORDINATE_LIMIT_TEXT = '1e150'

/**
 * The largest coordinate of a region, in absolute value. It is a hundred times the limit of circles and keeps areas
 * finite.
 *
 * @category Cells
 * @example
 * REGION_LIMIT // 1e+152
 */
export const REGION_LIMIT = 1e152
/** The limit in error messages. */
export const REGION_LIMIT_TEXT = '1e152'
