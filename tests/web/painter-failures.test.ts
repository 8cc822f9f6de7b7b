// SPDX-License-Identifier: GPL-3.0-or-later
// Two scenes of one painting thread that breaks down at random: every request ends, and afterwards each scene has the
// diagram of its circles.
// @vitest-environment happy-dom
import fc from 'fast-check'
import { afterAll, beforeEach, expect, it, vi } from 'vitest'
import { CircleVoronoiError } from '../../web/lib/index.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { Painter } from '../../web/view/painter.ts'
import type { Facts, FromPainter, InProgress, ToPainter } from '../../web/view/protocol.ts'
import { Failure, Superseded } from '../../web/view/refusal.ts'
import type { Lost, PictureEvents, SceneClient } from '../../web/view/scene-client.ts'
import { styleOf } from '../../web/view/style.ts'
import { action as actionOf, editOf } from './arbitrary-circles.ts'
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
const edit = editOf(circle)
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
  actionOf('open', { scene, circles: fc.array(circle, { maxLength: 8 }), domain: fc.nat(2) }),
  actionOf('edit', { scene, edits: fc.array(edit, { minLength: 1, maxLength: 3 }) }),
  actionOf('edit', { scene, edits: fc.array(edit, { minLength: 1, maxLength: 1 }) }),
  actionOf('layers', { scene, hull: fc.boolean() }),
  actionOf('mark', { scene, id }),
  actionOf('ask', { scene }),
  actionOf('cancel', { scene }),
  actionOf('break', { scene, during: fc.option(fc.constantFrom(...WORK), { nil: undefined }) }),
  actionOf('wait', { scene }),
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

/** The kind of message at which each thread breaks down. */
let breaksAt: ToPainter['kind'] | undefined
let started = 0
class BreakingThread extends ThreadHere {
  constructor(url: URL) {
    super(url)
    started += 1
  }
  override postMessage(data: ToPainter) {
    const failed = { kind: 'failed', message: 'it broke', during: { scene: 1, kind: data.kind } }
    if (data.kind === breaksAt) setImmediate(() => this.onmessage?.({ data: failed }))
    else super.postMessage(data)
  }
}
const STYLE = styleOf(new Proxy({}, { get: () => 'red' }))
const BOX = { left: 0, top: 0, width: 256, height: 256 }
const look = { paintId: 1, grid: { id: 1, x: 0, y: 0, scale: 1, pixelRatio: 1 }, seen: BOX, wanted: BOX }
const layers = { ...DEFAULT_LAYERS, hull: true }
const TWO = Float64Array.of(0, 0, 1, 9, 0, 1)

it.each<[string, (scene: SceneClient) => unknown, number, Lost]>([
  ['layers', (scene) => scene.setLayers(layers), 2, { marks: false, layers: true }],
  ['mark', (scene) => scene.mark(1, undefined), 2, { marks: true, layers: false }],
  ['look', (scene) => scene.look(look, STYLE), 3, { marks: true, layers: true }],
  ['open', (scene) => scene.open(TWO).catch(() => {}), 3, { marks: true, layers: true }],
  ['ask', (scene) => scene.ask('tell', [0]), 2, { marks: false, layers: false }],
])(
  'a thread that breaks down at each %s is replaced by one without it, or by none until the next edit',
  async (kind, act, count, lost) => {
    vi.stubGlobal('Worker', BreakingThread)
    breaksAt = undefined
    started = 0
    const told: Lost[] = []
    const painter = new Painter()
    const scene = painter.add({ ...listener([]), failed: (_, lost) => told.push(lost) })
    await scene.open(TWO)
    scene.setLayers(layers)
    scene.look(look, STYLE)
    scene.mark(0, undefined)
    await quiet()
    breaksAt = kind as ToPainter['kind']
    act(scene)
    await quiet()
    expect([started, told.at(-1)]).toEqual([count, lost])
    breaksAt = undefined
    expect([...(await scene.edit([{ kind: 'insert', circle: [3, 9, 1] }])).inserted]).toEqual([2])
    const drawn = await scene.ask('svg', { x: 0, y: 0, scale: 1, width: 100, height: 100 }, STYLE, [])
    expect([drawn?.elements, drawn?.found.hull !== undefined]).toEqual([expect.stringContaining('<'), !lost.layers])
    painter.dispose()
    vi.stubGlobal('Worker', ThreadHere)
  },
)

it.each([
  ['cannot start', () => {}],
  ['breaks down at its start', BreakingThread],
])('where a thread %s the opening alone says so, and the next one tries again', async (_, Thread) => {
  breaksAt = 'start'
  vi.stubGlobal('Worker', Thread)
  const failures: unknown[] = []
  const scene = new Painter().add(listener(failures))
  await expect(scene.open(TWO)).rejects.toThrow(Failure)
  expect(failures).toEqual([])
  vi.stubGlobal('Worker', ThreadHere)
  expect((await scene.open(TWO)).counts.circles).toBe(2)
})
