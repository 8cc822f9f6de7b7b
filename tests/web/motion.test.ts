// SPDX-License-Identifier: GPL-3.0-or-later
// Animations as edits and their videos, with a clock of the test.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { filmed } from '../../web/app/motion/film.ts'
import { MOST_MOVING, Motion } from '../../web/app/motion/motion.ts'
import { pageSession, sceneOf } from './editing-session.ts'
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

describe('an animation', () => {
  async function started(circles = [0, 0, 1, 10, 0, 2]) {
    const session = pageSession({ size: { width: 200, height: 100 } })
    const { editing } = session
    await editing.open(sceneOf(Float64Array.from(circles)))
    const motion = new Motion(session.store, editing, session.view, session.actions)
    const changes: boolean[] = []
    motion.onchange(() => changes.push(motion.isMoving))
    const radii = () => [...editing.circles.circles()].filter((_, k) => k % 3 === 2)
    return { ...session, motion, changes, radii }
  }

  it('edits circles in each frame, tells its begin and its end, and is one step of undo', async () => {
    const { motion, changes, radii, actions, store, circles } = await started()
    actions.selection.select([0])
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
    await actions.circles.undo()
    expect(circles()).toEqual([0, 0, 1, 10, 0, 2])
    await actions.circles.undo()
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

  it.each<[string, (session: Awaited<ReturnType<typeof started>>) => Promise<unknown>, number[]]>([
    ['other circles are opened', ({ editing }) => editing.open(sceneOf(Float64Array.of(0, 0, 3))), [3]],
    [
      'a circle is edited',
      ({ editing }) => editing.edit([{ kind: 'replace', id: 0, circle: [0, 0, 7] }]),
      [7, expect.any(Number)],
    ],
    ['it is undone, and everything is as before', ({ actions }) => actions.circles.undo(), [1, 2]],
  ])('ends where %s', async (_, act, expected) => {
    const session = await started()
    const { motion, radii } = session
    motion.start('grow')
    for (let now = 0; now < 200; now += 50) await show(now)
    // A frame comes before the edit is done.
    const acted = act(session)
    await show(250)
    await acted
    for (let now = 300; now < 500; now += 50) await show(now)
    expect([motion.isMoving, radii()]).toEqual([false, expected])
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

describe('a video', () => {
  it('that the browser does not record ends its stream', async () => {
    recorder([])
    await expect(filmed(stream, 3)).rejects.toThrow()
    expect(stopped).toEqual(['track 1', 'track 2'])
  })

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
})
