// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * `<circle-voronoi>`: a live figure in two lines.
 *
 * ```html
 * <script type="module" src="https://example.com/circle-voronoi/dist/element/index.js"></script>
 * <circle-voronoi circles="[[0, 0, 2], [10, 0, 1], [5, 8, 1.5]]"></circle-voronoi>
 * ```
 *
 * @module circle-voronoi/element
 */
import { defineCircleVoronoi } from './define.ts'

export * from './define.ts'

defineCircleVoronoi()
