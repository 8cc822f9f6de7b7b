// SPDX-License-Identifier: GPL-3.0-or-later
// Gestures by mouse and fingers without a browser: their effects, in order.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { Box, Circle, Point } from '../../web/lib/index.ts'
import { type Camera, toPlane } from '../../web/view/camera.ts'
import type { Hit } from '../../web/view/circle-table.ts'
import type { GestureTarget, IdentifiedCircle, SketchPhase } from '../../web/view/gestures.ts'
import type { SelectionRectangle } from '../../web/view/overlay.ts'
import { listenToPointer, type PointerOptions } from '../../web/view/pointer.ts'
import type { View } from '../../web/view/view.ts'

const SIZE = { width: 800, height: 600 }
/** Ten pixels per unit, with the origin in the middle. */
const CAMERA: Camera = { x: 0, y: 0, scale: 10 }
const CIRCLES: readonly Circle[] = [
  { x: 0, y: 0, r: 4 },
  { x: 10, y: 0, r: 2 },
  { x: 0, y: 10, r: 1 },
]

/** The pixel of a point of the plane for the first camera. */
const pixel = (x: number, y: number): Point => ({ x: 400 + 10 * x, y: 300 - 10 * y })

class Stage {
  readonly element = Object.assign(new EventTarget(), {
    currentCSSZoom: 1,
    focus() {},
    dataset: {} as Record<string, string | undefined>,
    captured: [] as number[],
    setPointerCapture: (id: number) => {
      this.element.captured.push(id)
    },
    getBoundingClientRect: () => ({ left: 30, top: 20 }),
  })
  readonly done: unknown[][] = []
  camera = CAMERA
  size = SIZE
  layers: { path?: { from: Point; to: Point } } = {}
  band: SelectionRectangle | undefined
  /** The answer to hit tests, and their tolerance. */
  under: Hit | undefined
  readonly listeners = new Map<string, () => void>()
  slack = 0
  reach = 0
  isReadonly = false
  pathEnd: 'from' | 'to' | undefined
  handle: Point | undefined
  handleSlack = 0
  tool: GestureTarget['tool'] = 'select'
  snaps = false
  selection: readonly number[] = []
  #gestures = 0

  readonly view = this as unknown as View
  readonly listening

  constructor(options?: PointerOptions) {
    const element = this.element as unknown as HTMLElement
    this.listening = listenToPointer(element, this.view, this as unknown as GestureTarget, options)
  }

  // The stubs of the view.
  setCamera(camera: Camera): void {
    this.camera = camera
  }
  hitAt({ x, y }: Point, slack: number, reach: number): Hit | undefined {
    this.slack = slack
    this.reach = reach
    this.done.push(['hit', x, y])
    return this.under
  }
  on(name: string, listener: () => void): () => void {
    this.listeners.set(name, listener)
    return () => this.listeners.delete(name)
  }
  touch(point: Point | undefined, slack: number): void {
    this.done.push(['touch', point, slack])
  }
  pathEndAt(_: Point, slack: number) {
    this.handleSlack = slack
    return this.pathEnd
  }
  handleAt() {
    return this.handle
  }
  async tryCircle(circle: Circle | undefined): Promise<void> {
    this.done.push(['tryCircle', circle])
  }
  movePathEnd(end: 'from' | 'to', point: Point): void {
    this.done.push(['movePathEnd', end, point])
  }

  // The stubs of the gestures' effects.
  circle(id: number): Circle | undefined {
    return this.isReadonly ? undefined : CIRCLES[id]
  }
  selectedCircles(): IdentifiedCircle[] {
    return this.selection.map((id) => ({ id, circle: CIRCLES[id] as Circle }))
  }
  isSelected(id: number): boolean {
    return this.selection.includes(id)
  }
  select(ids: readonly number[]): void {
    this.selection = ids
    this.done.push(['select', ...ids])
  }
  toggle(id: number): void {
    this.done.push(['toggle', id])
  }
  selectWithin(box: Box): void {
    this.done.push(['selectWithin', box])
  }
  hover(id: number | undefined): void {
    this.done.push(['hover', id])
  }
  beginGesture(): number {
    this.#gestures += 1
    return this.#gestures
  }
  set(circles: readonly IdentifiedCircle[], gesture: number): void {
    this.done.push(['set', gesture, ...circles])
  }
  snapped(circle: Circle, within: number, sizes: boolean): Circle {
    this.done.push(['snapped', within, sizes])
    return { ...circle, [sizes ? 'r' : 'x']: 7 }
  }
  async add(circles: readonly Circle[], gesture: number): Promise<readonly number[]> {
    this.done.push(['add', gesture, ...circles])
    return [9]
  }
  async addFitting(center: Point): Promise<void> {
    this.done.push(['addFitting', center])
  }
  fitted({ x, y }: Point): Circle {
    return { x, y, r: 1 }
  }
  draw(how: SketchPhase, point: Point, within: number): void {
    this.done.push(['draw', how, point, within])
  }
  cancel(gesture: number): void {
    this.done.push(['cancel', gesture])
  }
  zoom(factor: number, anchor: Point): void {
    this.done.push(['zoom', factor, anchor])
  }

  /** Sends a pointer event at a pixel of the element, then waits for the answers. */
  async send(type: string, { x, y }: Point, more: object = {}): Promise<Event> {
    const event = Object.assign(new Event(type, { cancelable: true }), {
      ...{ pointerId: 1, pointerType: 'mouse', button: 0, altKey: false, shiftKey: false, ctrlKey: false },
      ...{ offsetX: x, offsetY: y, ...more },
    })
    this.element.dispatchEvent(event)
    await settled()
    return event
  }

  /** Presses at the first point and moves to the others. */
  async press(points: readonly Point[], more: object = {}): Promise<void> {
    const [first, ...others] = points
    await this.send('pointerdown', first as Point, more)
    for (const point of others) await this.send('pointermove', point, more)
  }

  async drag(points: readonly Point[], more: object = {}): Promise<void> {
    await this.press(points, more)
    await this.send('pointerup', points.at(-1) as Point, more)
  }

  /** The recorded calls with these names. */
  of(...names: string[]): unknown[][] {
    return this.done.filter(([name]) => names.includes(name as string))
  }
}

/** The callbacks of the next frame, including long presses of earlier tests. */
let waiting: (() => void)[] = []
/** Shows the next frame. Browsers report moves before it. */
const showFrame = () => {
  for (const callback of waiting.splice(0)) callback()
}
beforeEach(() => {
  waiting = []
  vi.stubGlobal('requestAnimationFrame', (callback: () => void) => waiting.push(callback))
})

/** Waits until all promises that can continue have done so. */
const settled = () => new Promise((resolve) => setTimeout(resolve, 0))

const DOING = ['select', 'toggle', 'selectWithin', 'set', 'add', 'addFitting', 'cancel', 'movePathEnd', 'zoom']
const disc = (id: number): Hit => ({ id, part: 'disc' })

describe('a press', () => {
  it('on a disc selects it, and moves it once it goes farther than a click', async () => {
    const stage = new Stage()
    stage.under = disc(0)
    await stage.press([pixel(1, 1), pixel(1.3, 1)])
    expect(stage.of(...DOING)).toEqual([['select', 0]])
    await stage.send('pointermove', pixel(1.4, 1))
    await stage.send('pointermove', pixel(1.2, 1))
    await stage.send('pointerup', pixel(1.2, 1))
    const moved = (x: number) => ['set', 1, { id: 0, circle: { x: expect.closeTo(x), y: expect.closeTo(0), r: 4 } }]
    expect(stage.of(...DOING)).toEqual([['select', 0], moved(0.4), moved(0.2)])
    expect(stage.camera).toBe(CAMERA)
    expect(stage.element.captured).toEqual([1])
    expect(stage.slack).toBe(0.5)
  })

  it('and release without a move selects one, of several too', async () => {
    const stage = new Stage()
    stage.under = disc(1)
    stage.selection = [0, 1]
    await stage.drag([pixel(10, 0)])
    expect(stage.of(...DOING)).toEqual([['select', 1]])
  })

  it('on one of several moves all of them, the grabbed one to where it snaps', async () => {
    const stage = new Stage()
    stage.under = disc(1)
    stage.selection = [0, 1]
    await stage.press([pixel(10, 0), pixel(12, 3)])
    await stage.send('pointermove', pixel(12, 3), { altKey: true })
    expect(stage.of(...DOING, 'snapped')).toEqual([
      ['set', 1, { id: 0, circle: { x: 2, y: 3, r: 4 } }, { id: 1, circle: { x: 12, y: 3, r: 2 } }],
      ['snapped', 0.8, false],
      ['set', 1, { id: 0, circle: { x: -3, y: 3, r: 4 } }, { id: 1, circle: { x: 7, y: 3, r: 2 } }],
    ])
    stage.snaps = true
    await stage.send('pointermove', pixel(12, 3), { altKey: true })
    expect(stage.of('snapped')).toHaveLength(1)
    await stage.send('pointermove', pixel(12, 3))
    expect(stage.of('snapped')).toHaveLength(2)
  })

  it('on a rim makes one circle as large as the pointer goes, from where it was grabbed', async () => {
    const stage = new Stage()
    stage.under = { id: 0, part: 'rim' }
    await stage.press([pixel(4.5, 0), pixel(6, 0)])
    await stage.send('pointermove', pixel(0.2, 0))
    await stage.send('pointermove', pixel(6, 0), { altKey: true })
    const sized = (r: number) => ['set', 1, { id: 0, circle: { x: 0, y: 0, r: expect.closeTo(r) } }]
    expect(stage.of('set', 'snapped')).toEqual([sized(5.5), sized(0), ['snapped', 0.8, true], sized(7)])
    await stage.send('pointerup', pixel(6, 0))
    // Several selected circles are moved.
    stage.selection = [0, 1]
    await stage.press([pixel(4, 0), pixel(5, 0)])
    expect(stage.of('set').at(-1)).toMatchObject(['set', 2, { id: 0, circle: { x: 1, r: 4 } }, { id: 1 }])
  })

  it('on a rim and a release select the circle alone', async () => {
    const stage = new Stage()
    stage.under = { id: 0, part: 'rim' }
    stage.selection = [0]
    await stage.drag([pixel(4, 0)])
    expect(stage.of(...DOING)).toEqual([['select', 0]])
  })

  it('on a cell pans, and a click selects its circle', async () => {
    const stage = new Stage()
    stage.under = { id: 2, part: 'cell' }
    await stage.drag([pixel(5, 5), pixel(7, 4), pixel(8, 4)])
    expect(stage.of(...DOING)).toEqual([])
    expect(stage.camera).toEqual({ x: -3, y: 1, scale: 10 })
    await stage.drag([pixel(5, 5)])
    expect(stage.of(...DOING)).toEqual([['select', 2]])
  })

  it('where there is no circle pans and lets go; on one that may not be edited it pans and selects', async () => {
    const stage = new Stage()
    stage.selection = [0]
    await stage.drag([pixel(5, 5)])
    stage.under = disc(5)
    await stage.drag([pixel(5, 5)])
    expect(stage.of(...DOING)).toEqual([['select'], ['select', 5]])
    await stage.drag([pixel(5, 5), pixel(6, 5)])
    expect(stage.camera.x).toBe(-1)
  })

  it('of a finger drags the circle that it hits, and pans where many are in its reach, unless one is selected', async () => {
    const touch = { pointerType: 'touch' }
    for (const inReach of [undefined, 1, 4]) {
      const stage = new Stage()
      stage.under = { ...disc(0), ...(inReach && { inReach }) }
      await stage.press([pixel(0, 0), pixel(1, 0)], touch)
      expect([stage.slack, stage.reach, stage.handleSlack]).toEqual([1.2, 2.2, 12])
      expect(stage.of('select', 'set').map(([what]) => what)).toEqual(['select', 'set'])
    }
    const stage = new Stage()
    stage.under = { ...disc(0), inReach: 5 }
    await stage.drag([pixel(0, 0), pixel(1, 0)], touch)
    expect(stage.of(...DOING)).toEqual([])
    expect(stage.camera.x).toBe(-1)
    await stage.press([pixel(0, 0)], touch)
    await stage.send('pointerup', pixel(0, 0), touch)
    expect(stage.of(...DOING)).toEqual([['select', 0]])
    await stage.drag([pixel(0, 0), pixel(1, 0)], touch)
    expect(stage.of('set')).toHaveLength(1)
  })

  it('of a finger selects nothing before it is lifted or moves, and resizes only a selected circle', async () => {
    const touch = { pointerType: 'touch' }
    const stage = new Stage()
    stage.under = { id: 0, part: 'rim' }
    await stage.press([pixel(4, 0)], touch)
    expect(stage.of(...DOING)).toEqual([])
    await stage.send('pointermove', pixel(6, 0), touch)
    await stage.send('pointerup', pixel(6, 0), touch)
    expect(stage.of('set').at(-1)?.[2]).toEqual({ id: 0, circle: { x: 2, y: 0, r: 4 } })
    await stage.drag([pixel(4, 0), pixel(6, 0)], touch)
    expect(stage.of('set').at(-1)?.[2]).toEqual({ id: 0, circle: { x: 0, y: 0, r: 6 } })
  })

  it('of other buttons does nothing; the middle one pans, and does not scroll', async () => {
    const stage = new Stage()
    stage.under = disc(0)
    expect((await stage.send('pointerdown', pixel(0, 0), { button: 2 })).defaultPrevented).toBe(false)
    expect(stage.element.captured).toEqual([])
    await stage.send('pointermove', pixel(3, 0))
    expect(stage.camera).toBe(CAMERA)
    expect((await stage.send('pointerdown', pixel(0, 0), { button: 1 })).defaultPrevented).toBe(true)
    await stage.send('pointermove', pixel(1, 0))
    await stage.send('pointerup', pixel(1, 0))
    await stage.drag([pixel(0, 0)], { button: 1 })
    expect(stage.camera.x).toBe(-1)
    expect(stage.of(...DOING)).toEqual([])
    expect((await stage.send('pointerdown', pixel(0, 0))).defaultPrevented).toBe(false)
  })

  it('with the tool to pan pans, also on a circle, and a click does nothing', async () => {
    const stage = new Stage()
    stage.tool = 'pan'
    stage.under = disc(0)
    stage.pathEnd = 'to'
    stage.handle = { x: 0, y: 0 }
    await stage.drag([pixel(0, 0), pixel(0, 1)])
    await stage.drag([pixel(0, 0)])
    expect(stage.camera).toEqual({ x: 0, y: -1, scale: 10 })
    expect(stage.of(...DOING)).toEqual([])
  })
})

describe('a press is answered at once', () => {
  /** Sends an event without waiting for anything. */
  const sendNow = (stage: Stage, type: string, point: Point, more: object = {}) => {
    stage.send(type, point, more)
  }

  it('by a drag of the circle under it', () => {
    const stage = new Stage()
    stage.under = disc(0)
    sendNow(stage, 'pointerdown', pixel(0, 0))
    expect(stage.of(...DOING)).toEqual([['select', 0]])
    sendNow(stage, 'pointermove', pixel(1, 0))
    sendNow(stage, 'pointermove', pixel(2, 0))
    expect(stage.of(...DOING)).toMatchObject([
      ['select', 0],
      ['set', 1, { circle: { x: 1 } }],
      ['set', 1, { circle: { x: 2 } }],
    ])
  })

  it('by a click on its cell, and by a band', () => {
    const stage = new Stage()
    stage.under = { id: 1, part: 'cell' }
    sendNow(stage, 'pointerdown', pixel(0, 0))
    expect(stage.of(...DOING)).toEqual([])
    sendNow(stage, 'pointerup', pixel(0, 0))
    expect(stage.of(...DOING)).toEqual([['select', 1]])

    sendNow(stage, 'pointerdown', pixel(1, 2), { shiftKey: true })
    sendNow(stage, 'pointermove', pixel(4, 6))
    sendNow(stage, 'pointerup', pixel(4, 6))
    expect(stage.of('selectWithin')).toEqual([['selectWithin', { minX: 1, minY: 2, maxX: 4, maxY: 6 }]])
  })

  it('where the pan before it has brought the picture', () => {
    const stage = new Stage()
    const touch = { pointerType: 'touch' }
    for (const press of [
      () => sendNow(stage, 'pointerdown', pixel(10, 0)),
      () => sendNow(stage, 'dblclick', pixel(10, 0)),
      () => sendNow(stage, 'pointerdown', pixel(10, 0), touch),
    ]) {
      stage.camera = CAMERA
      for (const [type, x, y] of [
        ['pointerdown', 0, 0],
        ['pointermove', 2, 1],
        ['pointerup', 2, 1],
      ] as const)
        sendNow(stage, type, pixel(x, y))
      stage.done.length = 0
      press()
      expect(stage.of('hit')).toEqual([['hit', 8, -1]])
      sendNow(stage, 'pointercancel', pixel(10, 0))
    }
  })

  it('and by Escape, after which nothing moves', () => {
    const stage = new Stage()
    stage.under = disc(0)
    sendNow(stage, 'pointerdown', pixel(0, 0))
    sendNow(stage, 'keydown', pixel(0, 0), { key: 'Escape' })
    sendNow(stage, 'pointermove', pixel(1, 0))
    expect(stage.of('set')).toEqual([])
  })
})

describe('a gesture', () => {
  it.each(['pointercancel', 'lostpointercapture'])('is taken back at %s', async (name) => {
    const stage = new Stage()
    stage.under = disc(0)
    await stage.press([pixel(0, 0), pixel(1, 0)])
    await stage.send(name, pixel(1, 0), { pointerId: 2 })
    expect(stage.of('cancel')).toEqual([])
    await stage.send(name, pixel(1, 0))
    expect(stage.of('cancel')).toEqual([['cancel', 1]])
    await stage.send('pointermove', pixel(2, 0))
    await stage.send('pointerup', pixel(2, 0))
    expect(stage.of('set')).toHaveLength(1)
    await stage.send(name, pixel(1, 0))
    expect(stage.of('cancel')).toHaveLength(1)
  })

  it('is taken back at Escape, which nobody else hears of', async () => {
    const stage = new Stage()
    let heard = 0
    stage.element.addEventListener('keydown', () => {
      heard += 1
    })
    stage.under = { id: 0, part: 'rim' }
    expect((await stage.send('keydown', pixel(0, 0), { key: 'Escape' })).defaultPrevented).toBe(false)
    await stage.press([pixel(4, 0), pixel(5, 0)])
    expect((await stage.send('keydown', pixel(0, 0), { key: 'a' })).defaultPrevented).toBe(false)
    expect(heard).toBe(2)
    expect((await stage.send('keydown', pixel(0, 0), { key: 'Escape' })).defaultPrevented).toBe(true)
    expect(heard).toBe(2)
    expect(stage.of('cancel')).toEqual([['cancel', 1]])
    await stage.send('pointerup', pixel(5, 0))
    expect((await stage.send('keydown', pixel(0, 0), { key: 'Escape' })).defaultPrevented).toBe(false)
  })

  it('with Shift selects within a band, or toggles what is clicked', async () => {
    const stage = new Stage()
    stage.under = disc(1)
    const shift = { shiftKey: true }
    await stage.press([pixel(1, 2), pixel(-3, 5)], shift)
    expect(stage.band).toEqual({ from: pixel(1, 2), to: pixel(-3, 5) })
    await stage.send('pointerup', pixel(-3, 5), shift)
    expect(stage.band).toBeUndefined()
    expect(stage.of(...DOING)).toEqual([['selectWithin', { minX: -3, minY: 2, maxX: 1, maxY: 5 }]])
    await stage.drag([pixel(1, 2)], shift)
    stage.under = undefined
    await stage.drag([pixel(1, 2)], shift)
    expect(stage.of('toggle', 'select')).toEqual([['toggle', 1]])
    await stage.press([pixel(1, 2), pixel(-3, 5)], shift)
    await stage.send('pointercancel', pixel(1, 2))
    expect(stage.band).toBeUndefined()
    expect(stage.of('selectWithin')).toHaveLength(1)
  })

  it('with the tool to draw places a corner where the pointer is released, also on a handle', async () => {
    const stage = new Stage()
    stage.tool = 'draw'
    stage.pathEnd = 'to'
    stage.handle = { x: 0, y: 0 }
    await stage.drag([pixel(1, 2)])
    expect(stage.of('draw')).toEqual([
      ['draw', 'move', { x: 1, y: 2 }, 0.8],
      ['draw', 'place', { x: 1, y: 2 }, 0.8],
    ])
    await stage.drag([pixel(1, 2), pixel(3, 2)])
    expect(stage.of('draw').slice(2)).toEqual([
      ['draw', 'move', { x: 1, y: 2 }, 0.8],
      ['draw', 'move', { x: 3, y: 2 }, 0.8],
      ['draw', 'place', { x: 3, y: 2 }, 0.8],
    ])
    stage.done.length = 0
    await stage.send('pointermove', pixel(4, 2))
    await stage.send('dblclick', pixel(4, 2))
    expect(stage.done).toEqual([
      ['hover', undefined],
      ['draw', 'move', { x: 4, y: 2 }, 0],
      ['draw', 'close', { x: 4, y: 2 }, 0],
    ])
    expect(stage.element.dataset.cursor).toBe('draw')
  })

  it('with the tool to add makes a circle: a click one that fits, a drag one as large', async () => {
    const stage = new Stage()
    stage.tool = 'add'
    stage.handle = { x: 0, y: 0 }
    await stage.drag([pixel(3, 4)])
    expect(stage.of(...DOING)).toEqual([['addFitting', { x: 3, y: 4 }]])
    await stage.press([pixel(3, 4), pixel(6, 8)])
    await stage.send('pointermove', pixel(3, 5))
    await stage.send('pointermove', pixel(3, 6), { altKey: true })
    const sized = (r: number) => ({ x: 3, y: 4, r: expect.closeTo(r) })
    expect(stage.of('add', 'set', 'snapped')).toEqual([
      ['add', 2, sized(5)],
      ['set', 2, { id: 9, circle: sized(5) }],
      ['set', 2, { id: 9, circle: sized(1) }],
      ['snapped', 0.8, true],
      ['set', 2, { id: 9, circle: sized(7) }],
    ])
    await stage.send('pointercancel', pixel(3, 5))
    expect(stage.of('cancel')).toEqual([['cancel', 2]])
  })

  it('that adds sets the circle as it was last, once it is there', async () => {
    const stage = new Stage()
    stage.tool = 'add'
    await stage.send('pointerdown', pixel(0, 0))
    for (const x of [1, 2, 3]) {
      stage.element.dispatchEvent(
        Object.assign(new Event('pointermove'), { pointerId: 1, offsetX: 400 + 10 * x, offsetY: 300, altKey: false }),
      )
    }
    await settled()
    expect(stage.of('add')).toEqual([['add', 1, { x: 0, y: 0, r: 1 }]])
    expect(stage.of('set')).toEqual(Array(2).fill(['set', 1, { id: 9, circle: { x: 0, y: 0, r: 3 } }]))
  })

  it('that adds and is taken back before the circle is there sets nothing', async () => {
    for (const takenBack of ['pointercancel', 'keydown']) {
      const stage = new Stage()
      stage.tool = 'add'
      let confirm = () => {}
      stage.add = () =>
        new Promise((resolve) => {
          confirm = () => resolve([9])
        })
      await stage.press([pixel(0, 0), pixel(1, 0), pixel(2, 0)])
      await stage.send(takenBack, pixel(2, 0), { key: 'Escape' })
      confirm()
      await settled()
      expect(stage.of('set', 'cancel')).toEqual([['cancel', 1]])
    }
  })

  it('that adds what is refused sets nothing', async () => {
    const stage = new Stage()
    stage.tool = 'add'
    stage.add = async () => []
    await stage.drag([pixel(0, 0), pixel(1, 0), pixel(2, 0)])
    expect(stage.of('set')).toEqual([])
  })

  it('at the handle scales what is selected about its middle', async () => {
    const stage = new Stage()
    stage.under = disc(0)
    stage.selection = [0, 1]
    stage.handle = { x: 5, y: 0 }
    await stage.press([pixel(9, 3), pixel(13, 6)])
    expect(stage.of(...DOING)).toEqual([
      ['set', 1, { id: 0, circle: { x: -5, y: 0, r: 8 } }, { id: 1, circle: { x: 15, y: 0, r: 4 } }],
    ])
    await stage.send('pointercancel', pixel(0, 0))
    expect(stage.of('cancel')).toEqual([['cancel', 1]])
    // A single circle is resized by its rim; no selection has no effect.
    stage.selection = [2]
    await stage.press([pixel(0, 12), pixel(0, 14)])
    expect(stage.of('set').at(-1)).toEqual(['set', 2, { id: 2, circle: { x: 0, y: 10, r: expect.closeTo(3) } }])
    await stage.send('pointerup', pixel(0, 14))
    stage.selection = []
    await stage.press([pixel(0, 12), pixel(0, 14)])
    expect(stage.of('set').at(-1)).toEqual(['set', 3])
  })

  it('moves an end of the path, and puts it back', async () => {
    const stage = new Stage()
    stage.handle = { x: 5, y: 0 }
    stage.pathEnd = 'to'
    stage.layers = { path: { from: { x: 0, y: 0 }, to: { x: 8, y: 8 } } }
    await stage.press([pixel(8, 8), pixel(9, 7)])
    await stage.send('pointercancel', pixel(9, 7))
    expect(stage.of(...DOING)).toEqual([
      ['movePathEnd', 'to', { x: 9, y: 7 }],
      ['movePathEnd', 'to', { x: 8, y: 8 }],
    ])
  })

  it('of two fingers zooms and pans, takes back what one did, and ends with one of them', async () => {
    const stage = new Stage()
    stage.under = disc(0)
    stage.selection = [0]
    await stage.press([pixel(0, 0), pixel(1, 0)])
    expect(stage.of('set')).toHaveLength(1)
    await stage.send('pointerdown', pixel(5, 0), { pointerId: 2 })
    expect(stage.of('cancel')).toEqual([['cancel', 1]])
    await stage.send('pointerdown', pixel(9, 9), { pointerId: 3 })
    await stage.send('pointermove', pixel(9, 0), { pointerId: 2 })
    // From (1, 0) and (5, 0) to (1, 0) and (9, 0): twice as far apart, with the middle 2 farther right.
    expect(stage.of('zoom')).toEqual([['zoom', 2, pixel(5, 0)]])
    expect(stage.camera).toEqual({ x: -2, y: 0, scale: 10 })
    await stage.send('pointermove', pixel(9, 0), { pointerId: 1 })
    expect(stage.of('zoom').at(-1)).toEqual(['zoom', 1 / 80, pixel(9, 0)])
    await stage.send('pointerup', pixel(9, 0), { pointerId: 2 })
    await stage.send('pointermove', pixel(3, 0), { pointerId: 1 })
    await stage.send('pointerup', pixel(3, 0), { pointerId: 1 })
    expect(stage.of('zoom')).toHaveLength(2)
    expect(stage.of('set')).toHaveLength(1)
    expect(stage.of('select')).toEqual([])
    expect(stage.element.captured).toEqual([1, 2])
  })
})

describe('a press that rests where nothing is', () => {
  beforeEach(() => {
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] })
  })
  afterEach(() => {
    vi.useRealTimers()
  })

  const send = async (stage: Stage, type: string, point: Point, more: object = {}) => {
    stage.send(type, point, more)
    await vi.advanceTimersByTimeAsync(0)
  }

  it('takes back what its press had begun', async () => {
    const stage = new Stage()
    stage.tool = 'add'
    await send(stage, 'pointerdown', pixel(1, 2))
    await vi.advanceTimersByTimeAsync(400)
    showFrame()
    await vi.advanceTimersByTimeAsync(0)
    expect(stage.of('cancel', 'tryCircle')).toEqual([
      ['cancel', 1],
      ['tryCircle', { x: 1, y: 2, r: 1 }],
    ])
  })

  it('tries a circle, and adds it where it is released', async () => {
    const stage = new Stage()
    await send(stage, 'pointerdown', pixel(1, 2))
    await vi.advanceTimersByTimeAsync(399)
    showFrame()
    await vi.advanceTimersByTimeAsync(1)
    expect(stage.of('tryCircle')).toEqual([])
    showFrame()
    await vi.advanceTimersByTimeAsync(0)
    expect(stage.of('tryCircle')).toEqual([['tryCircle', { x: 1, y: 2, r: 1 }]])
    await send(stage, 'pointermove', pixel(3, 2))
    await send(stage, 'pointerup', pixel(3, 2))
    expect(stage.of('tryCircle').slice(1)).toEqual([
      ['tryCircle', { x: 3, y: 2, r: 1 }],
      ['tryCircle', undefined],
    ])
    expect(stage.of(...DOING)).toEqual([['addFitting', { x: 3, y: 2 }]])
  })

  it('of a finger shows a disc that follows it where that layer is visible, and adds nothing', async () => {
    const rest = async (more: object, tool: GestureTarget['tool'] = 'select') => {
      const stage = new Stage()
      stage.layers = { disc: true } as object
      stage.tool = tool
      await send(stage, 'pointerdown', pixel(1, 2), more)
      await vi.advanceTimersByTimeAsync(400)
      showFrame()
      await vi.advanceTimersByTimeAsync(0)
      stage.done.length = 0
      await send(stage, 'pointermove', pixel(3, 2), more)
      await send(stage, 'pointerup', pixel(3, 2), more)
      return stage.of('touch', 'tryCircle', ...DOING)
    }
    const touch = { pointerType: 'touch' }
    expect(await rest(touch)).toEqual([['touch', { x: 3, y: 2 }, 2.4]])
    for (const others of [await rest({}), await rest(touch, 'add')])
      expect(others.at(-1)).toEqual(['addFitting', { x: 3, y: 2 }])
  })

  it('pans, if the move that came first is told of late, with a slow frame', async () => {
    const stage = new Stage()
    await send(stage, 'pointerdown', pixel(1, 2))
    await vi.advanceTimersByTimeAsync(900)
    await send(stage, 'pointermove', pixel(3, 2))
    showFrame()
    await send(stage, 'pointerup', pixel(3, 2))
    expect(stage.of('tryCircle', ...DOING)).toEqual([])
    expect(stage.camera.x).toBe(-2)
  })

  it('of a finger on a circle adds it to the selection; taps add more and remove them', async () => {
    const touch = { pointerType: 'touch' }
    const vibrate = vi.fn()
    vi.stubGlobal('navigator', { vibrate })
    const stage = new Stage()
    const rest = async () => {
      await vi.advanceTimersByTimeAsync(400)
      showFrame()
      await vi.advanceTimersByTimeAsync(0)
    }
    stage.selection = [1]
    stage.under = disc(0)
    await send(stage, 'pointerdown', pixel(0, 0), touch)
    await rest()
    expect(stage.of('tryCircle', ...DOING)).toEqual([['toggle', 0]])
    expect(vibrate).toHaveBeenCalledOnce()
    await send(stage, 'pointerup', pixel(0, 0), touch)
    stage.selection = [1, 0]
    // A selected circle stays selected under a finger that rests, and is dragged with the others.
    await send(stage, 'pointerdown', pixel(0, 0), touch)
    await rest()
    await send(stage, 'pointermove', pixel(1, 0), touch)
    await send(stage, 'pointerup', pixel(1, 0), touch)
    expect(stage.of('toggle')).toHaveLength(1)
    expect(stage.of('set').at(-1)).toHaveLength(4)
    for (const id of [0, 2]) {
      stage.under = disc(id)
      await send(stage, 'pointerdown', pixel(0, 0), touch)
      await send(stage, 'pointerup', pixel(0, 0), touch)
    }
    expect(stage.of('toggle').slice(1)).toEqual([
      ['toggle', 0],
      ['toggle', 2],
    ])
    // A click selects one circle, and a tap in a cell does too, whether or not the page scrolls.
    await send(stage, 'pointerdown', pixel(0, 0))
    await send(stage, 'pointerup', pixel(0, 0))
    expect(stage.of('select').at(-1)).toEqual(['select', 2])
    for (const letsPageScroll of [false, true]) {
      const other = new Stage({ letsPageScroll })
      for (const part of ['cell', 'disc'] as const) {
        other.selection = [1, 0]
        other.isReadonly = true
        other.under = { id: 2, part }
        await send(other, 'pointerdown', pixel(0, 0), touch)
        await send(other, 'pointerup', pixel(0, 0), touch)
      }
      expect(other.of('select', 'toggle')).toEqual([
        ['select', 2],
        ['toggle', 2],
      ])
    }
  })

  it('is none once nothing is listened to', async () => {
    const stage = new Stage()
    await send(stage, 'pointerdown', pixel(1, 2))
    stage.listening.stop()
    await vi.advanceTimersByTimeAsync(900)
    showFrame()
    await vi.advanceTimersByTimeAsync(0)
    expect(stage.of('hit')).toEqual([['hit', 1, 2]])
    expect(stage.of('tryCircle')).toEqual([])
  })

  it('asks again only for the last place once a circle is known', async () => {
    const stage = new Stage()
    const asked: Point[] = []
    let know = () => {}
    stage.tryCircle = (circle) => {
      if (circle === undefined) return Promise.resolve()
      asked.push(circle)
      return new Promise((resolve) => {
        know = resolve
      })
    }
    await send(stage, 'pointerdown', pixel(1, 2))
    await vi.advanceTimersByTimeAsync(400)
    showFrame()
    await vi.advanceTimersByTimeAsync(0)
    for (const x of [3, 4, 5]) await send(stage, 'pointermove', pixel(x, 2))
    expect(asked.map(({ x }) => x)).toEqual([1])
    know()
    await vi.advanceTimersByTimeAsync(0)
    expect(asked.map(({ x }) => x)).toEqual([1, 5])
    know()
    await vi.advanceTimersByTimeAsync(0)
    await send(stage, 'pointermove', pixel(6, 2))
    expect(asked.map(({ x }) => x)).toEqual([1, 5, 6])
    // An answer after the release has no effect.
    await send(stage, 'pointermove', pixel(7, 2))
    await send(stage, 'pointerup', pixel(7, 2))
    know()
    await vi.advanceTimersByTimeAsync(0)
    expect(asked.map(({ x }) => x)).toEqual([1, 5, 6])
  })

  it('tries none with another tool, another button, Shift, or on a handle', async () => {
    const rests = async (change: (stage: Stage) => void, more: object = {}) => {
      const stage = new Stage()
      change(stage)
      stage.send('pointerdown', pixel(1, 2), more)
      await vi.advanceTimersByTimeAsync(400)
      showFrame()
      await vi.advanceTimersByTimeAsync(0)
      return stage.of('tryCircle')
    }
    const changes: Partial<Stage>[] = [
      { tool: 'pan' },
      { tool: 'draw' },
      { pathEnd: 'to' },
      { handle: { x: 0, y: 0 } },
      { under: disc(0) },
      { under: { id: 0, part: 'rim' } },
    ]
    for (const change of changes) expect(await rests((stage) => Object.assign(stage, change))).toEqual([])
    for (const more of [{ shiftKey: true }, { button: 1 }]) expect(await rests(() => {}, more)).toEqual([])
    for (const change of [{ tool: 'add', under: disc(0) }, { under: { id: 0, part: 'cell' } }]) {
      expect(await rests((stage) => Object.assign(stage, change))).toHaveLength(1)
    }
  })

  it('is none any more once another one has begun', async () => {
    const stage = new Stage()
    await send(stage, 'pointerdown', pixel(1, 2))
    await vi.advanceTimersByTimeAsync(900)
    await send(stage, 'pointerup', pixel(1, 2))
    await send(stage, 'pointerdown', pixel(5, 2))
    showFrame()
    await vi.advanceTimersByTimeAsync(0)
    expect(stage.of('tryCircle')).toEqual([])
  })
})

describe('in a page that scrolls', () => {
  const touch = { pointerType: 'touch' }

  it('a finger where nothing can be dragged leaves scrolling to the page, and selects what it taps', async () => {
    const stage = new Stage({ letsPageScroll: true })
    stage.isReadonly = true
    stage.under = disc(0)
    await stage.drag([pixel(1, 0), pixel(5, 0)], touch)
    expect(stage.of(...DOING)).toEqual([])
    expect(stage.camera).toBe(CAMERA)
    await stage.press([pixel(1, 0)], touch)
    expect([stage.slack, stage.reach]).toEqual([1.2, 2.2])
    await stage.send('pointerup', pixel(1, 0), touch)
    expect(stage.of(...DOING)).toEqual([['select', 0]])
    stage.under = undefined
    await stage.drag([pixel(9, 9)], touch)
    expect(stage.of('select').at(-1)).toEqual(['select'])
    // A mouse does not scroll the page.
    stage.isReadonly = false
    stage.under = disc(0)
    await stage.drag([pixel(0, 0), pixel(1, 0)])
    expect(stage.of('set')).toHaveLength(1)
  })

  it('a finger drags a circle at once, however small, and keeps the page still', async () => {
    const stage = new Stage({ letsPageScroll: true })
    stage.under = disc(2)
    await stage.drag([pixel(0, 10), pixel(1, 10)], touch)
    expect(stage.of('set')).toHaveLength(1)
    expect(stage.of('hit')[0]).toEqual(['hit', 0, 10])
    expect([stage.slack, stage.reach]).toEqual([0.5, 0])
  })

  it('only a finger that drags, or a second one, keeps the page from scrolling', async () => {
    const stage = new Stage({ letsPageScroll: true })
    stage.hitAt = ({ x }) => (x === 0 ? disc(0) : { id: 0, part: 'cell' })
    // Pointer events precede touch events.
    const keeps = async (...places: number[]) => {
      const fingers = places.map((x, pointerId) => [pixel(x, 0), { ...touch, pointerId }] as const)
      for (const finger of fingers) await stage.send('pointerdown', ...finger)
      const { defaultPrevented } = await stage.send('touchstart', pixel(0, 0), { touches: fingers })
      for (const finger of fingers) await stage.send('pointerup', ...finger)
      return defaultPrevented
    }
    expect([await keeps(), await keeps(0), await keeps(1)]).toEqual([false, true, false])
    expect(await keeps(1, 2)).toBe(true)
    for (const change of [{ tool: 'add' }, { tool: 'select', pathEnd: 'to' }] as const) {
      Object.assign(stage, change)
      expect(await keeps(1)).toBe(true)
    }
    Object.assign(stage, { pathEnd: undefined, handle: { x: 0, y: 0 } })
    expect(await keeps(1)).toBe(true)
  })

  it('gestures of the view do not reach a page with gestures of its own, and those that scroll do', async () => {
    const stage = new Stage({ letsPageScroll: true })
    stage.hitAt = ({ x }) => (x === 0 ? disc(0) : undefined)
    /** The events of a press that the page does not hear of. */
    const kept = async (x: number, count: number, more: object = {}, own = stage) => {
      const touches = Array.from({ length: count }, (_, k) => k)
      const seen: string[] = []
      const send = async (type: string, pointerId = 0) => {
        const event = await own.send(type, pixel(x, 0), { ...more, pointerId, touches })
        if (event.cancelBubble) seen.push(type)
      }
      await send('pointermove')
      for (const id of touches) await send('pointerdown', id)
      const isTouch = 'pointerType' in more
      for (const type of isTouch ? ['touchstart', 'touchmove', 'touchend', 'touchcancel'] : ['mousedown'])
        await send(type)
      await send('pointermove')
      for (const id of touches) await send('pointerup', id)
      return seen.join(' ')
    }
    expect(await kept(5, 1)).toBe('pointerdown mousedown pointermove pointerup')
    expect(await kept(0, 1)).toBe('pointerdown mousedown pointermove pointerup')
    expect(await kept(5, 1, touch)).toBe('')
    expect(await kept(0, 1, touch)).toBe('pointerdown touchstart touchmove touchend touchcancel pointermove pointerup')
    // The last of two fingers may scroll.
    expect(await kept(5, 2, touch)).toBe('pointerdown touchstart touchmove touchend touchcancel pointermove')
    // A page that does not scroll has no gestures of its own.
    expect(await kept(0, 1, {}, new Stage())).toBe('')
    const wheel = async (own: Stage) =>
      (await own.send('wheel', pixel(0, 0), { deltaY: 1, ctrlKey: true })).cancelBubble
    vi.stubGlobal('WheelEvent', { DOM_DELTA_LINE: 1 })
    expect([await wheel(stage), await wheel(new Stage())]).toEqual([true, false])
    vi.unstubAllGlobals()
  })

  it('a finger that drags gives the keys to the view', async () => {
    const stage = new Stage({ letsPageScroll: true })
    const focused: unknown[] = []
    Object.assign(stage.element, { focus: (options: unknown) => focused.push(options) })
    stage.hitAt = ({ x }) => (x === 0 ? disc(0) : undefined)
    await stage.drag([pixel(5, 0)], touch)
    await stage.drag([pixel(5, 0)])
    expect(focused).toEqual([])
    await stage.drag([pixel(0, 0)], touch)
    expect(focused).toEqual([{ preventScroll: true }])
  })

  it('the wheel scrolls the page until the view is pressed, and again once the pointer has left; with Ctrl it zooms', async () => {
    vi.stubGlobal('WheelEvent', { DOM_DELTA_LINE: 1 })
    const stage = new Stage({ letsPageScroll: true })
    const zooms = async (more: object = {}) => {
      const before = stage.of('zoom').length
      const { defaultPrevented } = await stage.send('wheel', pixel(1, 2), { deltaY: 100, deltaMode: 0, ...more })
      expect(stage.of('zoom').length > before).toBe(defaultPrevented)
      return defaultPrevented
    }
    expect([await zooms(), await zooms({ ctrlKey: true }), await zooms()]).toEqual([false, true, false])
    await stage.drag([pixel(5, 5)])
    expect(await zooms()).toBe(true)
    await stage.send('pointerleave', pixel(0, 0))
    expect(await zooms()).toBe(false)
  })
})

describe('a pointer that is not pressed', () => {
  it('hovers over what is under it after the picture has changed, and over nothing once it has left', async () => {
    const stage = new Stage()
    stage.under = disc(1)
    await stage.send('pointermove', pixel(1, 2))
    for (const [name, id] of [
      ['camera', 2],
      ['changed', 0],
    ] as const) {
      stage.under = disc(id)
      stage.listeners.get(name)?.()
      await settled()
      expect(stage.of('hover').at(-1)).toEqual(['hover', id])
    }
    await stage.send('pointerleave', pixel(0, 0))
    stage.done.length = 0
    stage.listeners.get('camera')?.()
    await settled()
    expect(stage.of('hit', 'hover')).toEqual([])
    stage.listening.stop()
    expect(stage.listeners.size).toBe(0)
  })

  it('hovers where a drag has left it once the last edit arrives', async () => {
    const stage = new Stage()
    stage.under = disc(0)
    await stage.send('pointermove', pixel(1, 2))
    await stage.press([pixel(1, 2), pixel(4, 6)])
    stage.done.length = 0
    stage.listeners.get('changed')?.()
    expect(stage.of('hit', 'hover'), 'nothing during the drag').toEqual([])
    await stage.send('pointerup', pixel(4, 6))
    stage.done.length = 0
    stage.listeners.get('changed')?.()
    expect(stage.of('hit', 'hover')).toEqual([
      ['hit', 4, 6],
      ['hover', 0],
    ])
  })

  it('hovers, and its cursor says what a press would do', async () => {
    const stage = new Stage()
    for (const [under, cursor] of [
      [disc(1), 'disc'],
      [{ id: 1, part: 'rim' }, 'rim'],
      [{ id: 2, part: 'cell' }, 'cell'],
      [undefined, 'cell'],
    ] as const) {
      stage.under = under
      await stage.send('pointermove', pixel(1, 2))
      expect(stage.of('hover').at(-1)).toEqual(['hover', under?.id])
      expect(stage.element.dataset.cursor).toBe(cursor)
    }
    expect(stage.of('touch')[0]).toEqual(['touch', { x: 1, y: 2 }, 1.4])
    expect(stage.slack).toBe(0.5)
    stage.handle = { x: 0, y: 0 }
    await stage.send('pointermove', pixel(1, 2))
    expect(stage.element.dataset.cursor).toBe('scale')
    for (const tool of ['add', 'pan'] as const) {
      stage.tool = tool
      await stage.send('pointermove', pixel(1, 2))
      expect(stage.element.dataset.cursor).toBe(tool)
    }
  })

  it('of a finger does not, nor what comes after a press', async () => {
    const stage = new Stage()
    await stage.send('pointermove', pixel(1, 2), { pointerType: 'touch' })
    expect(stage.done).toEqual([])
    await stage.send('pointerdown', pixel(1, 2))
    stage.listeners.get('camera')?.()
    await stage.send('pointermove', pixel(5, 2))
    expect(stage.of('hover')).toEqual([])
  })

  it('of a finger that taps shows a disc, which stays once the finger is lifted', async () => {
    const stage = new Stage()
    const touch = { pointerType: 'touch' }
    await stage.drag([pixel(1, 2)], touch)
    await stage.send('pointerleave', pixel(1, 2), touch)
    expect(stage.of('touch')).toEqual([['touch', { x: 1, y: 2 }, 2.4]])
    // The disc stays until the next tap, or until a mouse leaves.
    await stage.drag([pixel(5, 5)], touch)
    await stage.send('pointerleave', pixel(5, 5))
    expect(stage.of('touch').slice(1)).toEqual([
      ['touch', { x: 5, y: 5 }, 2.4],
      ['touch', undefined, 0],
    ])
  })

  it('has left: nothing is hovered', async () => {
    const stage = new Stage()
    await stage.send('pointerleave', pixel(0, 0))
    expect(stage.done).toEqual([
      ['hover', undefined],
      ['touch', undefined, 0],
    ])
  })

  it('has left: the circle that it hovered over is not hovered any more', async () => {
    const stage = new Stage()
    stage.under = disc(0)
    await stage.send('pointermove', pixel(1, 2))
    await stage.send('pointerleave', pixel(0, 0))
    expect(stage.of('hover')).toEqual([
      ['hover', 0],
      ['hover', undefined],
    ])
  })

  it('shows that it pans while it does', async () => {
    const stage = new Stage()
    stage.under = { id: 0, part: 'cell' }
    await stage.send('pointermove', pixel(1, 2))
    await stage.press([pixel(1, 2), pixel(3, 2)])
    expect(stage.element.dataset.cursor).toBe('panning')
    await stage.send('pointerup', pixel(3, 2))
    expect(stage.element.dataset.cursor).toBe('cell')
    stage.tool = 'pan'
    await stage.send('pointermove', pixel(1, 2))
    await stage.press([pixel(1, 2)])
    expect(stage.element.dataset.cursor).toBe('panning')
    await stage.send('pointerup', pixel(1, 2))
    stage.tool = 'select'
    stage.under = disc(0)
    await stage.send('pointermove', pixel(1, 2))
    await stage.press([pixel(1, 2)])
    expect(stage.element.dataset.cursor).toBe('disc')
  })
})

describe('clicks and wheels', () => {
  it('a double click adds where no circle is', async () => {
    const stage = new Stage()
    stage.under = disc(0)
    await stage.send('dblclick', pixel(1, 2))
    expect(stage.of('addFitting')).toEqual([])
    stage.under = { id: 0, part: 'cell' }
    await stage.send('dblclick', pixel(1, 2))
    stage.under = undefined
    await stage.send('dblclick', pixel(3, 2))
    expect(stage.of('addFitting')).toEqual([
      ['addFitting', { x: 1, y: 2 }],
      ['addFitting', { x: 3, y: 2 }],
    ])
  })

  it('a wheel zooms at the pointer, by pixels, lines and pinches, and does not scroll', async () => {
    const before = globalThis.WheelEvent
    globalThis.WheelEvent = { DOM_DELTA_LINE: 1 } as typeof WheelEvent
    try {
      const stage = new Stage()
      for (const [deltaMode, ctrlKey, power] of [
        [0, false, -0.16],
        [0, true, -1],
        [1, false, -2.56],
      ] as const) {
        const event = await stage.send('wheel', pixel(1, 2), { deltaY: 100, deltaMode, ctrlKey })
        expect(event.defaultPrevented).toBe(true)
        expect(stage.of('zoom').at(-1)).toEqual(['zoom', expect.closeTo(Math.exp(power), 10), pixel(1, 2)])
      }
    } finally {
      globalThis.WheelEvent = before
    }
  })

  it('after the end nothing is heard', async () => {
    const stage = new Stage()
    stage.listening.stop()
    expect(stage.listeners.size).toBe(0)
    await stage.press([pixel(0, 0), pixel(1, 0)])
    await stage.send('pointermove', pixel(1, 2), { pointerId: 7 })
    await stage.send('dblclick', pixel(1, 2))
    await stage.send('keydown', pixel(1, 2), { key: 'Escape' })
    expect(stage.done).toEqual([])
  })
})

it('a press is known until its last finger is lifted, and opens no menu', async () => {
  const stage = new Stage()
  const menu = async () => (await stage.send('contextmenu', pixel(1, 2))).defaultPrevented
  const seen: unknown[] = [[stage.listening.isPressed, await menu()]]
  for (const [type, pointerId] of [
    ['pointerdown', 1],
    ['pointerdown', 2],
    ['pointerup', 1],
    ['pointerup', 2],
  ] as const) {
    await stage.send(type, pixel(1, 2), { pointerId, pointerType: 'touch' })
    seen.push([stage.listening.isPressed, await menu()])
  }
  expect(seen).toEqual([false, true, true, true, false].map((isPressed) => [isPressed, isPressed]))
})

it('points are those of the plane, wherever the camera is', async () => {
  const stage = new Stage()
  stage.camera = { x: 3, y: -2, scale: 4 }
  stage.tool = 'add'
  await stage.drag([{ x: 100, y: 500 }])
  expect(stage.of('addFitting')).toEqual([['addFitting', toPlane(stage.camera, SIZE, { x: 100, y: 500 })]])
})
