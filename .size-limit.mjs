// SPDX-License-Identifier: GPL-3.0-or-later
// What a page has to fetch, minified and compressed.
import { resolve } from 'node:path'

const LIB = 'dist/lib'

/** All of it once, though a worker has a part of it again. */
const LAYER = `
  export * from './index.js'
  export * from './worker.js'
  import './worker-thread.js'
`

export default [
  {
    name: 'WebAssembly and its glue',
    limit: '150 kB',
    path: ['wasm', 'js'].map((type) => `${LIB}/generated/circle-voronoi.${type}`),
    gzip: true,
    modifyEsbuildConfig: (config) => ({ ...config, format: 'esm', loader: { '.wasm': 'copy' } }),
  },
  {
    name: 'TypeScript layer',
    limit: '15 kB',
    path: `${LIB}/index.js`,
    ignore: ['./generated/*'],
    gzip: true,
    modifyEsbuildConfig: ({ entryPoints: _, ...config }) => ({
      ...config,
      format: 'esm',
      stdin: { contents: LAYER, resolveDir: resolve(LIB) },
    }),
  },
]
