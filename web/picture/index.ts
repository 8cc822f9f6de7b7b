// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Pictures of figures without a browser.
 *
 * @module circle-voronoi/picture
 */
export type { LoadOptions } from '../lib/index.ts'
export type { LinkInput } from '../lib/link.ts'
export { type PictureOptions, renderSVG } from './render.ts'
export type { Scheme } from './scheme.ts'
