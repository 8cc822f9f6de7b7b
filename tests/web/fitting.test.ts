// SPDX-License-Identifier: GPL-3.0-or-later
// A figure with its threads while areas are fitted, which takes as long as a test needs.
// @vitest-environment happy-dom
import fc from 'fast-check'
import { afterEach, beforeEach, describe, expect, it } from 'vitest'
import type { Edit } from '../../web/lib/index.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import type { ToThread } from '../../web/lib/threads/channel.ts'
import type { Areas, Domain } from '../../web/view/domain.ts'
import { ThreadHere } from './page-threads.ts'
import { newFigure } from './whole-figure.ts'
import { quiet, soon, surround } from './whole-page.ts'

const FOUR = [1, 1, 1, 7, 1, 0.5, 4, 6, 2, 2, 7, 0]
const REGION = [
  [
    [0, 0],
    [9, 0],
    [9, 8],
    [0, 9],
  ],
] as const
const MOVED = [{ kind: 'replace', id: 0, circle: { x: 2, y: 2, r: 1 } }] as const

/** A thread that holds the request for a fit or crashes at it. */
class FittingThread extends ThreadHere {
  static at: 'go' | 'hold' | 'crash' = 'go'
  /** The thread of the last fit, and its request if that is held. */
  static last: { readonly thread: FittingThread; readonly release: () => void } | undefined

  override postMessage(data: ToThread) {
    const post = () => super.postMessage(data)
    if (!('name' in data) || data.name !== 'fit') return post()
    FittingThread.last = { thread: this, release: post }
    if (FittingThread.at === 'crash') setImmediate(() => this.onerror?.({ message: 'it broke' }))
    else if (FittingThread.at === 'go') post()
  }
}

const isRunning = (thread: ThreadHere | undefined) => thread !== undefined && ThreadHere.running.has(thread)
const isFitting = () => soon(() => expect(isRunning(FittingThread.last?.thread)).toBe(true))

surround()
Object.assign(globalThis, { Worker: FittingThread })
const { region, fitAreas } = await loadRegions()

let figure: ReturnType<typeof newFigure>
let problems: Error[]
let painting: ThreadHere | undefined
beforeEach(async () => {
  FittingThread.at = 'go'
  FittingThread.last = undefined
  document.body.innerHTML = ''
  problems = []
  figure = newFigure({ onproblem: (error) => problems.push(error) })
  await open(FOUR)
  await figure.setDomain({ region: REGION, areas: undefined })
  await quiet()
  painting = [...ThreadHere.running][0]
})
afterEach(async () => {
  figure.dispose()
  await quiet()
  expect(ThreadHere.running.size).toBe(0)
})

const open = (circles: readonly number[], domain?: Domain, edits?: readonly Edit[]) =>
  figure.open({ circles: Float64Array.from(circles), dataSet: '', isEdited: false, domain, edits })
const fitTo = (areas: Areas = 'equal') => figure.setDomain({ region: REGION, areas })
const circles = () => [...figure.editing.circles.circles()]
const state = () => {
  const { camera, layers, history, domain, selection, edited } = figure.store.get()
  return { circles: circles(), camera, layers, history, domain, selection, edited }
}
/** The circles with the radii that the core finds. */
const fittedByCore = (sites: readonly number[], areas: readonly number[]) => {
  const { weights } = fitAreas(Float64Array.from(sites), areas, {
    region: region(REGION),
    shares: true,
    tolerance: 1e-6,
  })
  return sites.map((value, k) => (k % 3 === 2 ? (weights[(k - 2) / 3] as number) : value))
}

it('while areas are fitted, the last diagram is painted at another scale, and then come the areas', async () => {
  FittingThread.at = 'hold'
  const before = circles()
  const done = fitTo()
  await isFitting()
  const { camera } = figure.view
  figure.view.setCamera({ ...camera, scale: 2 * camera.scale })
  await soon(() => expect(figure.element.ariaBusy).toBe('true'))
  await soon(() => expect(figure.element.ariaBusy).toBe('false'))
  expect([circles(), figure.store.get().edited?.fitted]).toEqual([before, undefined])
  expect((await figure.view.scene.ask('tell', [[2]]))?.cells.get(2)?.r).toBe(2)
  FittingThread.last?.release()
  await done
  expect([circles(), figure.view.camera.scale]).toEqual([fittedByCore(FOUR, [1, 1, 1, 1]), 2 * camera.scale])
  expect(figure.store.get().edited?.fitted?.error).toBeLessThan(1e-6)
})

describe('a fit', () => {
  const place = fc.tuple(fc.integer({ min: 1, max: 80 }), fc.integer({ min: 1, max: 70 }))
  const places = fc.uniqueArray(place, { selector: String, minLength: 5, maxLength: 15 })

  it('finds the radii of the core bit for bit, in an opening and in edits, which are one step of undo each', async () => {
    await fc.assert(
      fc.asyncProperty(places, fc.infiniteStream(fc.constantFrom(1, 2, 3)), async (given, numbers) => {
        const [moved, inserted, ...rest] = given.map(([x, y]) => ({ x: x / 10, y: y / 10, r: 0 }))
        const sites = rest.flatMap(({ x, y, r }) => [x, y, r])
        const areas = rest.map(() => numbers.next().value)
        await open(sites, { region: REGION, areas })
        expect(circles()).toEqual(fittedByCore(sites, areas))
        const opened = circles()
        const edits: Edit[] = [
          { kind: 'remove', id: 1 },
          { kind: 'insert', circle: inserted as NonNullable<typeof inserted> },
          { kind: 'replace', id: 0, circle: moved as NonNullable<typeof moved> },
        ]
        await figure.editing.edit(edits)
        const kept = areas.filter((_, k) => k !== 1)
        const mean = kept.reduce((sum, area) => sum + area, 0) / kept.length
        const asked = [moved?.x, moved?.y, 0, ...opened.slice(6), inserted?.x, inserted?.y, 0] as number[]
        expect(circles()).toEqual(fittedByCore(asked, [...kept, mean]))
        await figure.editing.undo()
        expect(circles()).toEqual(opened)
        await figure.editing.undo()
        expect(problems).toEqual([])
        expect(ThreadHere.running.size).toBe(2)
      }),
      { numRuns: 20 },
    )
  })

  it.each([
    ['an edit', () => fitTo()],
    ['an opening', () => open([3, 3, 1, 5, 5, 1], { region: REGION, areas: 'equal' }, MOVED)],
    ['an undo', () => figure.actions.circles.undo()],
  ] as const)('of %s that is canceled ends with its thread, and nothing has changed', async (_, act) => {
    await fitTo()
    await fitTo([1, 2, 3, 4])
    figure.view.setLayers({ hull: true })
    figure.actions.selection.select([1])
    await quiet()
    const before = state()
    const idle = FittingThread.last?.thread
    FittingThread.at = 'hold'
    const done = act()
    await soon(() => expect(FittingThread.last?.release).toBeDefined())
    await isFitting()
    await quiet()
    figure.actions.opening.cancelOpening()
    await done
    await quiet()
    expect(state()).toEqual(before)
    expect([...ThreadHere.running]).toEqual([painting])
    expect([isRunning(idle), problems]).toEqual([false, []])
    FittingThread.at = 'go'
    await figure.editing.edit(MOVED)
    expect([circles().slice(0, 2), problems]).toEqual([[2, 2], []])
  })

  it('ends with its thread when other circles are opened', async () => {
    FittingThread.at = 'hold'
    const fitted = fitTo()
    await isFitting()
    const { thread } = FittingThread.last ?? {}
    await open([3, 3, 1, 5, 5, 1])
    await fitted
    expect([circles(), isRunning(thread), problems]).toEqual([[3, 3, 1, 5, 5, 1], false, []])
    await figure.editing.undo()
    expect([circles(), figure.editing.domain.areas]).toEqual([FOUR, undefined])
  })

  it('whose thread crashes says so, and nothing else is lost', async () => {
    await figure.editing.edit(MOVED)
    const before = state()
    FittingThread.at = 'crash'
    const error = await fitTo().catch((error) => error)
    expect([problems, error.message]).toEqual([[error], expect.stringContaining('it broke')])
    expect(figure.store.get().problem).toContain('it broke')
    expect([state(), [...ThreadHere.running]]).toEqual([before, [painting]])
    FittingThread.at = 'go'
    await fitTo()
    const fitted = fittedByCore(before.circles, [1, 1, 1, 1])
    expect(circles()).toEqual(fitted)
    // The idle thread may crash, too.
    FittingThread.last?.thread.onerror?.({ message: 'it broke' })
    await fitTo([1, 2, 3, 4])
    expect([circles(), problems]).toEqual([fittedByCore(fitted, [1, 2, 3, 4]), [error]])
  })

  it('has nothing to do where all circles are removed, and the next circle has the whole region', async () => {
    await fitTo()
    await figure.editing.edit([0, 1, 2, 3].map((id) => ({ kind: 'remove', id })))
    expect(circles()).toEqual([])
    await figure.editing.edit([{ kind: 'insert', circle: { x: 3, y: 3, r: 1 } }])
    expect([circles().slice(0, 2), problems]).toEqual([[3, 3], []])
  })

  it('that is impossible is refused by its error, and the next one is made', async () => {
    const region = REGION
    const lattice = { a: [20, 0], b: [0, 20] } as const
    const domains: Domain[] = [
      { region, areas: [1, 2, 3] },
      { region, areas: [1, 2, 3, Number.POSITIVE_INFINITY] },
      { region, areas: 'equal', lattice },
      { region, areas: undefined, lattice },
      { region: undefined, areas: 'equal' },
    ]
    for (const domain of domains) {
      expect(await figure.setDomain(domain).catch(({ code }) => code)).toBe('badInput')
    }
    expect([circles(), problems.length]).toEqual([FOUR, domains.length])
    await fitTo()
    expect(circles()).toEqual(fittedByCore(FOUR, [1, 1, 1, 1]))
  })
})
