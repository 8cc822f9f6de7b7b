// SPDX-License-Identifier: GPL-3.0-or-later
// The C++ library from a clean clone, built as docs/cpp.md says by GCC and by Clang, static and shared, without a warning.
// Other projects use it by find_package, FetchContent and pkg-config.
import assert from 'node:assert/strict'
import { execFileSync, spawnSync } from 'node:child_process'
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, describe, it } from 'node:test'
import { ROOT } from '../../scripts/run.mjs'
import { declaredNames, programWith, sourceWithHeaders } from '../package/exports.mjs'

const STRICT = ['-Wall', '-Wextra', '-Wpedantic', '-Wconversion', '-Wsign-conversion', '-Wshadow', '-Werror']
const LIBRARIES = ['circle_voronoi', 'circle_voronoi_families', 'circle_voronoi_fit', 'circle_voronoi_io']

let folder
let clone
before(() => {
  folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-clone-'))
  clone = join(folder, 'circle-voronoi')
  execFileSync('git', ['clone', '--quiet', ROOT, clone])
})
after(() => rmSync(folder, { recursive: true, force: true }))

/** Runs a program, and returns what it prints, on both streams. */
function run(program, args, env = {}) {
  const { status, stdout, stderr, error } = spawnSync(program, args, {
    cwd: folder,
    env: { ...process.env, ...env },
    encoding: 'utf8',
    maxBuffer: 2 ** 30,
  })
  assert.equal(error, undefined)
  assert.equal(status, 0, `${program} ${args.join(' ')}\n${stdout}${stderr}`)
  return stdout + stderr
}

for (const compiler of ['g++', 'clang++']) {
  describe(`the library by ${compiler}`, () => {
    const build = `build-${compiler}`
    /** Builds the clone with options, in addition to those before. Objects are the same for static and shared libraries. */
    const make = (...options) => {
      const recipe = ['-S', 'circle-voronoi', '-B', build, '-G', 'Ninja', '-D', 'CIRCLE_VORONOI_BUILD_TESTS=OFF']
      const configured = run('cmake', [...recipe, ...options], { CXX: compiler })
      return configured + run('cmake', ['--build', build])
    }
    /** Builds an example in a folder, and runs it. */
    const example = (name, where) =>
      run(
        'cmake',
        [
          ...['-D', `EXAMPLE=${name}`, '-D', `FOLDER=${join(folder, where)}`, '-D', `BUILD=${join(folder, build)}`],
          ...['-P', join(clone, 'tests/package/check.cmake')],
        ],
        { CXX: compiler },
      )
    /** Builds and runs a program with the flags that pkg-config gives for an installed library. */
    const usePkgConfig = (prefix) => {
      const env = { PKG_CONFIG_PATH: `${prefix}/lib/pkgconfig:${prefix}/lib64/pkgconfig` }
      const flags = run('pkg-config', ['--cflags', '--libs', ...LIBRARIES], env)
        .trim()
        .split(/\s+/)
      const program = join(prefix, 'program')
      run(compiler, ['-std=c++20', join(clone, 'tests/package/three_circles.cpp'), ...flags, '-o', program])
      const libraries = flags.filter((flag) => flag.startsWith('-L')).map((flag) => flag.slice(2))
      assert.equal(run(program, [], { LD_LIBRARY_PATH: libraries.join(':') }), '1 vertex\n')
      return { flags, libraries }
    }

    for (const [kind, isShared] of [
      ['static', 'OFF'],
      ['shared', 'ON'],
    ]) {
      it(`${kind}: builds without a warning, and find_package and pkg-config find it`, () => {
        assert.doesNotMatch(make('-D', `BUILD_SHARED_LIBS=${isShared}`), /warning/i)
        const where = `${build}-${kind}`
        example('find_package', where)
        const { flags } = usePkgConfig(join(folder, where, 'prefix'))
        writeFileSync(join(folder, 'headers.cpp'), sourceWithHeaders(join(folder, where, 'prefix/include')))
        const folders = flags.filter((flag) => flag.startsWith('-I'))
        run(compiler, ['-std=c++20', ...STRICT, ...folders, '-fsyntax-only', 'headers.cpp'])
      })
    }

    it('shared: has each function that the public headers declare', () => {
      const prefix = join(folder, `${build}-shared`, 'prefix')
      const names = declaredNames(join(prefix, 'include'))
      assert.ok(names.some((name) => name.includes('DiagramEditor')))
      const { flags, libraries } = usePkgConfig(prefix)
      writeFileSync(join(folder, 'exports.cpp'), programWith(names))
      const program = join(folder, `exports-${compiler}`)
      run(compiler, ['-std=c++20', 'exports.cpp', '-Wl,--no-as-needed', ...flags, '-o', program])
      run(program, [], { LD_LIBRARY_PATH: libraries.join(':'), LD_BIND_NOW: '1' })
    })

    it('leaves out the program, with a sentence, if CLI11 is missing', () => {
      rmSync(join(folder, build, 'circle-voronoi'))
      assert.match(make('-D', 'CMAKE_DISABLE_FIND_PACKAGE_CLI11=ON'), /circle-voronoi is not built, .*CLI11/)
      assert.ok(!existsSync(join(folder, build, 'circle-voronoi')))
      run('cmake', ['--install', build, '--prefix', `${build}-without-program`])
      usePkgConfig(join(folder, `${build}-without-program`))
      rmSync(join(folder, build), { recursive: true })
    })

    it('is built as a part of a project by FetchContent', () => {
      example('fetch_content', `${build}-fetched`)
      usePkgConfig(join(folder, `${build}-fetched`, 'prefix'))
    })
  })
}
