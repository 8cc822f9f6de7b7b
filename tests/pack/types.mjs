// SPDX-License-Identifier: GPL-3.0-or-later
// Compiles the declarations of the package with compilers of TypeScript 6 and 7.
import assert from 'node:assert/strict'
import { join, resolve } from 'node:path'
import { it } from 'node:test'
import { BIN, ROOT } from './project.mjs'

const SETTINGS = {
  'a page with a bundler': { module: 'esnext', moduleResolution: 'bundler', lib: ['es2022', 'dom'], types: [] },
  Node: { module: 'nodenext', moduleResolution: 'nodenext', lib: ['es2022'], types: ['node'] },
}
const COMPILERS = ['tsc', 'tsc6']

/** Tests that a project has types, with the selected compilers. */
export function hasTypes(project, isWanted) {
  for (const [place, settings] of Object.entries(SETTINGS)) {
    for (const compiler of COMPILERS.filter(isWanted)) {
      it(`for ${place}, to ${compiler}`, () => {
        const compilerOptions = {
          ...settings,
          target: 'es2022',
          strict: true,
          skipLibCheck: false,
          // Checking the compiler's own declarations would take most of the time.
          skipDefaultLibCheck: true,
          noEmit: true,
          typeRoots: [join(ROOT, 'node_modules/@types')],
        }
        const files = settings.lib.includes('dom') ? ['types.ts', 'element-types.ts'] : ['types.ts']
        project.write('tsconfig.json', JSON.stringify({ compilerOptions, files }))
        assert.equal(project.run(resolve(BIN, compiler), '-p', 'tsconfig.json'), '')
      })
    }
  }
}
