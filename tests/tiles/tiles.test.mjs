// SPDX-License-Identifier: GPL-3.0-or-later
// The drivers in examples/tiles: all tiles together write the same lines as one computation of the whole, whatever is
// killed on the way.
import assert from 'node:assert/strict'
import { execFileSync, spawn } from 'node:child_process'
import {
  closeSync,
  mkdtempSync,
  openSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
  writeSync,
} from 'node:fs'
import { tmpdir } from 'node:os'
import { basename, join } from 'node:path'
import { after, before, describe, it } from 'node:test'
import { setTimeout as sleep } from 'node:timers/promises'
import { fileURLToPath } from 'node:url'

const ROOT = fileURLToPath(new URL('../..', import.meta.url))
const NATIVE = `${ROOT}build/native/circle-voronoi`
const PLANE = '-inf,-inf,inf,inf'
const FAMILIES = ['uniform', 'log-uniform', 'clustered', 'intersecting', 'hidden', 'grid-columns']
const EACH = 1700
/** Distant circles, huge ones, one at the corner of a tile, and a duplicate. */
const SINGLES = ['4e6,3,10', '-1e7,-1e7,0', '60,-4000,3960', '20000,30,19700', '25,25,0', '100,100,1', '100,100,1']
const SIZE = 25
const HALO = 8

let folder
let circles
let whole

/** `FAMILIES` side by side in squares of side 100, and `SINGLES`. */
function input() {
  const lines = FAMILIES.flatMap((family, square) => {
    const text = execFileSync(NATIVE, ['generate', family, `${EACH}`], { encoding: 'utf8' })
    const numbers = text
      .trim()
      .split('\n')
      .slice(1)
      .map((line) => line.split(',').map(Number))
    const low = [0, 1].map((k) => Math.min(...numbers.map((circle) => circle[k])))
    const size = Math.max(...numbers.flatMap(([x, y]) => [x - low[0], y - low[1]]))
    const scale = family === 'grid-columns' ? 1 : 100 / size
    return numbers.map(([x, y, r]) =>
      [
        (x - low[0]) * scale + 110 * (square % 3),
        (y - low[1]) * scale + 110 * Math.floor(square / 3),
        r * scale,
      ].join(),
    )
  })
  return ['x,y,r', ...lines, ...SINGLES].join('\n')
}

/** The lines of a table without its header, in a canonical order. */
const rowsOf = (...texts) => texts.flatMap((text) => text.trimEnd().split('\n').slice(1)).sort()

function filesIn(directory) {
  return readdirSync(directory).map((name) => join(directory, name))
}

/** The files of all levels of tiles.py. */
function partsOf(output) {
  return readdirSync(output).flatMap((level) => filesIn(join(output, level, 'parts')))
}

function assertWhole(files) {
  const rows = rowsOf(...files.map((file) => readFileSync(file, 'utf8')))
  assert.equal(rows.length, whole.length)
  assert.ok(rows.every((row, i) => row === whole[i]))
}

/** A wrapper of circle-voronoi that waits before it computes, once some parts exist, until it is released. */
function waiting(output) {
  const [program, gate, isOpen] = ['waiting', 'gate', 'open'].map((name) => `${output}-${name}`)
  execFileSync('mkfifo', [gate])
  const lines = [
    '#!/bin/sh',
    `parts=0; for part in "${join(output, '0', 'parts')}"/*; do parts=$((parts + 1)); done`,
    `if [ "$1" = compute ] && [ $parts -gt 5 ] && [ ! -e "${isOpen}" ]; then read line <"${gate}"; fi`,
    `exec "${NATIVE}" "$@"`,
  ]
  writeFileSync(program, `${lines.join('\n')}\n`, { mode: 0o755 })
  const goOn = () => {
    writeFileSync(isOpen, '')
    // The file stays open, with a line for each process that waits or will wait.
    const end = openSync(gate, 'r+')
    writeSync(end, '\n'.repeat(100))
    return () => closeSync(end)
  }
  return { program, goOn }
}

function dask(output, ...options) {
  const script = `${ROOT}examples/tiles/tiles.py`
  const args = [script, circles, output, '--size', SIZE, '--halo', HALO, '--workers', 2, ...options].map(String)
  // A process group of its own, to be killed as a whole.
  return spawn('/usr/bin/python3', args, { detached: true, stdio: ['ignore', 'ignore', 'pipe'] })
}

/** Waits for a program to end, and returns its status and its output on standard error. */
async function end(child) {
  let said = ''
  child.stderr.setEncoding('utf8').on('data', (text) => {
    said += text
  })
  const status = await new Promise((resolve) => child.on('close', resolve))
  return { status, said }
}

async function until(condition) {
  for (let waited = 0; !condition(); waited += 20) {
    assert.ok(waited < 120_000, 'waited in vain')
    await sleep(20)
  }
}

const doneOf = (output) => {
  try {
    return filesIn(join(output, '0', 'parts')).filter((file) => !basename(file).startsWith('.'))
  } catch {
    return []
  }
}

/** The processes that have started a script of this name and have not yet become another program. */
function parentsOf(program) {
  const processes = readdirSync('/proc').filter((name) => /^\d+$/.test(name))
  return processes.flatMap((process) => {
    try {
      if (readFileSync(`/proc/${process}/cmdline`, 'utf8').split('\0')[1] !== program) return []
      const status = readFileSync(`/proc/${process}/status`, 'utf8')
      return [Number(/^PPid:\s*(\d+)/m.exec(status)[1])]
    } catch {
      return [] // The process has ended already.
    }
  })
}

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-tiles-'))
  circles = join(folder, 'circles.csv')
  writeFileSync(circles, input())
  const output = join(folder, 'whole.csv')
  execFileSync(NATIVE, ['compute', circles, `--known=${PLANE}`, '--max-radius=0', '-o', output])
  whole = rowsOf(readFileSync(output, 'utf8'))
})
after(() => rmSync(folder, { recursive: true, force: true }))

describe('tiles of ten thousand circles', () => {
  it('are of one diagram, with every vertex, edge and hidden circle', () => {
    const stats = JSON.parse(execFileSync(NATIVE, ['compute', circles, '--format', 'stats'], { encoding: 'utf8' }))
    const { hidden, circles: count } = stats.counts
    const counts = ['vertex', 'edge', 'hidden'].map((type) => whole.filter((row) => row.startsWith(type)).length)
    assert.equal(count, FAMILIES.length * EACH + SINGLES.length)
    assert.equal(counts[2], hidden)
    assert.ok(hidden > 100)
    assert.equal(counts[1] - counts[0], count - hidden - 1) // By Euler's formula.
  })

  it('are cut in memory that does not grow with their number', () => {
    // A hundred megabytes, tile after tile.
    const rows = Array.from({ length: 2_000_000 }, (_, i) => `${i / 500_000},${Math.sqrt(i) / 2000},${i * 1e-17}`)
    const command = `ulimit -v 140000; exec "${NATIVE}" tile - --size 1 --halo 0.001 -o "${join(folder, 'long')}"`
    execFileSync('sh', ['-c', command], { input: `x,y,r\n${rows.join('\n')}\n` })
    const homes = readFileSync(join(folder, 'long', 'tiles.txt'), 'utf8')
      .trim()
      .split('\n')
    assert.deepEqual(
      homes.map((line) => line.split(' ').slice(0, 2).join(' ')),
      [0, 1, 2, 3].map((x) => `x${x}y0 500000`),
    )
  })

  it('put together by xargs are the whole', () => {
    const output = join(folder, 'xargs')
    execFileSync(`${ROOT}examples/tiles/tiles.sh`, [circles, SIZE, HALO, output, 2].map(String), {
      env: { ...process.env, CIRCLE_VORONOI: NATIVE },
    })
    const parts = filesIn(join(output, 'parts'))
    assert.ok(parts.length > 60)
    assertWhole(parts)
    // Most circles are final in their tiles.
    assert.ok(readFileSync(join(output, 'parts', 'rest.csv'), 'utf8').split('\n').length < whole.length / 3)
  })

  it('put together by Dask are the whole, through a level of wider tiles', async () => {
    const output = join(folder, 'dask')
    const { status, said } = await end(dask(output, '--program', NATIVE, '--most', 1000))
    assert.equal(status, 0, said)
    assert.match(said, /#{30}\] (\d+) of \1 tiles/)
    assert.deepEqual(readdirSync(output).sort(), ['0', '1', '2'])
    assertWhole(partsOf(output))
  })

  it('are the same if a worker is killed in the middle', async () => {
    const output = join(folder, 'killed-worker')
    const { program, goOn } = waiting(output)
    const child = dask(output, '--program', program)
    const ended = end(child)
    await until(() => doneOf(output).length > 5)
    let workers = []
    await until(() => {
      workers = parentsOf(program)
      return workers.length > 0
    })
    process.kill(workers[0], 'SIGKILL')
    const close = goOn()
    const { status, said } = await ended
    close()
    assert.equal(status, 0, said)
    assertWhole(partsOf(output))
  })

  it('go on where they were if all is killed', async () => {
    const output = join(folder, 'killed')
    const child = dask(output, '--program', waiting(output).program)
    const ended = end(child)
    await until(() => doneOf(output).length > 5)
    process.kill(-child.pid, 'SIGKILL')
    await ended
    const done = doneOf(output).map((file) => [file, statSync(file).mtimeMs])
    assert.ok(done.length < 60)
    // Leaves a file like a program that is killed while it writes.
    writeFileSync(join(output, '0', 'parts', '.circle-voronoi-begun'), readFileSync(done[0][0]))
    const { status, said } = await end(dask(output, '--program', NATIVE))
    assert.equal(status, 0, said)
    assertWhole(partsOf(output))
    for (const [file, time] of done) assert.equal(statSync(file).mtimeMs, time, file)
  })

  it('say what fails', async () => {
    const { status, said } = await end(dask(join(folder, 'failed'), '--program', NATIVE, '--bounds', '1,1,0,0'))
    assert.notEqual(status, 0)
    assert.match(said, /MAXX has to be above MINX/)
  })
})
