// SPDX-License-Identifier: GPL-3.0-or-later
// The actions of a user on circles, and what screen readers hear, in a view without a picture.

import fc from 'fast-check'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { USUAL_RADIUS } from '../../web/editing/camera-actions.ts'
import { type Camera, NO_PADDING, type Padding, toScreen } from '../../web/view/camera.ts'
import type { Described } from '../../web/view/protocol.ts'
import { describedIn } from '../../web/view/view-state.ts'
import { aTurn, editingSession, sceneOf } from './editing-session.ts'
import { box } from './shapes.ts'

const THREE = [0, 0, 1, 10, 0, 2, 0, 20, 3]

beforeEach(() => vi.stubGlobal('requestAnimationFrame', (act: () => void) => queueMicrotask(act)))
afterEach(() => vi.unstubAllGlobals())

async function started({ circles = THREE, padding = NO_PADDING }: { circles?: number[]; padding?: Padding } = {}) {
  const session = editingSession({ padding, size: { width: 200, height: 100 } })
  const { editing, store, fake } = session
  await editing.open(sceneOf(Float64Array.from(circles)))
  const said = () => store.get().said.text
  const selection = () => store.get().selection
  const circle = (id: number) => {
    const { x, y, r } = editing.circles.get(id) ?? {}
    return [x, y, r]
  }
  const describe = (more: Partial<Described>) =>
    store.update((state) => ({
      ...state,
      highlights: {
        selected: { id: 0, hiddenBy: undefined, isBounded: true, neighbors: Int32Array.of(), ...more } as Described,
        hovered: undefined,
      },
    }))
  const view = fake as typeof fake & { hitAt: (point: { x: number; y: number }, within: number) => unknown }
  view.hitAt = ({ x, y }, within) => {
    expect(within).toBe(0)
    const ids = [...editing.circles.ids()].sort((a, b) => gap(a) - gap(b))
    function gap(id: number) {
      const { x: cx, y: cy, r } = editing.circles.get(id) as { x: number; y: number; r: number }
      return Math.hypot(cx - x, cy - y) - r
    }
    return ids.length === 0 ? undefined : { id: ids[0], part: 'cell' }
  }
  /** The camera after an action. */
  const camera = (act: () => void): Camera => {
    act()
    return fake.camera
  }
  return { ...session, said, selection, circle, describe, camera }
}

describe('screen readers hear', () => {
  type Actions = Awaited<ReturnType<typeof started>>['actions']
  const circles = (count: number) => Array.from({ length: count }, (_, k) => ({ x: 50 + 10 * k, y: 50, r: 1 }))
  it.each([
    ['one new circle', [], (actions: Actions) => actions.circles.add(circles(1)), /3/],
    ['several new circles', [], (actions: Actions) => actions.circles.add(circles(2)), /2/],
    ['a copy', [2], (actions: Actions) => actions.circles.duplicateSelected(), /./],
    ['several copies', [0, 1], (actions: Actions) => actions.circles.duplicateSelected(), /2/],
    ['one deleted circle', [1], (actions: Actions) => actions.circles.removeSelected(), /1/],
    ['several deleted circles', [0, 2], (actions: Actions) => actions.circles.removeSelected(), /2/],
    [
      'where a circle is moved',
      [0],
      (actions: Actions) => actions.circles.moveSelected(0.3, -0.2, actions.circles.beginGesture()),
      /0\.3.*-0\.2.*1/,
    ],
    [
      'that several are moved',
      [0, 1],
      (actions: Actions) => actions.circles.moveSelected(1, 2, actions.circles.beginGesture()),
      /2/,
    ],
    [
      'the radius of a circle that grows',
      [1],
      (actions: Actions) => actions.circles.growSelected(0.5, 9, actions.circles.beginGesture()),
      /10.*0.*2\.5/,
    ],
  ] as const)('%s', async (_, selection, act, text) => {
    const { actions, said } = await started()
    actions.selection.select(selection)
    await act(actions)
    await aTurn()
    expect(said()).toMatch(text)
  })

  it('nothing of what is refused, and nothing where nothing is selected', async () => {
    const { actions, computer, said, selection } = await started()
    expect(await actions.circles.add([{ x: 0, y: 0, r: -1 }])).toEqual([])
    for (const act of [
      () => actions.circles.duplicateSelected(),
      () => actions.circles.removeSelected(),
      () => actions.circles.moveSelected(1, 2, actions.circles.beginGesture()),
    ]) {
      await act()
      await aTurn()
    }
    vi.spyOn(computer, 'edit').mockRejectedValueOnce(new Error('It failed.'))
    actions.selection.select([2])
    const removed = actions.circles.removeSelected()
    expect(selection(), 'at once').toEqual([])
    await removed
    expect(said()).toBe('')
  })

  it('that snapping is turned on and off', async () => {
    const { actions, said } = await started()
    const heard = [true, false].map((isOn) => {
      actions.tools.toggleSnapping()
      expect(actions.tools.snaps).toBe(isOn)
      return said()
    })
    expect(new Set(heard).size).toBe(2)
  })
})

describe('adding', () => {
  it('at a place leaves room to the nearest circle, and is of the usual size in the open or inside a circle', async () => {
    const { actions, fake } = await started()
    expect(actions.circles.fitted({ x: 100, y: 0 })).toEqual({ x: 100, y: 0, r: USUAL_RADIUS })
    expect(actions.circles.fitted({ x: 5, y: 0 })).toEqual({ x: 5, y: 0, r: 1.5 })
    expect(actions.circles.fitted({ x: 0, y: 14 })).toEqual({ x: 0, y: 14, r: 1.5 })
    expect(actions.circles.fitted({ x: 1, y: 0 }), 'on a rim').toEqual({ x: 1, y: 0, r: USUAL_RADIUS })
    expect(actions.circles.fitted({ x: 0, y: 0.5 })).toEqual({ x: 0, y: 0.5, r: USUAL_RADIUS })
    fake.camera = { x: 0, y: 0, scale: 48 }
    expect(actions.circles.fitted({ x: 5, y: 0 })).toEqual({ x: 5, y: 0, r: 0.5 })
    const empty = await started({ circles: [] })
    expect(empty.actions.circles.fitted({ x: 1, y: 2 })).toEqual({ x: 1, y: 2, r: USUAL_RADIUS })
    await actions.circles.addFitting({ x: 5, y: 0 })
    expect(actions.circles.circle(3)).toMatchObject({ x: 5, y: 0, r: 0.5 })
  })

  it('is one step with the circles that are asked for meanwhile', async () => {
    const { actions, editing, fake } = await started()
    fake.scene.ask = async () => {
      await actions.opening.open(async () => sceneOf(Float64Array.of(1, 1, 1)))
      return { x: 50, y: 50, r: 1 }
    }
    Object.assign(fake.scene, { cancel: () => false })
    await actions.circles.addInRoom()
    expect(editing.circles.count, 'other circles were opened').toBe(1)
  })

  it('copies are beside the selected circles, and selected', async () => {
    const { actions, circle, selection, fake } = await started()
    const aside = 200
    fake.camera = { x: 0, y: 0, scale: 0.1 }
    actions.selection.select([1, 0])
    await actions.circles.duplicateSelected()
    expect([circle(3), circle(4), selection()]).toEqual([
      [10 + aside, -aside, 2],
      [aside, -aside, 1],
      [3, 4],
    ])
  })

  it('pasted circles are beside theirs, further each time, or in the middle of the picture', async () => {
    const { actions, circle, fake } = await started()
    const aside = 20
    await actions.circles.paste([{ x: 10, y: 0, r: 2 }], 2)
    expect(circle(3)).toEqual([10 + 2 * aside, -2 * aside, 2])
    fake.camera = { x: 500, y: 600, scale: 10 }
    const pasted = [
      { x: -2, y: 0, r: 1 },
      { x: 2, y: 0, r: 1 },
    ]
    await actions.circles.paste(pasted, 1)
    expect([circle(4), circle(5)]).toEqual([
      [500, 598, 1],
      [504, 598, 1],
    ])
  })
})

describe('selected circles', () => {
  it('grow by a step, not below zero, and several by a factor about their middle', async () => {
    const { actions, circle } = await started()
    actions.selection.select([1])
    actions.circles.growSelected(-3, 9, actions.circles.beginGesture())
    await aTurn()
    expect(circle(1)).toEqual([10, 0, 0])
    actions.selection.select([0, 1])
    actions.circles.growSelected(9, 2, actions.circles.beginGesture())
    await aTurn()
    // The middle of their box is at 4.5, 0.
    expect([circle(0), circle(1), circle(2)]).toEqual([
      [-4.5, 0, 2],
      [15.5, 0, 0],
      [0, 20, 3],
    ])
  })

  it('are edited together with the region, which is kept as plain data', async () => {
    const { actions, editing, circle } = await started()
    const region = { type: 'Polygon', coordinates: [box(0, 0, 9, 9)], bbox: [0, 0, 9, 9] } as const
    const edit = { kind: 'replace', id: 0, circle: { x: 1, y: 1, r: 1 } } as const
    await actions.circles.setDomain({ region }, undefined, [edit])
    expect(editing.domain.region).toEqual({ type: 'MultiPolygon', coordinates: [region.coordinates] })
    await actions.circles.setDomain({ areas: 'equal' })
    expect([editing.domain.region !== undefined, editing.domain.areas]).toEqual([true, 'equal'])
    await actions.circles.undo()
    await actions.circles.undo()
    expect([editing.domain.region, circle(0)]).toEqual([undefined, [0, 0, 1]])
    expect(() => actions.circles.setDomain({ region: 5 as never })).toThrow()
  })

  it('snap to neighbors, or to the visible grid alone', async () => {
    const { actions, describe, fake } = await started()
    actions.selection.select([0])
    describe({ neighbors: Int32Array.of(1, 9) })
    const near = { x: 6.9, y: 0, r: 1 }
    expect(actions.circles.snapped(near, 0.5, false)).toEqual({ x: 7, y: 0, r: 1 })
    expect(actions.circles.snapped(near, 0.05, false)).toEqual({ x: 6.9, y: 0, r: 1 })
    expect(actions.circles.snapped(near, 0.5, true)).toEqual({ x: 6.9, y: 0, r: expect.closeTo(1.1, 12) })
    fake.layers = { ...fake.layers, grid: true }
    fake.camera = { x: 0, y: 0, scale: 10 }
    expect(actions.circles.snapped({ x: 6.9, y: 0.4, r: 1 }, 0, false)).toEqual({ x: 6, y: 0, r: 1 })
  })
})

describe('undo and redo', () => {
  it('select the circles that come back, and show a single one', async () => {
    const { actions, selection, fake } = await started({ circles: [...THREE, 5000, 0, 1] })
    actions.selection.select([3])
    await actions.circles.removeSelected()
    await actions.circles.undo()
    expect([selection(), fake.camera]).toEqual([[3], { x: 5000, y: 0, scale: 1 }])
    actions.selection.select([0, 1])
    await actions.circles.removeSelected()
    fake.camera = { x: 700, y: 0, scale: 1 }
    await actions.circles.undo()
    expect([selection(), fake.camera]).toEqual([[1, 0], { x: 700, y: 0, scale: 1 }])
    await actions.circles.redo()
    expect(selection()).toEqual([])
  })
})

it('actions are pending until all of them are done', async () => {
  const { actions } = await started()
  expect(actions.circles.pending).toBeUndefined()
  const [first, second] = [actions.circles.add([{ x: 50, y: 50, r: 1 }]), actions.circles.undo()]
  await first
  expect(actions.circles.pending).toBeDefined()
  await second
  await aTurn()
  expect(actions.circles.pending).toBeUndefined()
})

it('a selection clears the former problem, unless it is the same, and shows no description of another circle', async () => {
  const { actions, describe, store } = await started()
  const isClear = (...ids: number[]) => {
    describe({})
    actions.messages.complain('wrong')
    actions.selection.select(ids)
    return [describedIn(store.get()) === undefined, store.get().problem === '']
  }
  expect(isClear(0)).toEqual([false, true])
  expect(isClear(0)).toEqual([false, false])
  for (const ids of [[1], [1, 2], [2, 1], [2]]) expect(isClear(...ids)).toEqual([true, true])
})

describe('the camera', () => {
  const PADDED = { top: 10, right: 20, bottom: 30, left: 40 }

  it('zooms between limits: a twentieth of the whole, and ten million times', async () => {
    const { actions, camera } = await started()
    const whole = camera(() => actions.camera.fit()).scale
    expect(camera(() => actions.camera.zoom(1e-9, { x: 100, y: 50 })).scale).toBeCloseTo(whole / 20, 12)
    expect(camera(() => actions.camera.zoom(1e20, { x: 100, y: 50 })).scale / whole).toBeCloseTo(1e7, 0)
  })

  it('shows everything, and then what is not far outside', async () => {
    const many = Array.from({ length: 60 }, (_, k) => [k % 8, Math.floor(k / 8), 0.2]).flat()
    const { actions, camera } = await started({ circles: [...many, 1e6, 0, 1] })
    const whole = camera(() => actions.camera.fit())
    expect(actions.camera.isWhole).toBe(true)
    const core = camera(() => actions.camera.fit())
    expect(core.scale).toBeGreaterThan(1000 * whole.scale)
    expect(actions.camera.isWhole).toBe(false)
    // Zooming in is limited by most circles, and zooming out by all.
    expect(camera(() => actions.camera.zoom(1e20, { x: 100, y: 50 })).scale / core.scale).toBeCloseTo(1e7, 0)
    expect(camera(() => actions.camera.fit())).toEqual(whole)
  })

  it('shows a region in full', async () => {
    const { actions, editing, camera } = await started()
    await editing.edit([], editing.beginGesture(), { region: [box(-1000, -1000, 1000, 1000)] })
    const whole = camera(() => actions.camera.fit())
    expect(whole.scale).toBeLessThan(0.1)
    expect(camera(() => actions.camera.fit())).toEqual(whole)
  })

  it('zooms to the selected circles, which take a third of the free part, and to a point as to a new circle', async () => {
    const { actions, editing, fake } = await started({ circles: [], padding: PADDED })
    const number = fc.integer({ min: 0, max: 9 })
    const circle = fc.record({ x: number, y: number, r: fc.constantFrom(0, 0, 1, 5) })
    await fc.assert(
      fc.asyncProperty(
        fc.array(circle, { minLength: 1, maxLength: 3 }),
        fc.constantFrom(1, 7),
        async (circles, scale) => {
          const flat = circles.flatMap(({ x, y, r }) => [x, y, r])
          await editing.open(sceneOf(Float64Array.of(...flat, 500, 500, 9)))
          actions.selection.select([])
          fake.camera = { x: 3, y: 4, scale }
          actions.camera.zoomToSelection()
          expect(fake.camera, 'nothing is selected').toEqual({ x: 3, y: 4, scale })
          actions.selection.select([...circles.keys()])
          actions.camera.zoomToSelection()
          const ends = (axis: 'x' | 'y') => [
            Math.min(...circles.map((circle) => circle[axis] - circle.r)),
            Math.max(...circles.map((circle) => circle[axis] + circle.r)),
          ]
          const [[left = 0, right = 0], [low = 0, high = 0]] = [ends('x'), ends('y')]
          const extent = Math.max(right - left, high - low) || (2 * USUAL_RADIUS) / scale
          // The free part is 140 x 60 pixels around (110, 40).
          expect(fake.camera.scale).toBeCloseTo(60 / (3 * extent), 9)
          const { x, y } = toScreen(fake.camera, fake.size, { x: (left + right) / 2, y: (low + high) / 2 })
          expect([x, y]).toEqual([expect.closeTo(110, 6), expect.closeTo(40, 6)])
        },
      ),
    )
  })

  it('shows the center of a circle that is out of sight or covered', async () => {
    const { actions, fake } = await started({ padding: PADDED })
    // The free part is 140 x 60 pixels, from -60, -20 to 80, 40.
    for (const [x, y, isSeen] of [
      [-60, 0, true],
      [-61, 0, false],
      [80, 0, true],
      [81, 0, false],
      [0, 40, true],
      [0, 41, false],
      [0, -20, true],
      [0, -21, false],
    ] as const) {
      fake.camera = { x: 0, y: 0, scale: 1 }
      await actions.circles.add([{ x, y, r: 1 }])
      actions.selection.goTo(fake.circles.count - 1)
      expect([x, y, fake.camera]).toEqual([x, y, isSeen ? { x: 0, y: 0, scale: 1 } : { x, y, scale: 1 }])
      fake.camera = { x: 0, y: 0, scale: 1 }
      actions.camera.reveal([
        { x: 0, y: 0, r: 1 },
        { x, y, r: 1 },
      ])
      expect(fake.camera.scale === 1 && fake.camera.x === 0).toBe(isSeen)
    }
  })
})
