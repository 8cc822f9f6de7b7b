// SPDX-License-Identifier: GPL-3.0-or-later
// Compiles the declarations of the package with some compilers of TypeScript.
import assert from 'node:assert/strict'
import { join } from 'node:path'
import { it } from 'node:test'
import { ROOT } from './project.mjs'

const SETTINGS = {
  'a page with a bundler': { module: 'esnext', moduleResolution: 'bundler', lib: ['es2022', 'dom'], types: [] },
  Node: { module: 'nodenext', moduleResolution: 'nodenext', lib: ['es2022'], types: ['node'] },
}

/** Tests that a project has types, with compilers by name. */
export function hasTypes(project, compilers) {
  for (const [place, settings] of Object.entries(SETTINGS)) {
    for (const [name, compiler] of Object.entries(compilers)) {
      it(`for ${place}, to ${name}`, () => {
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
        assert.equal(project.run(compiler, '-p', 'tsconfig.json'), '')
      })
    }
  }
}
