// SPDX-License-Identifier: GPL-3.0-or-later
// Animations as edits, their videos, the motion of the first scene, and the slider of radii, with a clock of the test.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { driftAtStart } from '../../web/app/motion/drift.ts'
import { filmed } from '../../web/app/motion/film.ts'
import { MOST_MOVING, Motion } from '../../web/app/motion/motion.ts'
import { PageActions } from '../../web/app/page-actions.ts'
import type { Circle } from '../../web/lib/index.ts'
import { CircleTable } from '../../web/view/circle-table.ts'
import type { View } from '../../web/view/view.ts'
import { editingSession, sceneOf } from './editing-session.ts'
import { settled } from './turns.ts'

/** Frames of a browser that the test shows. */
let frames: Map<number, (now: number) => void>
let lastFrame: number
beforeEach(() => {
  frames = new Map()
  lastFrame = 0
  vi.stubGlobal('requestAnimationFrame', (act: (now: number) => void) => {
    lastFrame += 1
    frames.set(lastFrame, act)
    return lastFrame
  })
  vi.stubGlobal('cancelAnimationFrame', (frame: number) => frames.delete(frame))
})
afterEach(() => {
  vi.unstubAllGlobals()
  vi.useRealTimers()
})
async function show(now: number) {
  for (const [frame, act] of [...frames]) {
    frames.delete(frame)
    act(now)
  }
  await settled()
}

const PADDING = { top: 10, right: 20, bottom: 30, left: 40 }

describe('an animation', () => {
  async function started(circles = [0, 0, 1, 10, 0, 2]) {
    const session = editingSession({
      size: { width: 200, height: 100 },
    })
    const { editing, view } = session
    await editing.open(sceneOf(Float64Array.from(circles)))
    const reader = { call: () => Promise.reject(new Error()), cancel() {} }
    const motion = new Motion(view, editing, new PageActions(session.store, editing, view, () => PADDING, reader))
    const changes: boolean[] = []
    motion.onchange(() => changes.push(motion.isMoving))
    const radii = () => [...editing.circles.circles()].filter((_, k) => k % 3 === 2)
    return { ...session, motion, changes, radii }
  }

  it('edits circles in each frame, tells its begin and its end, and is one step of undo', async () => {
    const { motion, changes, radii, actions, store, circles } = await started()
    actions.select([0])
    motion.start('grow')
    expect([motion.isMoving, changes, store.get().selection]).toEqual([true, [true], []])
    await show(1000)
    expect(radii()).toEqual([0, 0])
    for (let now = 1050; now <= 6000; now += 50) await show(now)
    // Radii grow within five seconds.
    expect(radii()[1]).toBeCloseTo(2, 6)
    motion.stop()
    motion.stop()
    const before = circles()
    await show(7000)
    expect([motion.isMoving, changes, circles()]).toEqual([false, [true, false], before])
    await actions.undo()
    expect(circles()).toEqual([0, 0, 1, 10, 0, 2])
    await actions.undo()
    expect(circles(), 'one step').toEqual([0, 0, 1, 10, 0, 2])
  })

  it('moves no farther in a late frame than in a twentieth of a second', async () => {
    const { motion, radii } = await started()
    motion.start('grow')
    await show(0)
    await show(60_000)
    const [late = 0] = radii()
    expect(late).toBeCloseTo((1 - Math.cos((2 * Math.PI * 0.05) / 10)) / 2, 12)
  })

  it('ends where other circles are opened, and skips circles that are deleted', async () => {
    const { motion, editing, radii } = await started()
    motion.start('grow')
    await show(0)
    await editing.edit([{ kind: 'remove', id: 0 }])
    await show(50)
    expect([motion.isMoving, radii().length]).toEqual([true, 1])
    await editing.open(sceneOf(Float64Array.of(0, 0, 3)))
    await show(100)
    await show(150)
    expect([motion.isMoving, radii()]).toEqual([false, [3]])
  })

  it('of no circles does nothing, and of too many is refused', async () => {
    const { motion, changes } = await started([])
    motion.start('bounce')
    expect([motion.isMoving, changes]).toEqual([false, []])
    const grid = (count: number) => Array.from({ length: count }, (_, k) => [k % 50, Math.floor(k / 50), 0.1]).flat()
    const many = await started(grid(MOST_MOVING + 1))
    many.motion.start('bounce')
    expect([many.motion.isMoving, many.store.get().problem]).toEqual([
      false,
      'At most 2,000 circles can move at once; there are more.',
    ])
    const most = await started(grid(MOST_MOVING))
    most.motion.start('bounce')
    expect(most.motion.isMoving).toBe(true)
  })
})

describe('the motion of the first scene', () => {
  function drifting(isStill = false) {
    const page = new EventTarget()
    vi.stubGlobal('document', page)
    vi.stubGlobal('matchMedia', () => ({ matches: isStill }))
    let now = 0
    vi.stubGlobal('performance', { now: () => now })
    class Pressed extends Event {
      clientX = 0
      clientY = 0
    }
    vi.stubGlobal('PointerEvent', Pressed)
    const table = new CircleTable(Float64Array.from(Array.from({ length: 8 }, (_, k) => [10 * k, 5, 1]).flat()))
    const moved: Circle[] = []
    let answer = () => Promise.resolve()
    const view = {
      circles: table,
      camera: { x: 70, y: 5, scale: 10 },
      size: { width: 100, height: 100 },
      apply: ([{ circle, id }]: [{ circle: Circle; id: number }]) => {
        expect(id).toBe(7)
        moved.push(circle)
        return answer()
      },
    }
    const figure = { getBoundingClientRect: () => ({ left: 20, top: 30 }) }
    const heard = vi.spyOn(page, 'addEventListener')
    let ends = 0
    driftAtStart(view as unknown as View, figure as unknown as HTMLElement, () => ends++)
    const at = async (time: number) => {
      now = time
      await show(time)
      return moved.at(-1)
    }
    const press = (clientX: number, clientY: number) =>
      page.dispatchEvent(Object.assign(new Pressed('pointerdown'), { clientX, clientY }))
    const isHeard = () => heard.mock.calls.some(([, , options]) => !(options as { signal: AbortSignal }).signal.aborted)
    return {
      isHeard,
      at,
      press,
      page,
      view,
      moved,
      ends: () => ends,
      setAnswer: (next: typeof answer) => {
        answer = next
      },
    }
  }
  const HOME = { x: 70, y: 5, r: 1 }
  const closeTo = ({ x, y }: { x: number; y: number }) => ({ x: expect.closeTo(x), y: expect.closeTo(y), r: 1 })

  it.each(['pointerdown', 'keydown', 'wheel'])('goes home after %s, and ends', async (name) => {
    const { at, page, ends, moved, isHeard } = drifting()
    expect(isHeard()).toBe(true)
    await at(0)
    await at(4500)
    page.dispatchEvent(new Event(name))
    expect(await at(4500 + 175)).toEqual(closeTo({ x: 70 + 1.8 / 4, y: 5 }))
    page.dispatchEvent(new Event(name))
    expect(await at(4500 + 350)).toEqual(HOME)
    expect(ends()).toBe(0)
    await at(5000)
    const { length } = moved
    await at(6000)
    expect([ends(), moved.length, frames.size, isHeard()]).toEqual([1, length, 0, false])
  })

  it('leaves the circle where a pointer grabs it, and moves on beside it', async () => {
    const { at, press, ends, moved } = drifting()
    await at(0)
    await at(4500)
    // The circle is at 71.8, 5, which is 18 pixels right of the middle.
    press(20 + 50 + 18 + 15, 30 + 50)
    await at(4600)
    expect(moved.at(-1)).not.toEqual(HOME)
    const { length } = moved
    expect(ends()).toBe(0)
    press(20 + 50 + 16, 30 + 50)
    await at(4700)
    await at(4800)
    expect([ends(), moved.length]).toEqual([1, length])
  })

  it('is off where people prefer less motion', async () => {
    const { at, moved, ends } = drifting(true)
    await at(0)
    expect([moved, ends(), frames.size]).toEqual([[], 0, 0])
  })
})

describe('a video', () => {
  const stopped: string[] = []
  const tracks = [1, 2].map((track) => ({ stop: () => stopped.push(`track ${track}`) }))
  const stream = Object.assign(new EventTarget(), { getTracks: () => tracks }) as EventTarget as MediaStream
  function recorder(supported: readonly string[]) {
    vi.useFakeTimers()
    stopped.length = 0
    const made: unknown[] = []
    class Recorder {
      static isTypeSupported = (type: string) => supported.includes(type)
      ondataavailable = (_: { data: Blob }) => {}
      onstop = () => {}
      constructor(...what: unknown[]) {
        made.push(what)
      }
      start() {
        this.ondataavailable({ data: new Blob(['a']) })
      }
      stop() {
        stopped.push('recorder')
        this.ondataavailable({ data: new Blob(['b']) })
        this.onstop()
      }
    }
    vi.stubGlobal('MediaRecorder', Recorder)
    return made
  }

  it.each([
    [['video/webm', 'video/mp4'], 'video/mp4', '.mp4'],
    [['video/webm', 'video/webm;codecs=vp9'], 'video/webm;codecs=vp9', '.webm'],
    [['video/webm'], 'video/webm', '.webm'],
  ])('has the first format that the browser writes: %j', async (supported, mimeType, ending) => {
    const made = recorder(supported)
    const film = filmed(stream, 3)
    await vi.advanceTimersByTimeAsync(2999)
    expect(stopped).toEqual([])
    await vi.advanceTimersByTimeAsync(1)
    const { film: blob, ending: ended } = await film
    expect([ended, blob.type, await blob.text()]).toEqual([ending, mimeType, 'ab'])
    expect(stopped).toEqual(['recorder', 'track 1', 'track 2'])
    expect(made).toEqual([[stream, { mimeType, videoBitsPerSecond: 8_000_000 }]])
  })

  it('is refused where the browser writes none', async () => {
    recorder([])
    await expect(filmed(stream, 3)).rejects.toThrow()
    vi.stubGlobal('MediaRecorder', undefined)
    await expect(filmed(stream, 3)).rejects.toThrow()
  })
})
