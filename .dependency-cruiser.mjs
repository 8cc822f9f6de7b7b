// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of the web code, lowest first (ARCHITECTURE.md). A folder imports from itself and from the folders before it;
// the playground and other pages, which stand above, import from all.

const LAYERS = {
  'web/lib': ['base', 'curves', 'regions', 'drawing', 'diagram', 'queries', 'wasm', 'threads'],
  web: ['lib', 'view', 'editing', 'player', 'element'],
}

/** The folder of files that the C++ build makes. All layers may import from it. */
const BUILT = 'generated'

const rulesOf = ([parent, folders]) =>
  folders.map((folder, i) => ({
    name: `${parent}/${folder}`,
    comment: `${folder} imports only from itself and the folders before it in ${folders.join(', ')}.`,
    severity: 'error',
    from: { path: `^${parent}/${folder}/` },
    to: { path: `^${parent}/`, pathNot: `^${parent}/(${[...folders.slice(0, i + 1), BUILT].join('|')})/` },
  }))

export default {
  forbidden: Object.entries(LAYERS).flatMap(rulesOf),
  options: {
    // Imports of types, which the compiler removes, count, too.
    tsPreCompilationDeps: true,
    tsConfig: { fileName: 'tsconfig.json' },
    doNotFollow: { path: 'node_modules' },
  },
}
