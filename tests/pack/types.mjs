// SPDX-License-Identifier: GPL-3.0-or-later
// Compiles the declarations of the package with old and new compilers.
import assert from 'node:assert/strict'
import { join, resolve } from 'node:path'
import { it } from 'node:test'
import { BIN, ROOT } from './project.mjs'

/** The oldest supported TypeScript, which scripts/setup.mjs installs separately. */
const OLDEST_TSC = join(ROOT, 'tests/pack/typescript-5.0/node_modules/.bin/tsc')

const SETTINGS = {
  'a page with a bundler': { module: 'esnext', moduleResolution: 'bundler', lib: ['es2022', 'dom'], types: [] },
  Node: { module: 'nodenext', moduleResolution: 'nodenext', lib: ['es2022'], types: ['node'] },
  'a project from before exports': {
    ...{ module: 'esnext', moduleResolution: 'node10', lib: ['es2022', 'dom'], types: [] },
  },
}
const COMPILERS = [
  { compiler: 'tsc', name: 'tsc' },
  { compiler: 'tsc6', name: 'tsc6' },
  { compiler: OLDEST_TSC, name: 'TypeScript 5.0' },
]

/** Tests that a project has types, with the selected compilers. */
export function hasTypes(project, isWanted) {
  for (const [place, settings] of Object.entries(SETTINGS)) {
    for (const { compiler, name } of COMPILERS.filter(isWanted)) {
      // TypeScript 7 has removed this module resolution.
      if (compiler === 'tsc' && settings.moduleResolution === 'node10') continue
      it(`for ${place}, to ${name}`, () => {
        const compilerOptions = {
          ...settings,
          ...(compiler === 'tsc6' && { ignoreDeprecations: '6.0' }),
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
