// SPDX-License-Identifier: GPL-3.0-or-later
// Limits for the minified and compressed files that a page downloads.
import { resolve } from 'node:path'

const LIB = 'dist/lib'

/** All of it once, though a worker has a part of it again. */
const LAYER = `
  export * from './index.js'
  export * from './worker.js'
  export * from './regions.js'
  export * from './metrics.js'
  export * from './sphere.js'
  export * from './files.js'
  export * from './link.js'
  import './worker-thread.js'
`

const wasm = (name, limit, module) => ({
  name,
  limit,
  path: ['wasm', 'js'].map((type) => `${LIB}/generated/${module}.${type}`),
  gzip: true,
  modifyEsbuildConfig: (config) => ({ ...config, format: 'esm', loader: { '.wasm': 'copy' } }),
})

export default [
  // This includes 7 kB for the final parts of tiles and for one triangulation of ties, 24 kB for editors, 2 kB for
  // traces, 2 kB for exact directions to discs that are nearly tangent lines, and 9 kB for periodic diagrams and their
  // check.
  wasm('WebAssembly and its glue', '176 kB', 'circle-voronoi'),
  // This includes exact signs and the judge of power diagrams, 1 for progress and the check of circles,
  // 18 for periodic diagrams and one triangulation of ties, and 8 for the proof of diagrams from other sources.
  wasm('Power diagrams, fetched when asked for', '90.5 kB', 'circle-voronoi-metrics'),
  // With the core, which also flips from one diagram to the next, the geometry, exact signs along boundaries and at
  // distances, paths inside, and a sparse Cholesky decomposition; 16 kB are for fits in periodic boxes, 2 for
  // runs of sides in spirals, 6 for holes, 36 for power diagrams and treemaps.
  wasm('Regions and fitted areas, fetched when asked for', '478 kB', 'circle-voronoi-regions'),
  // With the core, and regions that find out whether polygons cross themselves.
  wasm('Circles on a sphere, fetched when asked for', '251 kB', 'circle-voronoi-sphere'),
  // With the judge, the geometry, exact signs along boundaries, and the streams of the standard library; 3 kB are for layers
  // compiled as one file, 6 for writers that check what they are given, 3.5 for columns without names or with the same
  // name, and members that are given twice, 1 for columns of degrees,
  // 9 for the judge of power diagrams, 2 for holes in many loops, 11 for well-known text, GeoJSON lines and tables of
  // cells, 4 for well-known binary and names in drawings.
  wasm('Files, fetched when asked for', '488 kB', 'circle-voronoi-files'),
  {
    name: 'All of it but files in one file',
    // This includes 11 kB for the scripts of regions, spheres and metrics, whose WebAssembly is fetched, 2 for what
    // calls that of spheres, and 3 kB for exact signs of cells in bounds.
    limit: '236 kB',
    path: `${LIB}/bundle.js`,
    gzip: true,
  },
  {
    name: 'The element in one file',
    // This includes 507 kB for regions, fitted areas, treemaps and power diagrams: the file may be copied alone. 30 kB are for
    // scripts that both the page and its thread have.
    limit: '873 kB',
    path: 'dist/element/classic.js',
    gzip: true,
  },
  {
    name: 'The element with its thread and WebAssembly',
    // This includes 155 kB for the WebAssembly, 30 for what draws and edits, in two languages, 3.5 for regions and
    // areas, 7 for the scripts of the modules for these and for power diagrams, as Vite up to 7 cannot split a thread; the
    // rest for geometry and the painting thread. 0.6 are for points in well-known binary, names in SVG and what is said
    // about missing numbers.
    limit: '301.5 kB',
    path: ['dist/element/index.js', 'dist/element/painter.js', `${LIB}/generated/circle-voronoi.wasm`],
    // Files that the first figure does not need are fetched on demand.
    ignore: ['player', 'german', 'link'].map((name) => `./${name}-*`),
    gzip: true,
    modifyEsbuildConfig: (config) => ({ ...config, format: 'esm', splitting: true, loader: { '.wasm': 'copy' } }),
  },
  {
    name: 'TypeScript layer',
    // This includes 2 kB for elliptic integrals and the largest disc inside a region, 3 kB
    // for sentences that say what is wrong with an argument, half a one for quick decimal texts, another for edges that
    // are drawn as chords without their curves, 1 kB each for JSON, files and links, 1.5 for traces, and 4.7 kB for
    // editors, here and in a worker, and diagrams that follow them, 3.5 kB for regions and fitted areas, here and in a
    // worker, 0.4 for unchecked twins of public functions on hot paths, 0.1 for points as near to two circles, 0.2 for
    // Trusted Types, 0.3 for attributes in links, 3.7 kB for exact signs of cells in bounds, 0.4 for searches around
    // circles with many neighbors whose sides change, 1.8 for spheres, here and in a worker, 0.5 for metrics, 2 for
    // treemaps, here and in a worker, 0.3 for power diagrams at a distance, and 0.2 for what helps against missing numbers.
    limit: '58 kB',
    path: `${LIB}/index.js`,
    ignore: ['./generated/*', '../generated/*'],
    gzip: true,
    modifyEsbuildConfig: ({ entryPoints: _, ...config }) => ({
      ...config,
      format: 'esm',
      stdin: { contents: LAYER, resolveDir: resolve(LIB) },
    }),
  },
]
