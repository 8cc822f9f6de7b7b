// SPDX-License-Identifier: GPL-3.0-or-later
// Two scenes of one painting thread that breaks down at random: every request ends, and afterwards each scene has the
// diagram of its circles.
// @vitest-environment happy-dom
import fc from 'fast-check'
import { afterAll, beforeEach, expect, it, vi } from 'vitest'
import { CircleVoronoiError, type Edit } from '../../web/lib/index.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { Painter } from '../../web/view/painter.ts'
import type { Facts, FromPainter, InProgress } from '../../web/view/protocol.ts'
import { Failure, Superseded } from '../../web/view/refusal.ts'
import type { PictureEvents, SceneClient } from '../../web/view/scene-client.ts'
import { Canvas, Path } from './page-canvas.ts'
import { ThreadHere } from './page-threads.ts'
import { fetchHere } from './whole-page.ts'

const REGION = [0, 1, 2].map((k) => [k === 0 ? -5 : 15, k < 2 ? -5 : 15] as const)
const DOMAINS = [
  { region: null, lattice: null },
  { region: null, lattice: { a: [40, 0], b: [3, 45] } },
  { region: [REGION], lattice: null },
] as const

vi.stubGlobal('fetch', fetchHere)
vi.stubGlobal('Worker', ThreadHere)
vi.stubGlobal('OffscreenCanvas', Canvas)
vi.stubGlobal('Path2D', Path)
afterAll(() => vi.unstubAllGlobals())
beforeEach(() => ThreadHere.endAll())

const circle = fc.record({
  x: fc.integer({ min: 0, max: 20 }),
  y: fc.integer({ min: 0, max: 20 }),
  r: fc.constantFrom(0, 1, 2, 5, -1),
})
const id = fc.nat(9)
const edit: fc.Arbitrary<Edit> = fc.oneof(
  fc.record({ kind: fc.constant('insert' as const), circle }),
  fc.record({ kind: fc.constant('remove' as const), id }),
  fc.record({ kind: fc.constant('replace' as const), id, circle }),
)
const WORK = [
  'open',
  'edit',
  'look',
  'mark',
  'layers',
  'ask',
  'paint',
  'find',
] as const satisfies readonly InProgress['kind'][]
const scene = fc.nat(1)
const action = fc.oneof(
  fc.record({
    kind: fc.constant('open' as const),
    scene,
    circles: fc.array(circle, { maxLength: 8 }),
    domain: fc.nat(2),
  }),
  fc.record({ kind: fc.constant('edit' as const), scene, edits: fc.array(edit, { minLength: 1, maxLength: 3 }) }),
  fc.record({ kind: fc.constant('edit' as const), scene, edits: fc.array(edit, { minLength: 1, maxLength: 1 }) }),
  fc.record({ kind: fc.constant('layers' as const), scene, hull: fc.boolean() }),
  fc.record({ kind: fc.constant('mark' as const), scene, id }),
  fc.record({ kind: fc.constant('ask' as const), scene }),
  fc.record({ kind: fc.constant('cancel' as const), scene }),
  fc.record({
    kind: fc.constant('break' as const),
    scene,
    during: fc.option(fc.constantFrom(...WORK), { nil: undefined }),
  }),
  fc.record({ kind: fc.constant('wait' as const), scene }),
)
type Action = typeof action extends fc.Arbitrary<infer Value> ? Value : never

/** Waits until no message is under way. */
async function quiet(): Promise<void> {
  for (let turns = 0; turns < 5; turns++) {
    await new Promise((resolve) => setTimeout(resolve))
    if (ThreadHere.isBusy) turns = 0
  }
}

function doIt(one: SceneClient, action: Action): Promise<unknown> | undefined {
  switch (action.kind) {
    case 'open': {
      const circles = Float64Array.from(action.circles.flatMap(({ x, y, r }) => [x, y, r]))
      return one.open(circles, DOMAINS[action.domain])
    }
    case 'edit':
      return one.edit(action.edits)
    case 'layers':
      one.setLayers({ ...DEFAULT_LAYERS, hull: action.hull })
      return
    case 'mark':
      one.mark(action.id, undefined)
      return
    case 'ask':
      return one.ask('tell', [0, 1])
    case 'cancel':
      one.cancel()
      return
    case 'break': {
      const [thread] = ThreadHere.running
      if (action.during === undefined) thread?.onerror?.({ message: 'it broke' })
      else {
        const failed: FromPainter = {
          kind: 'failed',
          message: 'it broke',
          during: { scene: action.scene + 1, kind: action.during },
        }
        thread?.onmessage?.({ data: failed })
      }
      return
    }
    case 'wait':
      return quiet()
  }
}

const listener = (failures: unknown[]): PictureEvents => ({
  painted() {},
  marked() {},
  outlined() {},
  found() {},
  failed: (failure) => failures.push(failure),
})

/** Returns what is known of circles in an order that does not depend on earlier edits, nor sums on the order of parts. */
function factsOf(facts: Facts | undefined) {
  const cells = Array.from(facts?.cells ?? [], ([id, cell]) => {
    const [area, perimeter] = [cell.area, cell.perimeter].map((sum) => sum.toPrecision(9))
    return [id, { ...cell, area, perimeter, neighbors: [...cell.neighbors].sort((a, b) => a - b) }]
  })
  return { ...facts, cells }
}

async function play(script: readonly Action[]): Promise<void> {
  const painter = new Painter()
  const failures: unknown[] = []
  const scenes = [painter.add(listener(failures)), painter.add(listener(failures))]
  const domains = [0, 0]
  const asked: Promise<unknown>[] = []
  try {
    for (const action of script) {
      const answer = doIt(scenes[action.scene] as SceneClient, action)
      if (answer === undefined) continue
      const done = answer.then(() => {
        if (action.kind === 'open') domains[action.scene] = action.domain
      })
      done.catch(() => {})
      asked.push(done)
      if (action.kind === 'wait') await done
    }
    // An edit or an opening begins another thread where there is none any more.
    for (const one of scenes) await one.edit([]).catch(() => one.edit([]))
    for (const result of await Promise.allSettled(asked)) {
      if (result.status === 'fulfilled') continue
      const isKnown = [CircleVoronoiError, Superseded, Failure].some((kind) => result.reason instanceof kind)
      expect(isKnown, String(result.reason)).toBe(true)
    }
    expect(failures.every((failure) => failure instanceof Failure)).toBe(true)
    expect(ThreadHere.running.size).toBe(1)
    for (const [k, one] of scenes.entries()) {
      const { circles } = one
      const fresh = painter.add(listener(failures))
      await fresh.open(circles.circles(), DOMAINS[domains[k] as number], circles.keptIds)
      const ids = [...circles.ids()]
      expect(factsOf(await one.ask('tell', ids))).toEqual(factsOf(await fresh.ask('tell', ids)))
      const inserted = await Promise.all(
        [one, fresh].map((each) => each.edit([{ kind: 'insert', circle: [1, 30, 1] }])),
      )
      expect(inserted[0]?.inserted).toEqual(inserted[1]?.inserted)
      fresh.close()
    }
  } finally {
    painter.dispose()
    await quiet()
  }
  expect(ThreadHere.running.size).toBe(0)
}

it('whatever breaks down, every request ends, and each scene has the diagram of its circles', async () => {
  await fc.assert(
    fc.asyncProperty(fc.array(action, { minLength: 1, maxLength: 12 }), (script) => play(script)),
    { numRuns: 40 },
  )
}, 300_000)
