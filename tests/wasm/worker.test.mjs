// SPDX-License-Identifier: GPL-3.0-or-later
// The worker client in Node, on the built package.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { after, describe, it } from 'node:test'
import { loadCircleVoronoi } from '../../dist/lib/index.js'
import { loadMetrics } from '../../dist/lib/metrics.js'
import { loadRegions } from '../../dist/lib/regions.js'
import { createWorker } from '../../dist/lib/worker.js'

const CLIENT = new URL('../../dist/lib/worker.js', import.meta.url).href
const WASM = new URL('../../dist/lib/generated/circle-voronoi.wasm', import.meta.url)
const THREE = Float64Array.of(0, 0, 1, 10, 0, 2, 4, 9, 3)
/** Enough circles for a computation that is still running when something else happens. */
const MANY = Float64Array.from({ length: 3 * 40_000 }, (_, k) => {
  const i = Math.floor(k / 3)
  return [i % 200, Math.floor(i / 200), (i % 7) / 20][k % 3]
})
const SLOWLY = /** @type {const} */ ({ method: 'touching-disc' })

const worker = createWorker()
after(() => worker.dispose())

/** Aborts by `signal` when the computation with `progress` has begun its event loop. */
function abortedWhenTouching(reason) {
  const controller = new AbortController()
  const progress = (stage) => stage === 'touch' && controller.abort(reason)
  return { ...SLOWLY, progress, signal: controller.signal }
}

describe('compute', () => {
  it('gives what compute gives, with its methods', async () => {
    const here = (await loadCircleVoronoi()).compute(MANY)
    const there = await worker.compute(MANY)
    for (const name of [
      'circles',
      'vertices',
      'vertexCircles',
      'edges',
      'hidden',
      'hull',
      'nextSide',
      'vertexSides',
      'firstSide',
    ]) {
      assert.deepEqual(there[name], here[name], name)
    }
    assert.deepEqual(there.certificate, here.certificate)
    assert.equal(there.find(3.1, 4.1), here.find(3.1, 4.1))
  })

  it('takes a metric and weights of any sign, and loads what they need with the first such question', async () => {
    const circles = MANY.map((value, k) => (k % 6 === 5 ? -value : value))
    const options = /** @type {const} */ ({ metric: 'power', weights: true })
    const stages = []
    const there = await worker.compute(circles, { ...options, progress: (stage) => stages.push(stage) })
    const { compute } = await loadMetrics()
    const { stats: _here, ...here } = compute(circles, options)
    const { stats: _there, ...rest } = there
    assert.deepEqual({ ...rest }, { ...here })
    assert.ok(stages.includes('certify'))
    assert.deepEqual((await worker.compute(THREE, { metric: 'centers' })).metric, 'centers')
    await assert.rejects(worker.compute(THREE, { metric: /** @type {any} */ ('magic') }), { code: 'badOption' })
    await assert.rejects(worker.compute([[0, 0, -1]], { metric: 'power' }), { code: 'negativeRadius', circle: 0 })
    const signal = AbortSignal.abort('before')
    await assert.rejects(worker.compute(THREE, { metric: 'power', signal }), (reason) => reason === 'before')
  })

  it('leaves the input to its owner', async () => {
    const input = THREE.slice()
    const promise = worker.compute(input)
    input[0] = 99
    assert.deepEqual((await promise).circles, THREE)
    assert.equal(input.length, THREE.length)
  })

  it('takes objects', async () => {
    assert.equal((await worker.compute([{ x: 1, y: 2, r: 3 }])).circles.length, 3)
    assert.equal((await worker.compute([])).circles.length, 0)
  })

  it('takes data and the functions that find circles in them, which stay here', async () => {
    const library = await loadCircleVoronoi()
    const data = [
      [0, 0, 'a'],
      [10, 0, 'b'],
    ]
    /** @type {any} */
    const functions = { x: (datum) => datum[0], r: (_, i) => i }
    assert.deepEqual((await worker.compute(data, functions)).circles, Float64Array.of(0, 0, 0, 10, 0, 1))
    const box = /** @type {const} */ ({ a: [20, 0], b: [0, 20] })
    const { diagram } = await worker.computePeriodic(data, box, functions)
    assert.deepEqual(diagram.vertices, library.computePeriodic(data, box, functions).diagram.vertices)
  })

  it('does not hold up what goes on here', async () => {
    let turns = 0
    let isOver = false
    const turn = () => {
      turns += 1
      if (!isOver) setImmediate(turn)
    }
    let isTold = false
    const progress = () => {
      isTold = true
    }
    setImmediate(turn)
    await worker.compute(MANY, { ...SLOWLY, progress })
    isOver = true
    assert.ok(isTold)
    assert.ok(turns > 0, 'no turn of the event loop between the question and the result')
  })

  it('answers in the order of the questions', async () => {
    const order = []
    const ask = (name, circles) => worker.compute(circles).then(() => order.push(name))
    await Promise.all([ask('first', MANY), ask('second', THREE), ask('third', THREE)])
    assert.deepEqual(order, ['first', 'second', 'third'])
  })

  it('rejects with the errors of compute', async () => {
    const matches = (code, circle) => ({ name: 'CircleVoronoiError', code, circle })
    await assert.rejects(worker.compute(Float64Array.of(0, 0, 1, 5, 0, -1)), matches('negativeRadius', 1))
    await assert.rejects(worker.compute(/** @type {any} */ ('0,0,1')), matches('badInput', undefined))
    await assert.rejects(
      worker.compute(THREE, { method: /** @type {any} */ ('magic') }),
      matches('badOption', undefined),
    )
    await assert.rejects(worker.compute(THREE, { progress: /** @type {any} */ (1) }), matches('badOption', undefined))
  })
})

describe('fitAreas', () => {
  const random = (seed) => () => {
    seed = (seed * 48_271) % 2_147_483_647
    return seed / 2_147_483_647
  }

  it('reaches areas far from the origin and in parts that touch in a corner', async () => {
    const { region, fitAreas } = await loadRegions()
    const square = (x, y) => [
      [x, y],
      [x + 1, y],
      [x + 1, y + 1],
      [x, y + 1],
    ]
    for (const far of [5e6, 1e12]) {
      const next = random(7)
      const place = () => far + Math.round(1024 * next()) / 1024
      const sites = Array.from({ length: 10 }, () => [place(), place()])
      const areas = sites.map((_, k) => k + 1)
      const fit = fitAreas(sites, areas, { region: region([square(far, far)]), shares: true })
      assert.equal(fit.tolerance, 1e-9)
      assert.ok(fit.error <= 1e-9)
      for (const [k, area] of fit.areas.entries()) assert.ok(Math.abs(area * 55 - areas[k]) < 1e-7)
    }
    const corners = region([square(0, 0), square(1, 1)])
    const sites = [
      [0, 0],
      [2, 2],
    ]
    const { areas } = fitAreas(sites, [3, 1], { region: corners, shares: true })
    assert.ok(Math.abs(areas[0] - 1.5) < 1e-8)
  })

  it('gives what the library gives, to the bit, with the same steps', async () => {
    const { region, fitAreas } = await loadRegions()
    const hall = region([
      [
        [0, 0],
        [9, 0],
        [9, 9],
        [0, 9],
      ],
      [
        [3, 3],
        [6, 3],
        [6, 6],
        [3, 6],
      ],
    ])
    const next = random(1)
    const sites = Array.from({ length: 200 }, () => [9 * next(), 9 * next()])
    const shares = sites.map(() => 1 + 9 * next())
    /** @type {Record<'here' | 'there', import('../../dist/lib/regions.js').FitStep[]>} */
    const steps = { here: [], there: [] }
    const options = (told) => ({ region: hall, shares: true, onStep: (step) => told.push(step) })
    const here = fitAreas(sites, shares, options(steps.here))
    const there = await worker.fitAreas(sites, shares, options(steps.there))
    assert.deepEqual(there.weights, here.weights)
    assert.deepEqual(there.areas, here.areas)
    assert.deepEqual(there.diagram.vertices, here.diagram.vertices)
    assert.deepEqual([there.error, there.steps], [here.error, here.steps])
    assert.deepEqual(steps.there, steps.here)
    assert.ok(steps.here.length > 2)
    assert.deepEqual(there.diagram.cellAreas({ region: hall }), here.areas)
    // A fit that does not converge returns the weights of its last step.
    await assert.rejects(worker.fitAreas(sites, shares, { region: hall, shares: true, maxSteps: 2 }), {
      code: 'notConverged',
      weights: steps.here[2].weights,
    })
  })

  it('is canceled by a signal, and the worker goes on', async () => {
    const { region } = await loadRegions()
    const square = region([
      [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 1],
      ],
    ])
    const next = random(2)
    const sites = Array.from({ length: 3000 }, () => [next(), next()])
    const controller = new AbortController()
    const { signal } = controller
    const onStep = ({ steps }) => steps === 1 && controller.abort('enough')
    const shares = sites.map(() => 1)
    await assert.rejects(
      worker.fitAreas(sites, shares, { region: square, shares: true, signal, onStep }),
      (reason) => reason === 'enough',
    )
    const two = await worker.fitAreas(
      [
        [0.2, 0.5],
        [0.8, 0.5],
      ],
      [0.5, 0.5],
      { region: square },
    )
    assert.deepEqual([...two.areas], [0.5, 0.5])
    await assert.rejects(worker.fitAreas([[0.2, 0.5]], [0.5], { region: square }), { code: 'badInput' })
  })
})

describe('progress', () => {
  it('tells the stages and the part of the event loop that is done', async () => {
    const told = []
    await worker.compute(MANY, { ...SLOWLY, progress: (stage, done) => told.push({ stage, done }) })
    assert.deepEqual(
      [...new Set(told.map(({ stage }) => stage))],
      ['order', 'triangulate', 'sample', 'pair', 'touch', 'certify', 'assemble'],
    )
    assert.ok(told.some(({ done }) => done > 0 && done < 1))
  })

  it('that throws cancels, and the worker goes on', async () => {
    let calls = 0
    const progress = () => {
      calls += 1
      throw new RangeError('mine')
    }
    await assert.rejects(worker.compute(MANY, { ...SLOWLY, progress }), new RangeError('mine'))
    assert.equal((await worker.compute(THREE)).certificate.certified, true)
    assert.equal(calls, 1)
  })
})

describe('signal', () => {
  it('cancels what runs, and what waits comes next', async () => {
    const reason = new Error('changed my mind')
    /** @type {{ value?: any, reason?: any }[]} */
    const [canceled, next] = await Promise.allSettled([
      worker.compute(MANY, abortedWhenTouching(reason)),
      worker.compute(THREE),
    ])
    assert.equal(canceled.reason, reason)
    assert.equal(next.value.certificate.certified, true)
  })

  it('cancels what waits, and what runs goes on', async () => {
    const controller = new AbortController()
    const running = worker.compute(MANY)
    const waiting = worker.compute(THREE, { signal: controller.signal })
    const last = worker.compute(THREE)
    controller.abort()
    await assert.rejects(waiting, { name: 'AbortError' })
    assert.equal((await running).circles.length, MANY.length)
    assert.equal((await last).circles.length, THREE.length)
  })

  it('cancels what has only just been asked', async () => {
    const controller = new AbortController()
    const promise = worker.compute(THREE, { signal: controller.signal })
    controller.abort('at once')
    await assert.rejects(promise, (reason) => reason === 'at once')
  })

  it('that is aborted already cancels at once', async () => {
    await assert.rejects(worker.compute(THREE, { signal: AbortSignal.abort('before') }), (reason) => {
      return reason === 'before'
    })
  })

  it('has no say when all is done', async () => {
    const controller = new AbortController()
    const first = await worker.compute(THREE, { signal: controller.signal })
    const second = worker.compute(MANY)
    controller.abort()
    assert.equal(first.circles.length, THREE.length)
    assert.equal((await second).circles.length, MANY.length)
  })
})

describe('dispose', () => {
  it('cancels all there is to do, and all that comes', async () => {
    const disposed = createWorker()
    const promises = [disposed.compute(MANY), disposed.compute(THREE)]
    disposed.dispose()
    promises.push(disposed.compute(THREE))
    await Promise.all(promises.map((promise) => assert.rejects(promise, { name: 'AbortError' })))
    disposed.dispose()
  })

  it('stops the thread in the middle of a computation', async () => {
    const disposed = createWorker()
    const progress = (stage) => stage === 'touch' && disposed[Symbol.dispose]()
    await assert.rejects(disposed.compute(MANY, { ...SLOWLY, progress }), { name: 'AbortError' })
  })
})

describe('Node', () => {
  const run = (script) =>
    execFileSync(process.execPath, ['--input-type=module', '--eval', script], { encoding: 'utf8', timeout: 60_000 })

  it('waits for what runs, and ends while the worker is idle', () => {
    const printed = run(`
      import { createWorker } from ${JSON.stringify(CLIENT)}
      const worker = createWorker()
      worker.compute([{ x: 0, y: 0, r: 1 }]).then(() =>
        worker.compute([{ x: 0, y: 0, r: 1 }, { x: 3, y: 0, r: 1 }]).then(({ edges }) => console.log(edges.length)))
    `)
    assert.equal(printed, '4\n')
  })
})

describe('the WebAssembly', () => {
  it('comes from where the caller says', async () => {
    for (const wasm of [readFileSync(WASM), new WebAssembly.Module(readFileSync(WASM)), WASM, WASM.href]) {
      const other = createWorker({ wasm })
      assert.equal((await other.compute(THREE)).certificate.certified, true)
      other.dispose()
    }
  })

  it('that is missing is an error, each time', async () => {
    const other = createWorker({ wasm: new URL('missing.wasm', WASM) })
    for (const _ of [1, 2]) await assert.rejects(other.compute(THREE), { code: 'notLoaded' })
    other.dispose()
  })

  it('that is another is an error, each time', async () => {
    const other = createWorker({ wasm: Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0) })
    for (const _ of [1, 2]) await assert.rejects(other.compute(THREE), { code: 'notLoaded' })
    other.dispose()
  })
})
