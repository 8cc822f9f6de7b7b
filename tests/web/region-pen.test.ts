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
  const { store, editing, actions, view, problems } = editingSession()
  await editing.open(sceneOf(Float64Array.of(5, 5, 1)))
  store.update((state) => ({ ...state, tool: 'draw' }))
  const pen = new RegionPen(store, Object.assign(actions, { complain: (text: string) => problems.push(text) }), view)
  const sketch = () => [...((view as { sketch?: Float64Array } & View).sketch ?? [])]
  const press = (...keys: string[]) => {
    for (const key of keys) expect([key, pen.key(key, 10)]).toEqual([key, true])
  }
  return { store, editing, pen, sketch, press, problems }
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
