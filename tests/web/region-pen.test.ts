// SPDX-License-Identifier: GPL-3.0-or-later
// The tool that draws a polygon of the region, by pointer and by keys.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { RegionPen } from '../../web/app/region-pen.ts'
import type { View } from '../../web/view/view.ts'
import { aTurn, editingSession, sceneOf } from './editing-session.ts'

beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', (frame: () => void) => setTimeout(frame))
})
afterEach(() => vi.unstubAllGlobals())

async function started() {
  const { computer, store, editing, actions, view, problems } = editingSession()
  await editing.open(sceneOf(Float64Array.of(5, 5, 1)))
  store.update((state) => ({ ...state, tool: 'draw' }))
  const pen = new RegionPen(store, Object.assign(actions, { complain: (text: string) => problems.push(text) }), view)
  const sketch = () => [...((view as { sketch?: Float64Array } & View).sketch ?? [])]
  const press = (...keys: string[]) => {
    for (const key of keys) expect([key, pen.key(key, 10)]).toEqual([key, true])
  }
  return { computer, actions, store, editing, pen, sketch, press, problems }
}

it('arrows go from the last corner, or from the middle of the picture, and Space places a corner', async () => {
  const { pen, sketch, press } = await started()
  press('ArrowRight')
  expect([pen.count, sketch()]).toEqual([0, [10, 0]])
  press('ArrowUp', ' ')
  expect([pen.count, sketch()]).toEqual([1, [10, 10]])
  press('ArrowLeft')
  expect([pen.count, sketch()]).toEqual([1, [10, 10, 0, 10]])
  press(' ', 'Backspace')
  expect([pen.count, sketch()]).toEqual([1, [10, 10]])
  expect(pen.key('x', 10)).toBe(false)
})

it('a polygon of three corners becomes the region, and then nothing is sketched', async () => {
  const { store, editing, pen, sketch, press, problems } = await started()
  press('ArrowRight', ' ', 'ArrowUp', ' ', 'Enter')
  expect(problems).toEqual(['A polygon needs three corners or more.'])
  press('ArrowLeft', ' ', 'Enter')
  await expect.poll(() => store.get().tool).toBe('select')
  await aTurn()
  expect(editing.domain.region).toEqual([
    [
      [10, 0],
      [10, 10],
      [0, 10],
    ],
  ])
  expect([pen.count, sketch()]).toEqual([0, []])
})

it('presses place corners apart from each other, and one at the first corner closes the polygon', async () => {
  const { editing, pen } = await started()
  const place = (x: number, y: number) => pen.draw('place', { x, y }, 4)
  place(0, 0)
  place(0.5, 0)
  place(9, 0)
  place(9, 9)
  expect(pen.count).toBe(3)
  place(1, 1)
  await expect.poll(() => editing.domain.region).toHaveLength(1)
})

it('presses close together are one corner, and the first corner closes from three corners on', async () => {
  const { editing, pen, sketch } = await started()
  const place = (x: number, y: number) => pen.draw('place', { x, y }, 4)
  place(0, 0)
  place(2, 0)
  expect(pen.count, 'half of the distance').toBe(1)
  place(2.1, 0)
  place(-0.1, 0)
  expect(sketch(), 'a corner: there are two').toEqual([0, 0, 2.1, 0, -0.1, 0])
  expect(editing.domain.region).toBeUndefined()
})

it('corners are said, clear the former problem, and are taken back by Delete and Backspace', async () => {
  const { store, press, pen } = await started()
  const said = () => store.get().said.text
  store.update((state) => ({ ...state, problem: 'wrong' }))
  press('ArrowRight', ' ')
  expect([said(), store.get().problem]).toEqual(['1 corner', ''])
  press('ArrowUp', ' ')
  expect(said()).toBe('2 corners')
  press('Delete')
  expect(said()).toBe('1 corner')
  press('Backspace')
  expect([said(), pen.count, pen.undo()]).toEqual(['0 corners', 0, false])
})

it('a refused polygon stays for correction', async () => {
  const { store, computer, pen, press, sketch } = await started()
  vi.spyOn(computer, 'apply').mockRejectedValueOnce(new Error('It crosses itself.'))
  press('ArrowRight', ' ', 'ArrowUp', ' ', 'ArrowLeft', ' ')
  await pen.close()
  expect([store.get().tool, pen.count, sketch()]).toEqual(['draw', 3, [10, 0, 10, 10, 0, 10]])
  pen.draw('close', { x: 0, y: 0 }, 4)
  await expect.poll(() => store.get().tool).toBe('select')
})

it('a polygon is a hole or another ring, or merged with polygons that are merged', async () => {
  const { store, editing, pen, actions } = await started()
  const ring = [
    [0, 0],
    [90, 0],
    [0, 90],
  ] as const
  const drawn = async () => {
    store.update((state) => ({ ...state, tool: 'draw' }))
    for (const [x, y] of [
      [1, 1],
      [9, 1],
      [1, 9],
    ] as const) {
      pen.draw('move', { x, y }, 0)
      pen.draw('place', { x, y }, 0)
    }
    await pen.close()
    return editing.domain.region
  }
  const added = [
    [1, 1],
    [9, 1],
    [1, 9],
  ]
  await actions.setDomain({ region: [ring] })
  await aTurn()
  expect(await drawn()).toEqual([ring, added])
  await actions.setDomain({ region: { type: 'MultiPolygon', coordinates: [[ring]], dissolve: true } })
  await aTurn()
  expect(await drawn()).toEqual({ type: 'MultiPolygon', coordinates: [[ring], [added]], dissolve: true })
})

it('another tool takes the sketch away, and no other change does', async () => {
  const { store, pen, press, sketch } = await started()
  press('ArrowRight', ' ', 'ArrowRight')
  store.update((state) => ({ ...state, hovered: 0 }))
  await aTurn()
  expect([pen.count, sketch()]).toEqual([1, [10, 0, 20, 0]])
  store.update((state) => ({ ...state, tool: 'pan' }))
  await aTurn()
  expect([pen.count, sketch()]).toEqual([0, []])
})
