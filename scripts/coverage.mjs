// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run coverage`: how much of the C++ the native tests run, lines and branches by folder, and in
// build/coverage/report.txt the lines of each file that none of them runs.
import { execFileSync } from 'node:child_process'
import { existsSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { dirname } from 'node:path'
import { main, ROOT, run, statusOf } from './run.mjs'
import { setup } from './setup.mjs'

const BUILD = `${ROOT}build/coverage`
const REPORT = `${BUILD}/report.txt`
const SOURCES = /^cpp\/(include|src|cli)\//

await main(async () => {
  await setup('tests')
  if (!existsSync(`${BUILD}/build.ninja`)) await run('cmake', ['--preset', 'coverage'])
  await run('cmake', ['--build', '--preset', 'coverage'])
  for (const path of filesEndingIn('.gcda')) rmSync(path)
  const status = await statusOf('ctest', ['--preset', 'coverage', ...process.argv.slice(2)])

  const files = countLines(filesEndingIn('.gcno'))
  writeFileSync(REPORT, reportOf(files))
  console.log(`\n${tableOf(files)}\nLines that no test runs: build/coverage/report.txt`)
  if (status !== 0) throw new Error('Tests failed, so that others may not have run.')
})

function filesEndingIn(ending) {
  return readdirSync(BUILD, { recursive: true })
    .filter((path) => path.endsWith(ending))
    .map((path) => `${BUILD}/${path}`)
}

/**
 * From the compiler's notes, beside which what ran has left its counts: of each file of ours, by its path, `lines`,
 * how often each of its lines ran, and `branches`, how often each way out of a line was taken. What is compiled several
 * times, as headers and templates are, is added up. Ways out by an exception are left out.
 */
function countLines(notes) {
  const files = new Map()
  for (const path of notes) {
    const output = execFileSync('gcov', ['--json-format', '--stdout', '--branch-probabilities', path], {
      cwd: dirname(path),
      encoding: 'utf8',
      maxBuffer: 2 ** 30,
      stdio: ['ignore', 'pipe', 'ignore'],
    })
    for (const { file, lines } of JSON.parse(output).files) {
      const name = file.startsWith(ROOT) ? file.slice(ROOT.length) : file
      if (!SOURCES.test(name)) continue
      const counts = files.get(name) ?? { lines: new Map(), branches: new Map() }
      files.set(name, counts)
      for (const { line_number, count, branches } of lines) {
        add(counts.lines, line_number, count)
        const ways = branches.filter((branch) => !branch.throw)
        for (const [i, branch] of ways.entries()) add(counts.branches, `${line_number}.${i}`, branch.count)
      }
    }
  }
  return files
}

function add(counts, key, count) {
  counts.set(key, (counts.get(key) ?? 0) + count)
}

function tableOf(files) {
  const folders = [...new Set([...files.keys()].map(dirname))].sort()
  const countsIn = (folder) => [...files].filter(([name]) => dirname(name) === folder).map(([, counts]) => counts)
  const rows = folders.map((folder) => row(folder, countsIn(folder)))
  return [header(), ...rows, row('all', [...files.values()])].join('\n')
}

function reportOf(files) {
  const entries = [...files].sort()
  const rows = entries.map(([name, counts]) => row(name, [counts]))
  const lists = entries
    .map(([name, { lines }]) => [name, rangesOf([...lines].filter(([, count]) => count === 0).map(([line]) => line))])
    .filter(([, ranges]) => ranges !== '')
    .map(([name, ranges]) => `${name}: ${ranges}`)
  return [tableOf(files), '', header(), ...rows, '', 'Lines that no test runs:', ...lists, ''].join('\n')
}

function header() {
  return `${''.padEnd(48)}${'lines'.padStart(20)}${'branches'.padStart(20)}`
}

function row(name, counts) {
  return name.padEnd(48) + ['lines', 'branches'].map((kind) => share(counts.map((of) => of[kind]))).join('')
}

/** `12 of 34  35.3 %`, right-aligned. */
function share(maps) {
  const counts = maps.flatMap((map) => [...map.values()])
  const hit = counts.filter((count) => count > 0).length
  const percent = counts.length === 0 ? '' : `${((100 * hit) / counts.length).toFixed(1)} %`
  return `${`${hit}/${counts.length}`.padStart(12)}${percent.padStart(8)}`
}

/** `3, 7-9`: line numbers in short. */
function rangesOf(numbers) {
  const ranges = []
  for (const n of numbers.sort((a, b) => a - b)) {
    const last = ranges.at(-1)
    if (last !== undefined && last[1] === n - 1) last[1] = n
    else ranges.push([n, n])
  }
  return ranges.map(([from, to]) => (from === to ? `${from}` : `${from}-${to}`)).join(', ')
}
