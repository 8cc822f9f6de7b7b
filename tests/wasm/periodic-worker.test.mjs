// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic diagrams and fits in a real worker in Node, on the built package.
import assert from 'node:assert/strict'
import { after, describe, it } from 'node:test'
import { loadCircleVoronoi } from '../../dist/lib/index.js'
import { loadRegions } from '../../dist/lib/regions.js'
import { createWorker } from '../../dist/lib/worker.js'

const BOX = /** @type {const} */ ({ a: [40, 0], b: [10, 30] })
const CIRCLES = Array.from({ length: 300 }, (_, i) => [(i * 24.721) % 40, (i * 12.426) % 30, (i % 7) / 10])

const worker = createWorker()
after(() => worker.dispose())

describe('a worker', () => {
  it('fits areas in a box without any module loaded here, as the library does', async () => {
    const areas = CIRCLES.map((_, i) => 1 + (i % 3))
    const errors = []
    const onStep = ({ error }) => errors.push(error)
    const there = await worker.fitAreas(CIRCLES, areas, { lattice: BOX, shares: true, onStep })
    const { fitAreas } = await loadRegions()
    const here = fitAreas(CIRCLES, areas, { lattice: BOX, shares: true })
    assert.deepEqual(there.weights, here.weights)
    assert.deepEqual(there.areas, here.areas)
    assert.deepEqual(there.periodic.shiftOf, here.periodic.shiftOf)
    assert.equal(errors.length, there.steps + 1)
    assert.equal(errors.at(-1), there.error)
    await assert.rejects(worker.fitAreas(CIRCLES, areas, { lattice: BOX }), { code: 'badInput' })
  })

  it('computes periodic diagrams, to the bit', async () => {
    const here = (await loadCircleVoronoi()).computePeriodic(CIRCLES, BOX)
    const stages = new Set()
    const there = await worker.computePeriodic(CIRCLES, BOX, { progress: (stage) => stages.add(stage) })
    assert.deepEqual(there.diagram.vertices, here.diagram.vertices)
    assert.deepEqual(there.circleOf, here.circleOf)
    assert.deepEqual(there.shiftOf, here.shiftOf)
    assert.deepEqual(there.lattice, here.lattice)
    assert.deepEqual(there.neighbors(7), here.neighbors(7))
    assert.ok(stages.size > 0)
  })

  it('rejects with the errors of computePeriodic, and cancels', async () => {
    const parallel = /** @type {const} */ ({ a: [1, 0], b: [2, 0] })
    await assert.rejects(worker.computePeriodic(CIRCLES, parallel), { code: 'badOption' })
    await assert.rejects(worker.computePeriodic([[0, 0, -1]], BOX), { code: 'negativeRadius', circle: 0 })
    await assert.rejects(worker.computePeriodic(CIRCLES, BOX, { signal: AbortSignal.abort('enough') }), (reason) => {
      assert.equal(reason, 'enough')
      return true
    })
  })
})
