// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run mutate:core [-- NAME...]`: makes each one-line change of tests/mutants/core.json, or those whose names start
// with NAME, to a copy of the sources, one at a time, and says whether the native tests notice. Takes about an hour;
// the sources may be edited meanwhile.
//
// A change has a `name`, the `file`, the text in it (`old`, once) that `new` replaces, and `tests`, a GoogleTest filter. The
// filtered tests run first. The other programs are built only if the filtered tests do not notice the change.
import { spawnSync } from 'node:child_process'
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs'
import { dirname } from 'node:path'
import { isMain, main, ROOT } from './run.mjs'
import { setup } from './setup.mjs'

const COPY = `${ROOT}build/mutants/`
// The same path as in the repository, so that the compiler cache serves both.
const BUILD = `${COPY}build/native`
const COPIED = ['CMakeLists.txt', 'CMakePresets.json', 'cpp', 'tests']
const PROGRAMS = ['circle_voronoi_tests', 'circle_voronoi_proof_tests', 'circle_voronoi_region_tests']
/** Tests with long random runs. */
const LEFT_OUT = ['Oracle*', 'Mismatch*', '*/Automatic*', 'Automatic*', 'Metamorphic*', 'Fixtures*', '*Survive*']
const WANTED = 0.85
/** Limit of processor time for one test program, many times its usual time. */
const SECONDS = 200
const MEGABYTES = 8000

if (isMain(import.meta.url)) await main(tryOutAll)

async function tryOutAll() {
  const mutants = readMutants()
  const names = process.argv.slice(2)
  const chosen = mutants.filter(({ name }) => names.length === 0 || names.some((start) => name.startsWith(start)))
  for (const mutant of chosen) check(mutant)
  if (chosen.length === 0) throw new Error('No change has such a name.')

  await setup('tests')
  copySources()
  for (const program of PROGRAMS) {
    build(program)
    const before = testThatFails(program, '*')
    if (before !== undefined) throw new Error(`Without any change: ${before}`)
  }

  const unnoticed = []
  for (const mutant of chosen) {
    const noticed = tryOut(mutant)
    if (noticed === undefined) unnoticed.push(mutant.name)
    console.log(`${noticed === undefined ? 'NOT NOTICED' : 'noticed'}  ${mutant.name}${noticed ? `: ${noticed}` : ''}`)
  }
  const count = chosen.length - unnoticed.length
  console.log(`\n${count} of ${chosen.length} changes are noticed, ${((100 * count) / chosen.length).toFixed(0)} %.`)
  if (count < WANTED * chosen.length) throw new Error(`Fewer than ${100 * WANTED} % are noticed.`)
}

/** All changes, in the order of their file. */
export function readMutants() {
  return JSON.parse(readFileSync(`${ROOT}tests/mutants/core.json`, 'utf8'))
}

/** Throws if a change does not fit the sources. */
export function check({ name, file, old }) {
  const parts = readFileSync(ROOT + file, 'utf8').split(old)
  if (parts.length !== 2) throw new Error(`${name}: its old text stands ${parts.length - 1} times in ${file}.`)
}

/** Writes only files that differ, which limits rebuilding and repairs the leftovers of an interrupted run. */
function copySources() {
  for (const top of COPIED) {
    const paths = statSync(ROOT + top).isDirectory()
      ? readdirSync(ROOT + top, { recursive: true }).map((path) => `${top}/${path}`)
      : [top]
    for (const path of paths.filter((path) => statSync(ROOT + path).isFile())) {
      const text = readFileSync(ROOT + path)
      if (existsSync(COPY + path) && readFileSync(COPY + path).equals(text)) continue
      mkdirSync(dirname(COPY + path), { recursive: true })
      writeFileSync(COPY + path, text)
    }
  }
}

function build(program) {
  if (!existsSync(`${BUILD}/build.ninja`)) {
    execute('cmake', ['--preset', 'native'])
  }
  execute('cmake', ['--build', BUILD, '--target', program])
}

function execute(program, args) {
  const { status, stdout, stderr } = spawnSync(program, args, { cwd: COPY, encoding: 'utf8', maxBuffer: 2 ** 28 })
  if (status !== 0) throw new Error(`${program} ${args.join(' ')}\n${stdout}${stderr}`)
}

/** Returns what detected a change: the compiler or a test; `undefined` if nothing did. */
function tryOut({ name, file, old, new: replacement, tests }) {
  const text = readFileSync(COPY + file, 'utf8')
  const likely = tests === undefined ? [] : PROGRAMS.filter((program) => has(program, tests))
  const runs = [...likely.map((program) => [program, tests]), ...PROGRAMS.map((program) => [program, '*'])]
  // A replacement function, because `$` has a meaning in replacement strings.
  writeFileSync(
    COPY + file,
    text.replace(old, () => replacement),
  )
  try {
    for (const [program, filter] of runs) {
      build(program)
      const failed = testThatFails(program, filter)
      if (failed !== undefined) return failed
    }
    return undefined
  } catch (error) {
    throw new Error(`${name} does not build.\n${error.message}`)
  } finally {
    writeFileSync(COPY + file, text)
  }
}

function has(program, filter) {
  // Names of tests are indented.
  return /^ /m.test(runTests(program, ['--gtest_list_tests', `--gtest_filter=${filter}`]).stdout)
}

/** The first of the chosen tests that fails, or `undefined`. */
function testThatFails(program, filter) {
  const options = [`--gtest_filter=${filter}-${LEFT_OUT.join(':')}`, '--gtest_fail_fast', '--gtest_brief=1']
  const { status, signal, stdout } = runTests(program, options)
  if (status === 0) return undefined
  return /^\[ +FAILED +\] ([^\s,]+)/m.exec(stdout)?.[1] ?? `ended by ${signal ?? status}`
}

function runTests(program, options) {
  const limited = `ulimit -t ${SECONDS} && ulimit -v ${1000 * MEGABYTES} && exec "$@"`
  return spawnSync('sh', ['-c', limited, 'sh', `${BUILD}/tests/cpp/${program}`, ...options], {
    encoding: 'utf8',
    maxBuffer: 2 ** 28,
    cwd: BUILD,
  })
}
