// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run reproduce [-- --quick]`: runs the paper's experiments and writes docs/results.md with its pictures, or with
// --quick, on less of everything, build/results/results.md. The data is in build/results/data.json. Fails if a claim of
// the paper comes out otherwise than this project knows it (scripts/results/claims.mjs).
import { execFile, execFileSync } from 'node:child_process'
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { availableParallelism, cpus, loadavg, totalmem } from 'node:os'
import { promisify } from 'node:util'
import { benchWasm } from './bench-wasm.mjs'
import { claimsOf } from './results/claims.mjs'
import { median } from './results/fit.mjs'
import { METHODS } from './results/methods.mjs'
import { pageOf } from './results/page.mjs'
import { plots } from './results/plots.mjs'
import { build, main, ROOT, run } from './run.mjs'

const runFile = promisify(execFile)
const NATIVE = `${ROOT}build/native/`
const DATA = `${ROOT}build/results`

const FULL = {
  folder: `${ROOT}docs`,
  countSizes: [100, 316, 1000, 3162, 10_000, 31_623, 100_000],
  trials: { counts: 5, needed: 40, correctness: 500, printed: 200 },
  figureCircles: 100_000,
  timeSizes: [100, 200, 500, 1000, 2000, 5000, 10_000, 20_000, 50_000, 100_000],
  timeRepetitions: 5,
  largeSizes: [10_000, 100_000, 1_000_000, 10_000_000],
  wasmFamilies: ['uniform', 'log-uniform', 'hidden', 'grid', 'one-huge'],
  wasmSizes: [10_000, 100_000, 1_000_000],
  wasmRepetitions: 5,
}
const QUICK = {
  folder: DATA,
  countSizes: [100, 1000, 10_000],
  trials: { counts: 2, needed: 5, correctness: 20, printed: 20 },
  figureCircles: 10_000,
  timeSizes: [100, 300, 1000, 3000, 10_000],
  timeRepetitions: 3,
  largeSizes: [10_000, 30_000, 100_000],
  wasmFamilies: ['uniform'],
  wasmSizes: [10_000, 100_000],
  wasmRepetitions: 2,
}

await main(async () => {
  const isQuick = process.argv.includes('--quick')
  const plan = isQuick ? QUICK : FULL
  await buildAll()
  const pictures = `${plan.folder}/results`
  rmSync(pictures, { recursive: true, force: true })
  mkdirSync(pictures, { recursive: true })
  const data = await measure(plan, isQuick, pictures)
  mkdirSync(DATA, { recursive: true })
  writeFileSync(`${DATA}/data.json`, `${JSON.stringify(data, undefined, 1)}\n`)

  const claims = claimsOf(data)
  for (const [name, svg] of Object.entries(await plots(data))) writeFileSync(`${pictures}/${name}.svg`, svg)
  writeFileSync(`${plan.folder}/results.md`, pageOf(data, claims))
  console.log(`Written: ${plan.folder}/results.md`)
  const news = Object.values(claims).filter(({ outcome, expected }) => outcome !== expected)
  for (const { claim, measured, outcome, expected } of news) {
    console.error(`Expected ${expected}, found ${outcome}: ${claim} ${measured}`)
  }
  if (news.length > 0) throw new Error(`${news.length} claims came out otherwise than expected.`)
})

async function buildAll() {
  await build('build:native', 'build:lib')
  await run('cmake', ['--preset', 'native', '-DCIRCLE_VORONOI_BUILD_BENCH=ON'])
  const targets = ['circle_voronoi_results', 'circle_voronoi_bench', 'circle_voronoi_cli']
  await run('cmake', ['--build', 'build/native', '--target', ...targets])
}

async function measure(plan, isQuick, pictures) {
  const { trials } = plan
  const counted = await experiments({
    table1: ['table-1'],
    counts: ['counts', '--sizes', plan.countSizes.join(), '--trials', trials.counts],
    needed: ['needed-samples', '--trials', trials.needed],
    correctness: ['correctness', '--trials', trials.correctness],
    printed: ['printed-rules', '--trials', trials.printed, '--folder', pictures],
    degenerate: ['degenerate', '--folder', pictures],
    figures: ['figures', '--sizes', plan.figureCircles, '--folder', pictures],
  })
  // Timed experiments run alone.
  return {
    machine: machine(isQuick),
    trials,
    ...counted,
    times: bench(Object.keys(METHODS), plan.timeSizes, plan.timeRepetitions),
    large: bench(['auto'], plan.largeSizes, 1).map((row) => ({ ...row, seconds: median(row.repetitions) })),
    wasm: await benchWasm(plan.wasmFamilies, plan.wasmSizes, plan.wasmRepetitions),
  }
}

/** The output of each experiment by name. Each core runs one experiment at a time. */
async function experiments(all) {
  const results = {}
  const waiting = Object.entries(all)
  const work = async () => {
    for (let next = waiting.shift(); next !== undefined; next = waiting.shift()) {
      const [name, options] = next
      console.log(`── ${options[0]}`)
      const { stdout } = await runFile(`${NATIVE}circle-voronoi-results`, options.map(String), { maxBuffer: 2 ** 28 })
      results[name] = JSON.parse(stdout)
    }
  }
  await Promise.all(Array.from({ length: availableParallelism() }, work))
  return Object.fromEntries(Object.keys(all).map((name) => [name, results[name]]))
}

/** Rows of the benchmark on random circles, without aborted ones. */
function bench(methods, sizes, repetitions) {
  console.log(`── times of ${methods.join(', ')}`)
  const file = `${DATA}/bench.json`
  mkdirSync(DATA, { recursive: true })
  const options = {
    '--families': 'uniform',
    '--sizes': sizes.join(),
    '--methods': methods.join(),
    '--repetitions': repetitions,
    '--limit': 600,
    '-o': file,
  }
  execFileSync(`${NATIVE}circle-voronoi-bench`, Object.entries(options).flat().map(String), {
    stdio: ['ignore', 'inherit', 'inherit'],
  })
  return JSON.parse(readFileSync(file, 'utf8')).filter((row) => row.repetitions.length === repetitions)
}

function machine(isQuick) {
  const firstLine = (program, args) => execFileSync(program, args, { cwd: ROOT, encoding: 'utf8' }).split('\n')[0]
  const system = existsSync('/etc/os-release') ? readFileSync('/etc/os-release', 'utf8') : ''
  const macros = ['-E', '-dM', '-x', 'c++', '-include', 'CGAL/version.h', '/dev/null']
  const cgal = execFileSync('c++', macros, { encoding: 'utf8' })
  return {
    processor: cpus()[0].model.trim(),
    cores: cpus().length,
    load: loadavg()[2].toFixed(1),
    memory: Math.round(totalmem() / 2 ** 30),
    system: /^PRETTY_NAME="?([^"\n]+)/m.exec(system)?.[1] ?? process.platform,
    node: process.version,
    compiler: firstLine('c++', ['--version']),
    cgal: /#define CGAL_VERSION ([\d.]+)/.exec(cgal)?.[1] ?? 'of unknown version',
    commit: existsSync(`${ROOT}.git`) ? firstLine('git', ['rev-parse', '--short', 'HEAD']) : 'unknown',
    date: new Date().toISOString().slice(0, 10),
    mode: isQuick ? 'quick' : 'full',
  }
}
