// SPDX-License-Identifier: GPL-3.0-or-later
// A figure with its thread, as programs change it.
// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { held } from './element-page.ts'
import { ThreadHere } from './page-threads.ts'
import { newFigure } from './whole-figure.ts'
import { quiet, surround } from './whole-page.ts'

const THREE = [0, 0, 1, 5, 0, 2, 0, 9, 3]
const LATTICE = { a: [20, 0], b: [0, 20] } as const
const MISSING = [{ kind: 'remove', id: 9 }] as const
const REGION = [[[0, 0] as const, [9, 0] as const, [9, 9] as const]]

surround()
let figure: ReturnType<typeof newFigure>
let problems: Error[]
beforeEach(async () => {
  document.body.innerHTML = ''
  problems = []
  figure = newFigure({ onproblem: (error) => problems.push(error), played: () => ({}) })
  await open(THREE)
  await quiet()
})
afterEach(async () => {
  held.release()
  figure.dispose()
  vi.restoreAllMocks()
  await quiet()
})

const open = (circles: readonly number[]) =>
  figure.open({ circles: Float64Array.from(circles), dataSet: '', isEdited: false })
const circles = () => [...figure.editing.circles.circles()]

it('what is refused is thrown and told, and changes nothing', async () => {
  for (const [code, act] of [
    ['negativeRadius', () => open([0, 0, -1])],
    ['unknownCircle', () => figure.change({ edits: MISSING })],
    ['badInput', () => figure.setDomain({ region: undefined, areas: [1, 2] })],
    ['badOption', () => figure.setDomain({ region: undefined, areas: undefined, lattice: { a: [1, 0], b: [2, 0] } })],
  ] as const) {
    const refused = await act().catch((error) => error)
    expect([refused.code, problems.at(-1)]).toEqual([code, refused])
    expect([figure.isReported(refused), figure.isReported(new Error())]).toEqual([true, false])
  }
  expect([problems.length, circles()]).toEqual([4, THREE])
})

it('a request that is superseded throws nothing, also after one that was refused', async () => {
  await figure.change({ edits: MISSING }).catch(() => {})
  const edited = figure.change({ edits: [{ kind: 'remove', id: 1 }] })
  await Promise.all([open([1, 1, 1]), edited, open([2, 2, 2])])
  expect([circles(), problems.length]).toEqual([[2, 2, 2], 1])
})

it('a change waits for circles that are being opened, and keeps what it does not name', async () => {
  const { view, editing, store } = figure
  view.setLayers({ data: [{ id: 'own', color: 'red' }], hull: true })
  const opening = open(THREE)
  await figure.change({
    ...{ edits: [{ kind: 'remove', id: 1 }], layers: { dual: true }, step: 4, method: 'auto', lattice: LATTICE },
  })
  await opening
  expect(circles()).toEqual([0, 0, 1, 0, 9, 3])
  expect(view.layers).toMatchObject({ data: [{ id: 'own' }], dual: true, hull: false })
  expect(store.get()).toMatchObject({ step: 4, method: 'auto' })
  const { camera } = view
  for (const [change, lattice, areas] of [
    [{}, LATTICE, undefined],
    [{ edits: [{ kind: 'replace', id: 0, circle: { x: 1, y: 1, r: 0 } }] }, LATTICE, undefined],
    [{ region: REGION, lattice: null, areas: [1, 2] }, undefined, [1, 2]],
    [{ edits: [{ kind: 'replace', id: 0, circle: { x: 2, y: 1, r: 0 } }] }, undefined, [1, 2]],
    [{ view: { x: 1, y: 2, span: 10 } }, undefined, [1, 2]],
  ] as const) {
    await figure.change(change)
    expect([editing.domain.lattice, editing.areas, store.get().step]).toEqual([lattice, areas, 4])
  }
  expect(editing.domain.region).toBeDefined()
  expect([view.camera.x, view.camera.y]).toEqual([1, 2])
  expect(view.camera).not.toEqual(camera)
})

it('a figure is painted once it says so, is not shown, or its tab is hidden', async () => {
  const ends = [
    () => held.release(),
    () => (figure.view.isShown = false),
    () => vi.spyOn(document, 'visibilityState', 'get').mockReturnValue('hidden'),
  ]
  for (const end of ends) {
    figure.view.isShown = true
    await quiet()
    held.hold()
    figure.view.setLayers({ hull: !figure.view.layers.hull })
    figure.view.restyle()
    let isPainted = false
    const done = figure.whenPainted().then(() => {
      isPainted = true
    })
    await quiet()
    expect(isPainted).toBe(false)
    end()
    document.dispatchEvent(new Event('visibilitychange'))
    if (end === ends[1]) figure.element.ariaBusy = 'true'
    await done
    held.release()
    await quiet()
  }
})

it('a figure that is disposed of has no thread, and tells no problem', async () => {
  const opening = open([0, 0, -1]).catch(() => {})
  figure.dispose()
  await opening
  await quiet()
  expect([ThreadHere.running.size, problems, figure.store.get().problem]).toEqual([0, [], ''])
})
