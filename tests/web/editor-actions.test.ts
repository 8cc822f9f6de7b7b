// SPDX-License-Identifier: GPL-3.0-or-later
// The actions of a user on circles, and what screen readers hear, in a view without a picture.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { USUAL_RADIUS } from '../../web/editing/camera-actions.ts'
import { describeCell } from '../../web/editing/describe-cell.ts'
import { ENGLISH_EDITING } from '../../web/editing/words.ts'
import { type Camera, NO_PADDING, type Padding } from '../../web/view/camera.ts'
import type { Described } from '../../web/view/protocol.ts'
import { aTurn, editingSession, sceneOf } from './editing-session.ts'

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
      described: { id: 0, hiddenBy: undefined, isBounded: true, neighbors: Int32Array.of(), ...more } as Described,
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

describe('adding', () => {
  it('selects the new circles and says their number', async () => {
    const { actions, said, selection, circle } = await started()
    expect(await actions.add([{ x: 50, y: 50, r: 1 }])).toEqual([3])
    expect([selection(), said(), circle(3)]).toEqual([[3], 'Circle 3 added', [50, 50, 1]])
    expect(await actions.add([60, 70].map((x) => ({ x, y: 50, r: 1 })))).toEqual([4, 5])
    expect([selection(), said()]).toEqual([[4, 5], '2 circles added'])
    expect(await actions.add([{ x: 0, y: 0, r: -1 }]), 'refused').toEqual([])
    expect([selection(), said()]).toEqual([[4, 5], '2 circles added'])
  })

  it('at a place leaves room to the nearest circle, and is of the usual size in the open or inside a circle', async () => {
    const { actions, fake } = await started()
    expect(actions.fitted({ x: 100, y: 0 })).toEqual({ x: 100, y: 0, r: USUAL_RADIUS })
    expect(actions.fitted({ x: 5, y: 0 })).toEqual({ x: 5, y: 0, r: 1.5 })
    expect(actions.fitted({ x: 0, y: 14 })).toEqual({ x: 0, y: 14, r: 1.5 })
    expect(actions.fitted({ x: 1, y: 0 }), 'on a rim').toEqual({ x: 1, y: 0, r: USUAL_RADIUS })
    expect(actions.fitted({ x: 0, y: 0.5 })).toEqual({ x: 0, y: 0.5, r: USUAL_RADIUS })
    fake.camera = { x: 0, y: 0, scale: 48 }
    expect(actions.fitted({ x: 5, y: 0 })).toEqual({ x: 5, y: 0, r: 0.5 })
    const empty = await started({ circles: [] })
    expect(empty.actions.fitted({ x: 1, y: 2 })).toEqual({ x: 1, y: 2, r: USUAL_RADIUS })
    await actions.addFitting({ x: 5, y: 0 })
    expect(actions.circle(3)).toMatchObject({ x: 5, y: 0, r: 0.5 })
  })

  it('where there is room is near the middle, of the usual size at most, and in view', async () => {
    const { actions, fake, circle, selection } = await started()
    fake.camera = { x: 3, y: 4, scale: 2 }
    const asked: unknown[] = []
    fake.ask = async (...what: unknown[]) => {
      asked.push(what)
      return { x: 500, y: 6, r: 7 }
    }
    await actions.addInRoom()
    expect([asked, circle(3), selection()]).toEqual([[['room', 3, 4]], [500, 6, 7], [3]])
    expect(fake.camera).toEqual({ x: 500, y: 6, scale: 2 })
    fake.ask = async () => ({ x: 700, y: 6, r: 70 })
    await actions.addInRoom()
    expect(circle(4)).toEqual([700, 6, USUAL_RADIUS / 2])
    fake.ask = async () => undefined
    fake.camera = { x: 900, y: 4, scale: 2 }
    await actions.addInRoom()
    expect(circle(5)).toEqual([900, 4, USUAL_RADIUS / 2])
  })

  it('is one step with the circles that are asked for meanwhile', async () => {
    const { actions, editing, fake } = await started()
    fake.ask = async () => {
      await actions.open(async () => sceneOf(Float64Array.of(1, 1, 1)))
      return { x: 50, y: 50, r: 1 }
    }
    Object.assign(fake, { cancel: () => false })
    await actions.addInRoom()
    expect(editing.circles.count, 'other circles were opened').toBe(1)
  })

  it('copies are beside the selected circles, and say so', async () => {
    const { actions, circle, said, selection, fake } = await started()
    const aside = 200
    fake.camera = { x: 0, y: 0, scale: 0.1 }
    actions.select([1, 0])
    await actions.duplicateSelected()
    expect([circle(3), circle(4)]).toEqual([
      [10 + aside, -aside, 2],
      [aside, -aside, 1],
    ])
    expect([said(), selection()]).toEqual(['2 circles duplicated', [3, 4]])
    actions.select([2])
    await actions.duplicateSelected()
    expect(said()).toBe('Circle duplicated')
    actions.select([])
    actions.useTool('select')
    await actions.duplicateSelected()
    expect([said(), circle(6)]).toEqual(['Circle duplicated', [undefined, undefined, undefined]])
  })

  it('pasted circles are beside theirs, further each time, or in the middle of the picture', async () => {
    const { actions, circle, fake } = await started()
    const aside = 20
    await actions.paste([{ x: 10, y: 0, r: 2 }], 2)
    expect(circle(3)).toEqual([10 + 2 * aside, -2 * aside, 2])
    fake.camera = { x: 500, y: 600, scale: 10 }
    const pasted = [
      { x: -2, y: 0, r: 1 },
      { x: 2, y: 0, r: 1 },
    ]
    await actions.paste(pasted, 1)
    expect([circle(4), circle(5)]).toEqual([
      [500, 598, 1],
      [504, 598, 1],
    ])
  })
})

describe('selected circles', () => {
  it('are deleted, which is said, and nothing is selected', async () => {
    const { actions, computer, editing, said, selection } = await started({ circles: [...THREE, 50, 50, 1] })
    actions.select([1])
    await actions.removeSelected()
    expect([[...editing.circles.ids()], selection(), said()]).toEqual([[0, 2, 3], [], 'Circle 1 deleted'])
    actions.select([0, 3])
    await actions.removeSelected()
    expect([[...editing.circles.ids()], said()]).toEqual([[2], '2 circles deleted'])
    await actions.removeSelected()
    expect(said(), 'nothing is selected').toBe('2 circles deleted')
    vi.spyOn(computer, 'apply').mockRejectedValueOnce(new Error('It failed.'))
    actions.select([2])
    const removed = actions.removeSelected()
    expect(selection(), 'at once').toEqual([])
    await removed
    expect(said(), 'refused').toBe('2 circles deleted')
  })

  it('move by steps, which says where one is, or how many there are', async () => {
    const { actions, circle, said } = await started()
    actions.select([0])
    actions.moveSelected(0.1, -0.2, actions.beginGesture())
    actions.moveSelected(0.2, 0, actions.beginGesture())
    await aTurn()
    expect(circle(0)).toEqual([0.3, -0.2, 1])
    expect(said()).toBe('Circle 0: x 0.3, y -0.2, r 1')
    actions.select([0, 1])
    actions.moveSelected(1, 2, actions.beginGesture())
    await aTurn()
    expect([circle(0), circle(1), said()]).toEqual([[1.3, 1.8, 1], [11, 2, 2], '2 circles moved'])
    actions.select([])
    actions.moveSelected(1, 2, actions.beginGesture())
    await aTurn()
    expect(said()).toBe('2 circles moved')
  })

  it('grow by a step, not below zero, and several by a factor about their middle', async () => {
    const { actions, circle, said } = await started()
    actions.select([1])
    actions.growSelected(0.5, 9, actions.beginGesture())
    await aTurn()
    expect([circle(1), said()]).toEqual([[10, 0, 2.5], 'Circle 1: x 10, y 0, r 2.5'])
    actions.growSelected(-3, 9, actions.beginGesture())
    await aTurn()
    expect(circle(1)).toEqual([10, 0, 0])
    actions.select([0, 1])
    actions.growSelected(9, 2, actions.beginGesture())
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
    const region = {
      type: 'Polygon',
      coordinates: [
        [
          [0, 0],
          [9, 0],
          [0, 9],
        ],
      ],
      bbox: [0, 0, 9, 9],
    }
    const edit = { kind: 'replace', id: 0, circle: { x: 1, y: 1, r: 1 } } as const
    await actions.setDomain({ region: region as never }, undefined, [edit])
    expect(editing.domain.region).toEqual({ type: 'MultiPolygon', coordinates: [region.coordinates] })
    await actions.setDomain({ areas: 'equal' })
    expect([editing.domain.region !== undefined, editing.domain.areas]).toEqual([true, 'equal'])
    await actions.undo()
    await actions.undo()
    expect([editing.domain.region, circle(0)]).toEqual([undefined, [0, 0, 1]])
    expect(() => actions.setDomain({ region: 5 as never })).toThrow()
    await actions.edit([edit])
    expect(circle(0)).toEqual([1, 1, 1])
  })

  it('may be gone while they are dragged', async () => {
    const { actions, editing, circle } = await started()
    await editing.edit([{ kind: 'remove', id: 1 }])
    const moved = [0, 1].map((id) => ({ id, circle: { x: 5, y: 5, r: 1 } }))
    actions.set(moved)
    actions.set(moved.slice(1))
    await aTurn()
    expect([circle(0), [...editing.circles.ids()]]).toEqual([
      [5, 5, 1],
      [0, 2],
    ])
    await actions.undo()
    expect(circle(0)).toEqual([0, 0, 1])
  })

  it('snap to neighbors, or to the visible grid alone', async () => {
    const { actions, describe, fake } = await started()
    describe({ neighbors: Int32Array.of(1, 9) })
    const near = { x: 6.9, y: 0, r: 1 }
    expect(actions.snapped(near, 0.5, false)).toEqual({ x: 7, y: 0, r: 1 })
    expect(actions.snapped(near, 0.05, false)).toEqual({ x: 6.9, y: 0, r: 1 })
    expect(actions.snapped(near, 0.5, true)).toEqual({ x: 6.9, y: 0, r: expect.closeTo(1.1, 12) })
    fake.layers = { ...fake.layers, grid: true }
    fake.camera = { x: 0, y: 0, scale: 10 }
    expect(actions.snapped({ x: 6.9, y: 0.4, r: 1 }, 0, false)).toEqual({ x: 6, y: 0, r: 1 })
  })
})

describe('undo and redo', () => {
  it('select the circles that come back, and show a single one', async () => {
    const { actions, selection, fake } = await started({ circles: [...THREE, 5000, 0, 1] })
    actions.select([3])
    await actions.removeSelected()
    await actions.undo()
    expect([selection(), fake.camera]).toEqual([[3], { x: 5000, y: 0, scale: 1 }])
    actions.select([0, 1])
    await actions.removeSelected()
    fake.camera = { x: 700, y: 0, scale: 1 }
    await actions.undo()
    expect([selection(), fake.camera]).toEqual([[1, 0], { x: 700, y: 0, scale: 1 }])
    await actions.redo()
    expect(selection()).toEqual([])
  })

  it('show all circles of an opening that is undone', async () => {
    const { actions, editing, fake } = await started()
    await editing.open(sceneOf(Float64Array.of(1000, 0, 1)))
    fake.camera = { x: 1, y: 2, scale: 3 }
    await actions.undo()
    expect([editing.circles.count, fake.camera.x, fake.camera.y]).toEqual([3, 4.5, 10.5])
  })

  it('show all circles where they move into a box or back', async () => {
    const { actions, fake } = await started()
    await actions.setDomain({ lattice: { a: [40, 0], b: [0, 40] } })
    for (const [go, x, y] of [
      [() => actions.undo(), 4.5, 10.5],
      [() => actions.redo(), 20, 20],
    ] as const) {
      fake.camera = { x: 700, y: 0, scale: 1 }
      await go()
      expect([fake.camera.x, fake.camera.y]).toEqual([x, y])
    }
    await actions.setDomain({ areas: 'equal' })
    fake.camera = { x: 700, y: 0, scale: 1 }
    await actions.undo()
    expect(fake.camera.x, 'the box is the same').toBe(700)
  })

  it('are pending until they are done', async () => {
    const { actions, editing } = await started()
    expect(actions.pending).toBeUndefined()
    let end = () => {}
    const undone = new Promise<undefined>((resolve) => {
      end = () => resolve(undefined)
    })
    vi.spyOn(editing, 'undo').mockReturnValue(undone)
    const first = actions.add([{ x: 50, y: 50, r: 1 }])
    expect(actions.pending).toBeDefined()
    const second = actions.undo()
    await first
    await aTurn()
    expect(actions.pending, 'the second is still pending').toBeDefined()
    end()
    await second
    await aTurn()
    expect(actions.pending).toBeUndefined()
  })
})

it('circles that may only be looked at can be selected, and nothing else', async () => {
  const { actions, editing, circle, fake } = await started()
  expect(actions.isReadonly).toBe(false)
  actions.isReadonly = true
  fake.ask = () => expect.unreachable()
  actions.select([0])
  expect([actions.circle(0), actions.selectedCircles(), actions.fitted({ x: 5, y: 0 })]).toEqual([
    undefined,
    [],
    undefined,
  ])
  await actions.add([{ x: 50, y: 50, r: 1 }])
  await actions.addFitting({ x: 50, y: 50 })
  await actions.addInRoom()
  await actions.duplicateSelected()
  await actions.removeSelected()
  actions.moveSelected(1, 1, actions.beginGesture())
  await aTurn()
  expect([editing.circles.count, circle(0)]).toEqual([3, [0, 0, 1]])
  await editing.edit([{ kind: 'remove', id: 1 }])
  await actions.undo()
  expect(editing.circles.count).toBe(2)
})

describe('the selection', () => {
  it('is toggled, extended by a box, and released after the tool', async () => {
    const { actions, selection, store } = await started()
    for (const [id, expected] of [
      [1, [1]],
      [0, [1, 0]],
      [1, [0]],
    ] as const) {
      actions.toggle(id)
      expect(selection()).toEqual(expected)
    }
    expect([actions.isSelected(0), actions.isSelected(1)]).toEqual([true, false])
    actions.selectWithin({ minX: -1, minY: -1, maxX: 11, maxY: 1 })
    expect(selection()).toEqual([0, 1])
    actions.useTool('add')
    actions.release()
    expect([store.get().tool, selection()]).toEqual(['select', [0, 1]])
    actions.release()
    expect(selection()).toEqual([])
  })

  it('goes to the number after or before that of the circle selected last', async () => {
    const { actions, selection } = await started()
    actions.select([2, 0])
    expect([actions.selectNext(1), selection()]).toEqual([true, [1]])
    actions.select([0, 2])
    expect([actions.selectNext(-1), selection()]).toEqual([true, [1]])
    actions.select([])
    expect(actions.selectNext(1)).toBe(false)
  })

  it('clears the former description and problem, unless it is the same', async () => {
    const { actions, describe, store } = await started()
    const shown = () => [store.get().described === undefined, store.get().problem]
    for (const [ids, expected] of [
      [[0], [true, '']],
      [[0], [false, 'wrong']],
      [[1], [true, '']],
      [
        [1, 2],
        [true, ''],
      ],
      [
        [2, 1],
        [true, ''],
      ],
      [[2], [true, '']],
    ] as const) {
      describe({})
      actions.complain('wrong')
      actions.select(ids)
      expect([ids, shown()]).toEqual([ids, expected])
    }
  })

  it('goes to the circle nearest to the middle, and to neighbors in a direction', async () => {
    const { actions, describe, selection, fake } = await started()
    fake.camera = { x: 11, y: 1, scale: 1 }
    actions.selectNearMiddle()
    expect(selection()).toEqual([1])
    actions.select([0])
    describe({ neighbors: Int32Array.of(1, 2, 9) })
    fake.camera = { x: 5000, y: 0, scale: 1 }
    actions.selectNeighbor([-1, 0])
    expect(selection(), 'none is there').toEqual([0])
    actions.selectNeighbor([0, 1])
    expect([selection(), fake.camera]).toEqual([[2], { x: 0, y: 20, scale: 1 }])
    actions.select([])
    actions.selectNeighbor([0, 1])
    expect(selection()).toEqual([])
    const empty = await started({ circles: [] })
    empty.actions.selectNearMiddle()
    expect(empty.selection()).toEqual([])
  })
})

describe('tools', () => {
  it('are switched, with a change of the state for each other one', async () => {
    const { actions, store } = await started()
    const tools: string[] = []
    const before = store.get()
    actions.useTool('select')
    expect(store.get()).toBe(before)
    for (const act of [
      () => actions.toggleAdding(),
      () => actions.toggleAdding(),
      () => actions.useTool('pan'),
      () => actions.toggleAdding(),
    ]) {
      act()
      tools.push(actions.tool)
    }
    expect(tools).toEqual(['add', 'select', 'pan', 'add'])
    actions.holdPanning(true)
    expect(actions.tool).toBe('pan')
    actions.holdPanning(false)
    expect(actions.tool).toBe('add')
  })

  it('snapping is on or off, which is said', async () => {
    const { actions, said } = await started()
    for (const [isOn, text] of [
      [true, 'Snapping is on'],
      [false, 'Snapping is off'],
    ] as const) {
      actions.toggleSnapping()
      expect([actions.snaps, said()]).toEqual([isOn, text])
    }
  })

  it('a step of a method, a hovered circle and layers are shown', async () => {
    const { actions, store, fake } = await started()
    actions.showStep(3, 'flip', 'loading')
    expect(store.get()).toMatchObject({ step: 3, method: 'flip', stage: 'loading' })
    const before = store.get()
    actions.showStep(3, 'flip', 'loading')
    expect(store.get()).toBe(before)
    for (const shown of [
      [3, 'other', 'loading'],
      [4, 'other', 'loading'],
      [4, 'other', 'other'],
      [4, 'flip', 'other'],
    ] as const) {
      const [next, by, at] = shown
      actions.showStep(next, by, at)
      const { step, method, stage } = store.get()
      expect([step, method, stage]).toEqual(shown)
    }
    actions.showStep(4)
    expect(store.get()).toMatchObject({ step: 4, method: 'flip', stage: undefined })
    actions.hover(1)
    const hovered = store.get()
    actions.hover(1)
    expect([store.get() === hovered, hovered.hovered]).toEqual([true, 1])
    actions.hover(undefined)
    expect(store.get().hovered).toBeUndefined()
    actions.setLayers({ hull: true })
    expect(fake.layers.hull).toBe(true)
  })
})

describe('the camera', () => {
  const PADDED = { top: 10, right: 20, bottom: 30, left: 40 }

  it('pans by pixels, and zooms about a point by steps', async () => {
    const { actions, camera } = await started()
    expect(camera(() => actions.pan(10, 20))).toEqual({ x: -10, y: 20, scale: 1 })
    expect(camera(() => actions.zoom(2, { x: 0, y: 0 }))).toEqual({ x: -60, y: 45, scale: 2 })
    expect(camera(() => actions.zoomAtMiddle(1))).toEqual({ x: -60, y: 45, scale: 3 })
    expect(camera(() => actions.zoomAtMiddle(-1))).toEqual({ x: -60, y: 45, scale: 2 })
  })

  it('zooms between limits: a twentieth of the whole, and ten million times', async () => {
    const { actions, camera } = await started()
    const whole = camera(() => actions.fit()).scale
    expect(camera(() => actions.zoom(1e-9, { x: 100, y: 50 })).scale).toBeCloseTo(whole / 20, 12)
    expect(camera(() => actions.zoom(1e20, { x: 100, y: 50 })).scale / whole).toBeCloseTo(1e7, 0)
  })

  it('shows everything, and then what is not far outside', async () => {
    const many = Array.from({ length: 60 }, (_, k) => [k % 8, Math.floor(k / 8), 0.2]).flat()
    const { actions, camera } = await started({ circles: [...many, 1e6, 0, 1] })
    const whole = camera(() => actions.fit())
    expect(actions.isWhole).toBe(true)
    const core = camera(() => actions.fit())
    expect(core.scale).toBeGreaterThan(1000 * whole.scale)
    expect(actions.isWhole).toBe(false)
    // Zooming in is limited by most circles, and zooming out by all.
    expect(camera(() => actions.zoom(1e20, { x: 100, y: 50 })).scale / core.scale).toBeCloseTo(1e7, 0)
    expect(camera(() => actions.fit())).toEqual(whole)
  })

  it('shows a region in full', async () => {
    const { actions, editing, camera } = await started()
    const region = [
      [
        [-1000, -1000],
        [1000, -1000],
        [0, 1000],
      ],
    ] as const
    await editing.edit([], editing.beginGesture(), { region })
    const whole = camera(() => actions.fit())
    expect(whole.scale).toBeLessThan(0.1)
    expect(camera(() => actions.fit())).toEqual(whole)
  })

  it('zooms to the selected circles with a margin, and to a point as to a new circle', async () => {
    const { actions, camera, editing, fake } = await started()
    const before = camera(() => actions.zoomToSelection())
    expect(before, 'nothing is selected').toEqual({ x: 0, y: 0, scale: 1 })
    actions.select([1])
    const one = camera(() => actions.zoomToSelection())
    expect([one.x, one.y]).toEqual([10, 0])
    // Three times its size fits into the height of 100 pixels.
    expect(one.scale).toBeCloseTo(100 / 12, 1)
    actions.select([0, 2])
    const two = camera(() => actions.zoomToSelection())
    expect([two.x, two.y]).toEqual([0, 11])
    expect(two.scale).toBeCloseTo(100 / (3 * 24), 1)
    actions.select([0, 1])
    // Three times 13 units fit into 200 pixels, but not into the height of 100.
    expect(camera(() => actions.zoomToSelection()).scale).toBeCloseTo(100 / (3 * 13), 1)
    fake.camera = two
    await editing.edit([{ kind: 'replace', id: 1, circle: { x: 10, y: 0, r: 0 } }])
    actions.select([1])
    const point = camera(() => actions.zoomToSelection())
    expect(point.scale).toBeCloseTo((two.scale * 100) / (6 * USUAL_RADIUS), 1)
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
      await actions.add([{ x, y, r: 1 }])
      actions.goTo(fake.circles.count - 1)
      expect([x, y, fake.camera]).toEqual([x, y, isSeen ? { x: 0, y: 0, scale: 1 } : { x, y, scale: 1 }])
      fake.camera = { x: 0, y: 0, scale: 1 }
      actions.reveal([
        { x: 0, y: 0, r: 1 },
        { x, y, r: 1 },
      ])
      expect(fake.camera.scale === 1 && fake.camera.x === 0).toBe(isSeen)
    }
  })
})

describe('the texts for screen readers', () => {
  it('describe a hidden circle, and a cell with its neighbors', () => {
    const speech = { words: ENGLISH_EDITING, called: (id: number) => `circle ${id}` }
    const cell = (more: Partial<Described>) =>
      describeCell(
        { hiddenBy: undefined, isBounded: true, neighbors: Int32Array.of(4, 5), ...more } as Described,
        speech,
      )
    expect(cell({})).toEqual(['Bounded cell, 2 neighbors', [4, 5]])
    expect(cell({ isBounded: false, neighbors: Int32Array.of(4) })).toEqual(['Unbounded cell, 1 neighbor', [4]])
    expect(cell({ hiddenBy: 0 })).toEqual(['Hidden inside circle 0: it has no cell.', [0]])
  })

  it('begin with a capital letter, also with a name', () => {
    const { called, added, deleted, circle, numbers } = ENGLISH_EDITING
    expect([called(3, ''), called(3, 'Kiel')]).toEqual(['circle 3', 'Kiel'])
    expect([
      added('circle 3'),
      deleted('kiel'),
      circle('circle 3', 'A cell.'),
      numbers('circle 3', '1', '2', '3'),
    ]).toEqual(['Circle 3 added', 'Kiel deleted', 'Circle 3. A cell.', 'Circle 3: x 1, y 2, r 3'])
  })
})
