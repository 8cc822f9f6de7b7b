// SPDX-License-Identifier: GPL-3.0-or-later
// The code under "From the shell" and "From C++" in README.md, run as a reader would, with the program and the library
// installed from build/native.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { delimiter, join } from 'node:path'
import { after, before, describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { readmeSnippets } from './snippets.mjs'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))

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

describe('From the shell', () => {
  const snippets = readmeSnippets('From the shell')

  it('is one block', () =>
    assert.deepEqual(
      snippets.map(({ language }) => language),
      ['sh'],
    ))

  for (const command of snippets[0].code.trim().split('\n')) {
    it(command, () => {
      const printed = run('sh', '-c', command)
      const output = / -o (\S+)/.exec(command)?.[1]
      const text = output === undefined ? printed : readFileSync(join(folder, output), 'utf8')
      if (command.includes('stats')) assert.equal(JSON.parse(text).certificate.certified, true)
      else if (command.includes('certify')) assert.match(text, /^certified: 1000 circles/)
      else if (output.endsWith('.geojson')) assert.equal(JSON.parse(text).features.length, 1000)
      else if (output.endsWith('.json')) assert.equal(JSON.parse(text).circles.length, 1000)
      else if (output.endsWith('.csv')) assert.equal(text.trim().split('\n').length, 1001)
      else assert.match(text, /^<svg [^>]*viewBox="0 -50 50 50"/)
    })
  }
})

describe('Beyond one machine', () => {
  const [{ code }] = readmeSnippets('Beyond one machine')

  it('has a driver that puts the tiles together', () => {
    symlinkSync(join(ROOT, 'examples'), join(folder, 'examples'))
    run('sh', '-e', '-c', code)
    const levels = readdirSync(join(folder, 'forest')).map((level) => join(folder, 'forest', level, 'parts'))
    const parts = levels.flatMap((level) => readdirSync(level).map((name) => readFileSync(join(level, name), 'utf8')))
    const count = (type) => parts.reduce((sum, text) => sum + text.split(`\n${type},`).length - 1, 0)
    assert.equal(count('edge') - count('vertex'), 100_000 - 1) // Euler
  })
})

describe('From C++', () => {
  const snippets = readmeSnippets('From C++')
  const codeOf = (name) => snippets.find(({ language }) => language === name).code

  it('builds and prints what the comment says', () => {
    assert.deepEqual(
      snippets.map(({ language }) => language),
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
