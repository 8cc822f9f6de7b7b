// SPDX-License-Identifier: GPL-3.0-or-later
// Editors on the built package: their memory, the same bits as the native program, and editors in a worker.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { setFlagsFromString } from 'node:v8'
import { runInNewContext } from 'node:vm'
import { loadCircleVoronoi } from '../../dist/lib/index.js'
import { createWorker } from '../../dist/lib/worker.js'

const NATIVE = fileURLToPath(new URL('../../build/native/circle-voronoi', import.meta.url))
const THREE = Float64Array.of(0, 0, 1, 6, 0, 1, 0, 8, 1)
const folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-'))
after(() => rmSync(folder, { recursive: true }))

/** Loads the library, and returns the memory of its module, too. */
async function loadWithMemory() {
  /** @type {any} */
  const web = WebAssembly
  const { instantiate } = web
  let memory
  web.instantiate = async (...args) => {
    const instance = await instantiate(...args)
    memory = Object.values(instance.exports).find((value) => value instanceof WebAssembly.Memory)
    return instance
  }
  try {
    return { library: await loadCircleVoronoi(), memory: () => memory.buffer.byteLength }
  } finally {
    web.instantiate = instantiate
  }
}

function randomNumbers(seed) {
  let state = seed
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0
    return state / 2 ** 32
  }
}

describe('the memory of editors', () => {
  it('does not grow through 100,000 edits', async () => {
    const { library, memory } = await loadWithMemory()
    const random = randomNumbers(1)
    const circle = () => [100 * random(), 100 * random(), random() ** 4]
    const editor = library.edit(Array.from({ length: 1000 }, circle))
    const kept = Array.from(editor.ids())
    let grown
    for (let i = 0; i < 100_000; i++) {
      const k = Math.floor(random() * kept.length)
      if (i % 4 === 0) {
        editor.remove(kept[k])
        kept[k] = editor.insert(circle()).inserted[0]
      } else {
        editor.replace(kept[k], circle())
      }
      if (i === 20_000) grown = memory()
    }
    assert.equal(memory(), grown)
    assert.equal(editor.size(), 1000)
    assert.equal(editor.certificate().certified, true)
    editor.dispose()
  })

  it('is free again once they are disposed of', async () => {
    const { library, memory } = await loadWithMemory()
    const circles = Float64Array.from({ length: 6000 }, randomNumbers(2))
    let grown
    for (let i = 0; i < 100; i++) {
      library.edit(circles)[Symbol.dispose ?? 'dispose']()
      if (i === 5) grown = memory()
    }
    assert.equal(memory(), grown)
  })

  it('is free again once they are forgotten', async () => {
    setFlagsFromString('--expose-gc')
    const collectGarbage = runInNewContext('gc')
    const { library, memory } = await loadWithMemory()
    const circles = Float64Array.from({ length: 6000 }, randomNumbers(3))
    let forgotten = 0
    const registry = new FinalizationRegistry(() => {
      forgotten += 1
    })
    let grown
    for (let i = 0; i < 60; i++) {
      registry.register(library.edit(circles), undefined)
      // Finalizers run in turns of the event loop, so that other editors are finalized next to this one.
      while (forgotten <= i) {
        collectGarbage()
        await new Promise(setImmediate)
      }
      await new Promise(setImmediate)
      if (i === 20) grown = memory()
    }
    assert.equal(memory(), grown)
  })
})

describe('the same changes and bits as the native program', () => {
  for (const [family, count] of /** @type {const} */ ([
    ['uniform', 120],
    ['grid', 49],
    ['hidden', 90],
    ['intersecting', 60],
    ['collinear', 12],
    ['duplicates', 40],
    ['one-huge', 60],
    ['near-nested', 40],
    ['extreme', 20],
  ])) {
    it(family, async () => {
      const library = await loadCircleVoronoi()
      const names = ['circles.csv', 'edits.csv', 'changes.jsonl'].map((name) => join(folder, `${family}-${name}`))
      const [circlesFile, scriptFile, changesFile] = names
      execFileSync(NATIVE, ['generate', family, String(2 * count), '--seed', '3', '-o', circlesFile])
      const lines = readFileSync(circlesFile, 'utf8').trim().split('\n')
      const rows = lines.slice(1).map((line) => line.split(',').map(Number))
      const start = rows.slice(0, count)
      writeFileSync(circlesFile, [lines[0], ...start.map(String)].join('\n'))

      const random = randomNumbers(4)
      const editor = library.edit(start)
      const script = []
      const removed = []
      const changes = []
      editor.onchange = ({ revision: _, ...change }) =>
        changes.push(
          JSON.parse(
            JSON.stringify(change, (_, value) => (ArrayBuffer.isView(value) ? [.../** @type {any} */ (value)] : value)),
          ),
        )
      for (let i = 0; i < 150; i++) {
        const ids = editor.ids()
        const id = ids[Math.floor(random() * ids.length)]
        const [x, y, r] = rows[Math.floor(random() * rows.length)]
        const old = /** @type {import('../../dist/lib/index.js').Circle} */ (editor.circle(id))
        const step = i % 3 === 0 ? [x, y, r] : [old.x + (x - old.x) / 64, old.y + (y - old.y) / 64, i % 2 ? old.r : r]
        if (i % 7 === 0 && ids.length > 4) {
          editor.remove(id)
          removed.push(id)
          script.push(`remove,${id}`)
        } else if (i % 14 === 2 && removed.length > 0) {
          const former = removed.shift()
          editor.apply([{ kind: 'insert', circle: [x, y, r], id: former }])
          script.push(`insert,${[former, x, y, r]}`)
        } else if (i % 7 === 1) {
          editor.insert([x, y, r])
          script.push(`insert,${[x, y, r]}`)
        } else {
          editor.replace(id, step)
          script.push(`replace,${[id, ...step]}`)
        }
      }
      writeFileSync(scriptFile, script.join('\n'))
      const output = execFileSync(NATIVE, ['edit', circlesFile, '--script', scriptFile, '--changes', changesFile])
      const native = JSON.parse(output.toString())
      const lists = readFileSync(changesFile, 'utf8')
        .trim()
        .split('\n')
        .map((line) => JSON.parse(line))
      // JSON.stringify loses the sign of a zero.
      const signless = (value) => JSON.parse(JSON.stringify(value))
      assert.deepStrictEqual(changes, signless(lists))
      const snapshot = editor.snapshot()
      assert.deepStrictEqual(
        [...snapshot.vertices],
        native.vertices.flatMap(({ x, y, r: radius }) => [x, y, radius]),
      )
      assert.deepStrictEqual(
        [...snapshot.edges],
        native.edges.flatMap((edge) => [...edge.circles, ...edge.vertices]),
      )
      assert.deepStrictEqual(
        [...snapshot.hidden],
        native.hidden.flatMap(({ circle, by }) => [circle, by]),
      )
      assert.deepStrictEqual([...snapshot.hull], native.hull)
      editor.dispose()
    })
  }
})

describe('an editor in a worker', () => {
  const worker = createWorker()
  after(() => worker.dispose())
  /** The arrays that must be equal for two diagrams of the same editor. */
  const arraysOf = ({ circles, vertices, vertexCircles, edges, hidden, hull }) => [
    ...[circles, vertices, vertexCircles, edges, hidden, hull],
  ]

  it('does what one here does', async () => {
    const here = (await loadCircleVoronoi()).edit(THREE)
    const there = await worker.edit(THREE)
    const told = []
    const back = /** @type {const} */ ({ kind: 'insert', circle: [6, 0, 1], id: 1 })
    there.onchange = (change) => told.push(change)
    const diagram = await there.snapshot()
    const changes = [
      [here.insert([2, 2, 0.5]), await there.insert([2, 2, 0.5])],
      [here.replace(3, [0, 0, 3]), await there.replace(3, { x: 0, y: 0, r: 3 })],
      [here.apply([{ kind: 'remove', id: 1 }]), await there.apply([{ kind: 'remove', id: 1 }])],
      [here.apply([back]), await there.apply([back])],
      [here.remove(1), await there.remove(1)],
    ]
    for (const [one, other] of changes) assert.deepEqual(other, one)
    assert.deepEqual(
      told,
      changes.map(([change]) => change),
    )
    for (const change of told) diagram.apply(change)
    assert.deepEqual(arraysOf(await there.snapshot()), arraysOf(here.snapshot()))
    assert.equal(diagram.find(0.5, 7), diagram.indexOf(2))
    assert.equal(await there.nearest(0, 9), 2)
    assert.equal(await there.size(), 3)
    assert.equal(await there.isHidden(0), true)
    assert.deepEqual(await there.circle(3), { x: 0, y: 0, r: 3 })
    assert.equal(await there.circle(1), undefined)
    assert.deepEqual([...(await there.ids())], [0, 2, 3])
    assert.equal((await there.certificate()).certified, true)
    there.dispose()
  })

  it('merges what a drag has left behind', async () => {
    const editor = await worker.edit(THREE)
    const changes = []
    editor.onchange = (change) => changes.push(change)
    const places = Array.from({ length: 500 }, (_, k) => [6 + k / 500, 0, 1])
    const drag = places.map((circle) => editor.replace(1, circle))
    const other = editor.replace(2, [0, 9, 1])
    const results = await Promise.all([...drag, other])
    // The first edit has begun. After it, the last edit of each circle remains.
    assert.equal(changes.length, 3)
    assert.deepEqual(results.slice(1, 500), Array(499).fill(changes[1]))
    assert.deepEqual(await editor.circle(1), { x: 6 + 499 / 500, y: 0, r: 1 })
    editor.dispose()
  })

  it('keeps the order of what is not merged', async () => {
    const editor = await worker.edit(THREE)
    const busy = editor.insert([2, 2, 1])
    /** @type {{ value?: any, reason?: any }[]} */
    const [, before, , after_, removed, late] = await Promise.allSettled([
      editor.replace(1, [7, 0, 1]),
      editor.circle(1),
      editor.replace(1, [8, 0, 1]),
      editor.circle(1),
      editor.remove(1),
      editor.replace(1, [9, 0, 1]),
    ])
    await busy
    assert.deepEqual(before.value, { x: 7, y: 0, r: 1 })
    assert.deepEqual(after_.value, { x: 8, y: 0, r: 1 })
    assert.deepEqual([...removed.value.removed], [1])
    assert.equal(late.reason.code, 'unknownCircle')
    // The circle is removed before its replacement has begun, which is then dropped.
    const replaced = [editor.insert([3, 3, 1]), editor.replace(0, [1, 1, 1]), editor.remove(0)]
    const [, one, two] = await Promise.all(replaced)
    assert.equal(one, two)
    assert.deepEqual([...one.removed], [0])
    editor.dispose()
  })

  it('rejects with the errors of an editor, and an edit stands whose listener throws', async (t) => {
    const editor = await worker.edit(THREE)
    const rejects = (promise, code, circle) => assert.rejects(promise, { name: 'CircleVoronoiError', code, circle })
    await rejects(editor.remove(7), 'unknownCircle', 7)
    await rejects(editor.replace(1, [0, 0, -1]), 'negativeRadius', 1)
    await rejects(editor.insert([0, 0]), 'badInput', undefined)
    await rejects(editor.apply(/** @type {any} */ ([{ kind: 'move' }])), 'badInput', undefined)
    await rejects(editor.nearest(/** @type {any} */ ('0'), 0), 'badInput', undefined)
    await rejects(worker.edit([[0, 0, -1]]), 'negativeRadius', 0)
    await rejects(worker.edit(/** @type {any} */ ('circles')), 'badInput', undefined)
    editor.onchange = () => {
      throw new RangeError('mine')
    }
    // Errors of listeners become uncaught errors.
    const reported = []
    t.mock.method(globalThis, 'queueMicrotask', (report) => reported.push(report))
    assert.deepEqual([...(await editor.remove(0)).removed], [0])
    assert.equal(reported.length, 1)
    assert.throws(reported[0], new RangeError('mine'))
    assert.equal(await editor.size(), 2)
    editor.dispose()
  })

  it('computes beside it, and ends with its worker or on its own', async () => {
    const mine = createWorker()
    const [one, other] = [await mine.edit(THREE, { ids: [4, 5, 9], nextId: 20 }), await mine.edit([])]
    assert.deepEqual([...(await one.insert([2, 2, 1])).inserted], [20])
    assert.equal((await mine.compute(THREE)).certificate.certified, true)
    const pending = one.insert([1, 1, 1])
    one.dispose()
    await assert.rejects(pending, { name: 'AbortError' })
    await assert.rejects(one.size(), { name: 'AbortError' })
    assert.equal(await other.size(), 0)
    mine.dispose()
    await assert.rejects(other.size(), { name: 'AbortError' })
    await assert.rejects(mine.edit(THREE), { name: 'AbortError' })
  })

  it('does not keep Node from ending', () => {
    const client = new URL('../../dist/lib/worker.js', import.meta.url).href
    const script = `
      import { createWorker } from ${JSON.stringify(client)}
      const editor = await createWorker().edit([{ x: 0, y: 0, r: 1 }])
      editor.insert([5, 5, 1]).then(({ inserted }) => console.log(inserted[0]))
    `
    const printed = execFileSync(process.execPath, ['--input-type=module', '--eval', script], { timeout: 60_000 })
    assert.equal(printed.toString(), '1\n')
  })
})
