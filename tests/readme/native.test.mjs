// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the shell and C++ code of the documentation and the manual page like a reader, with the program and the library
// installed from build/native.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { delimiter, join } from 'node:path'
import { after, before, describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { blocksRunBy } from './blocks.mjs'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))

const BLOCKS = blocksRunBy('tests/readme/native.test.mjs')
const below = (heading) => BLOCKS.filter(({ headings }) => headings.includes(heading))
/** Texts with commands. Later texts use files that earlier ones write. */
const WITH_COMMANDS = [
  'README.md',
  'docs/shell.md',
  'docs/regions.md',
  'docs/areas.md',
  'docs/periodic.md',
  'docs/metrics.md',
  'cpp/cli/circle-voronoi.1',
]

let folder
let prefix

/** Runs a program in the folder and returns what it prints. */
function run(program, ...args) {
  const env = { ...process.env, PATH: `${join(prefix, 'bin')}${delimiter}${process.env.PATH}` }
  const { status, stdout, stderr, error } = spawnSync(program, args, { cwd: folder, env, encoding: 'utf8' })
  assert.equal(error, undefined)
  assert.equal(status, 0, `${program} ${args.join(' ')}\n${stdout}${stderr}`)
  return stdout
}

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-readme-'))
  prefix = join(folder, 'prefix')
  run('cmake', '--install', join(ROOT, 'build/native'), '--prefix', prefix)
})
after(() => rmSync(folder, { recursive: true, force: true }))

for (const file of WITH_COMMANDS) {
  describe(file, () => {
    for (const { code } of BLOCKS.filter((block) => block.file === file && block.language === 'sh')) {
      for (const command of code.trim().split('\n')) {
        it(command, () => check(command, run('sh', '-c', command)))
      }
    }
  })
}

/** Checks the output of a command, or the file that it writes. */
function check(command, printed) {
  const output = / -o (\S+)/.exec(command)?.[1]
  if (command.includes(' tile ')) return assert.ok(readdirSync(join(folder, output)).length > 2)
  // The command writes an input of later commands.
  if (/ > \S+$/.test(command)) return assert.equal(printed, '')
  const text = output === undefined ? printed : readFileSync(join(folder, output), 'utf8')
  if (command.includes('stats')) assert.equal(JSON.parse(text).certificate.certified, true)
  else if (command.includes('certify')) assert.match(text, /^certified: 1000 circles/)
  else if (command.includes('--lattice')) checkRepeated(output, text)
  else if (command.includes('--sphere')) checkStations(output, text)
  else if (command.includes(' fit ')) checkAreas(JSON.parse(text))
  else if (command.includes(' treemap ')) checkTreemap(output, text)
  else if (output.endsWith('.geojson')) {
    assert.equal(JSON.parse(text).features.length, command.includes('shops') ? 3 : 1000)
  } else if (output.endsWith('.json')) assert.equal(JSON.parse(text).circles.length, 1000)
  else if (command.includes('--core')) assert.match(text, /^vertex,/m)
  else if (output.endsWith('.csv')) assert.equal(text.trim().split('\n').length, 1001)
  else assert.match(text, command.includes('--bounds') ? /^<svg [^>]*viewBox="0 -50 50 50"/ : /^<svg /)
}

/** Checks complete cells that fill the box, a table of contacts, or a drawing. */
function checkRepeated(output, text) {
  if (output.endsWith('.svg')) return assert.match(text, /^<svg [\s\S]*clipPath/)
  if (output.endsWith('.csv')) return assert.match(text, /^circle,neighbor,shift_a,shift_b,length,gap,area,/)
  const { features } = JSON.parse(text)
  const sum = features.reduce((area, { properties }) => area + properties.area, 0)
  assert.equal(features.length, 1000)
  assert.ok(Math.abs(sum / 1600 - 1) < 1e-12)
}

/** Checks the cells of three stations: whole ones, which cover the Earth, or a table of cells that are cut at a distance. */
function checkStations(output, text) {
  if (output.endsWith('.csv')) return assert.equal(text.trim().split('\n').length, 4)
  const { features } = JSON.parse(text)
  const sum = features.reduce((area, { properties }) => area + properties.area, 0)
  assert.equal(features.length, 3)
  assert.ok(Math.abs(sum / (4 * Math.PI * 6371.0088 ** 2) - 1) < 1e-12)
}

/** Checks that areas are proportional to populations, and that the attributes of towns are kept. */
function checkAreas({ features }) {
  assert.deepEqual(
    features.map(({ properties }) => properties.name),
    ['Ash', 'Birch', 'Cedar'],
  )
  for (const { properties } of features) assert.ok(Math.abs(properties.area / properties.people - 16) < 1e-7)
}

/** Checks the cells of two lands and three towns: a table, a drawing, or features. */
function checkTreemap(output, text) {
  if (output.endsWith('.csv'))
    return assert.match(text, /^land,town,y2020,level,area,x,y,weight\nNorth,,8,1,76\.(8|79999)/)
  if (output.endsWith('.svg')) return assert.match(text, /^<svg [\s\S]*<title>land: South, town: Cedar, y2030: 4</)
  const { features } = JSON.parse(text)
  const shares = features.map(({ properties }) => Math.round(properties.area * 13 * 1e6) / 1e6)
  assert.deepEqual(shares, [9, 4, 6, 3, 4])
}

describe('More circles than fit into memory', () => {
  const [{ code }] = below('More circles than fit into memory')

  it('has a driver that puts the tiles together', () => {
    symlinkSync(join(ROOT, 'examples'), join(folder, 'examples'))
    run('sh', '-e', '-c', code)
    const levels = readdirSync(join(folder, 'forest')).map((level) => join(folder, 'forest', level, 'parts'))
    const parts = levels.flatMap((level) => readdirSync(level).map((name) => readFileSync(join(level, name), 'utf8')))
    const count = (type) => parts.reduce((sum, text) => sum + text.split(`\n${type},`).length - 1, 0)
    assert.equal(count('edge') - count('vertex'), 100_000 - 1) // By Euler's formula.
  })
})

describe('In C++', () => {
  const codeOf = (name) => below('In C++').find(({ language }) => language === name).code

  it('builds and prints what the comment says', () => {
    assert.deepEqual(
      below('In C++').map(({ language }) => language),
      ['cmake', 'cpp'],
    )
    const preamble = 'cmake_minimum_required(VERSION 3.25)\nproject(readme LANGUAGES CXX)\n'
    writeFileSync(join(folder, 'CMakeLists.txt'), preamble + codeOf('cmake'))
    writeFileSync(join(folder, 'main.cpp'), codeOf('cpp'))
    run('cmake', '-S', '.', '-B', 'build', '-G', 'Ninja', '-D', `CMAKE_PREFIX_PATH=${prefix}`)
    run('cmake', '--build', 'build')
    const [, expected] = /\/\/ (.*)$/m.exec(codeOf('cpp'))
    assert.equal(run('build/program'), `${expected}\n`)
  })
})

describe('Use it from C++', () => {
  const blocksOf = (heading, name) =>
    below('Use it from C++')
      .filter(({ headings, language }) => headings.includes(heading) && language === name)
      .map(({ code }) => code)
  const source = blocksOf('Options, errors, progress and canceling', 'cpp')[0]
  const [installed, fetched] = blocksOf('Use it in your project', 'cmake')
  /** A project in a folder of its own. */
  const write = (name, lists) => {
    mkdirSync(join(folder, name))
    writeFileSync(join(folder, name, 'CMakeLists.txt'), lists)
    writeFileSync(join(folder, name, 'main.cpp'), source)
  }

  it('is configured, built and installed by plain commands', () => {
    const [configure, build, install] = blocksOf('Install it', 'sh')[0].trim().split('\n')
    mkdirSync(join(folder, 'guide'))
    symlinkSync(ROOT, join(folder, 'guide/circle-voronoi'))
    run('sh', '-c', `cd guide && ${configure}`)
    assert.match(
      readFileSync(join(folder, 'guide/build/CMakeCache.txt'), 'utf8'),
      /^CIRCLE_VORONOI_BUILD_TESTS:BOOL=OFF$/m,
    )
    // All tests run with a library that is built and installed in this way.
    assert.deepEqual([build, install], ['cmake --build build', 'cmake --install build --prefix installed'])
  })

  it('is found, and prints what the comments say', () => {
    write('found', installed)
    const [configure] = blocksOf('Use it in your project', 'sh')
    run('sh', '-c', `cd found && ${configure.trim().replace('=installed', `=${prefix}`)} -G Ninja`)
    run('cmake', '--build', 'found/build')
    const expected = [...source.matchAll(/std::cout << .*; {2}\/\/ (.*)$/gm)].map(([, text]) => `${text}\n`)
    assert.equal(expected.length, 4)
    assert.equal(run('found/build/program'), expected.join(''))
  })

  it('is fetched', () => {
    write('fetched', fetched)
    const options = ['-G', 'Ninja', '-D', `FETCHCONTENT_SOURCE_DIR_CIRCLE_VORONOI=${ROOT}`]
    run('cmake', '-S', 'fetched', '-B', 'fetched/build', ...options)
    assert.match(run('ninja', '-C', 'fetched/build', '-t', 'targets', 'all'), /^program:/m)
  })
})
