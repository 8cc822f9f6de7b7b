// SPDX-License-Identifier: GPL-3.0-or-later
// The store of an edited view. The view is a stub whose events the tests send.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { editView } from '../../web/editing/edited-view.ts'
import { withSelection } from '../../web/editing/state.ts'
import type { View } from '../../web/view/view.ts'
import { sceneOf } from './editing-session.ts'
import { LibraryBackend } from './library-backend.ts'

const THREE = Float64Array.of(0, 0, 1, 5, 0, 2, 0, 9, 3)
let told: unknown[][]
let problems: string[]
let outcomes: boolean[]
let session: ReturnType<typeof editView>
const listeners = new Map<string, (data: unknown) => void>()
const tell = (name: string, data: unknown) => listeners.get(name)?.(data)
let frames: (() => void)[]
const draw = () => {
  for (const frame of frames.splice(0)) frame()
}

beforeEach(async () => {
  frames = []
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => frames.push(frame))
  told = []
  problems = []
  outcomes = []
  const view = Object.assign(new LibraryBackend(async () => {}), {
    on: (name: string, listen: (data: unknown) => void) => listeners.set(name, listen),
    mark: (...ids: unknown[]) => told.push(['mark', ...ids]),
    choose: (circles: unknown) => told.push(['choose', circles]),
    setIdentities: (...identities: unknown[]) => told.push(['identities', ...identities]),
  })
  session = editView(
    view as unknown as View,
    ({ isOpened }) => outcomes.push(isOpened),
    ({ message }) => problems.push(message),
  )
  await session.editing.open(sceneOf(THREE))
  draw()
  told = []
})
afterEach(() => vi.unstubAllGlobals())

function select(ids: readonly number[], hovered?: number): void {
  session.store.update((state) => ({ ...withSelection(state, ids, session.editing.circles), hovered }))
  draw()
}

describe('a view that is edited', () => {
  it('has the state after each outcome, and reports it', async () => {
    const { store, editing } = session
    expect([store.get().dataSet, outcomes]).toEqual(['', [true]])
    const edited = await editing.edit([{ kind: 'remove', id: 1 }])
    expect([store.get().edited, outcomes]).toEqual([edited, [true, false]])
    expect(told, 'nothing is selected').toEqual([])
    await editing.open(sceneOf(THREE, 'spruces'))
    expect(store.get().dataSet).toBe('spruces')
  })

  it('shows the selection, and the circles that are selected or hovered alone', () => {
    select([1], 2)
    expect(told).toEqual([
      ['choose', [{ x: 5, y: 0, r: 2 }]],
      ['mark', 1, 2],
    ])
    told = []
    session.store.update((state) => ({ ...state, problem: 'No circle.' }))
    draw()
    expect(told).toEqual([])
    select([0, 1])
    expect(told.slice(1)).toEqual([['mark', undefined, undefined]])
  })

  it('moves the selection with an edit, and gives it no radii where areas are given', async () => {
    select([1])
    told = []
    await session.editing.edit([{ kind: 'replace', id: 1, circle: { x: 6, y: 0, r: 2 } }])
    expect(told).toContainEqual(['choose', [{ x: 6, y: 0, r: 2 }]])
    const areas = [1, 1, 1]
    await session.editing.open({ ...sceneOf(THREE), domain: { region: undefined, lattice: undefined, areas } })
    select([2])
    expect(told.at(-2)).toEqual(['choose', [{ x: 0, y: 9, r: 0 }]])
  })

  it('highlights nothing any more where the request for highlights has failed, and reports each failure', () => {
    for (const marks of [false, true]) {
      select([1], 2)
      tell('failed', { error: new Error('It broke.'), marks })
      const { selection, selected, hovered } = session.store.get()
      expect([selection, selected, hovered]).toEqual(marks ? [[], undefined, undefined] : [[1], 1, 2])
    }
    expect(problems).toEqual(['It broke.', 'It broke.'])
  })

  it('keeps what the view tells', () => {
    const described = { id: 1 }
    tell('marked', { selected: described })
    tell('found', 'all')
    tell('layers', 'none')
    expect(session.store.get()).toMatchObject({ described, found: 'all', layers: 'none' })
  })

  it('names circles again where there are other ones or other names, and not where one has moved', async () => {
    const named = () => told.filter(([what]) => what === 'identities').length
    await session.editing.edit([{ kind: 'replace', id: 1, circle: { x: 6, y: 0, r: 2 } }])
    expect(named()).toBe(0)
    await session.editing.edit([{ kind: 'insert', circle: { x: 6, y: 8, r: 2 } }])
    expect(named()).toBe(1)
    await session.editing.setValues('name', new Map([[1, '"A"']]))
    expect(named()).toBe(2)
    await session.editing.open(sceneOf(THREE))
    expect(named()).toBe(3)
  })
})
