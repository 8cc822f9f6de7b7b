// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import type { FrameMessage } from '../../web/element/frame-types.ts'
import { durationOf, findApi, type ScormApi, ScormSession } from '../../web/embed/scorm.ts'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'

/** A learning management system that keeps values and records the calls. */
class System implements ScormApi {
  readonly values: Record<string, string>
  readonly calls: string[] = []
  constructor(values: Record<string, string> = { 'cmi.core.lesson_status': 'not attempted' }) {
    this.values = values
  }
  LMSInitialize = () => this.#called('initialize')
  LMSGetValue = (name: string) => this.values[name] ?? ''
  LMSSetValue = (name: string, value: string) => {
    this.values[name] = value
    return this.#called(`${name}=${value}`)
  }
  LMSCommit = () => this.#called('commit')
  LMSFinish = () => this.#called('finish')
  #called(call: string): string {
    this.calls.push(call)
    return 'true'
  }
}

const told = (met: boolean | undefined, circles = [[0, 0, 1]]): FrameMessage => ({
  type: 'circle-voronoi',
  height: 100,
  state: { circles, layers: {} },
  met,
  answer: '',
  error: undefined,
})

describe('a session of a course', () => {
  it('is incomplete until the check is met, then passed for good', async () => {
    const system = new System()
    const session = new ScormSession(system, true)
    expect(system.calls).toEqual(['initialize', 'cmi.core.lesson_status=incomplete', 'commit'])
    await session.tell(told(false))
    expect(system.values['cmi.core.lesson_status']).toBe('incomplete')
    await session.tell(told(true, [[5, 6, 2]]))
    expect(system.values).toMatchObject({ 'cmi.core.lesson_status': 'passed', 'cmi.core.score.raw': '100' })
    expect(system.calls.at(-1)).toBe('commit')
    await session.tell(told(false, [[7, 6, 2]]))
    const reports = () => system.calls.filter((call) => call === 'cmi.core.lesson_status=passed')
    expect([system.values['cmi.core.lesson_status'], reports().length]).toEqual(['passed', 1])
    await session.tell(told(true, [[7, 6, 2]]))
    expect(reports()).toHaveLength(1)
    session.finish()
    session.finish()
    expect(system.calls.slice(-2)).toEqual(['commit', 'finish'])
    expect(system.calls.filter((call) => call === 'finish')).toHaveLength(1)
    expect((await decodeLink(system.values['cmi.suspend_data'] as string)).circles).toEqual(Float64Array.of(7, 6, 2))
    expect(system.values['cmi.core.session_time']).toMatch(/^0000:00:0\d\.\d\d$/)
    expect(system.values['cmi.core.exit']).toBe('')
  })

  it('is completed where there is nothing to pass, and keeps no circles that are too many', async () => {
    const system = new System()
    const session = new ScormSession(system, false)
    expect(system.values['cmi.core.lesson_status']).toBe('completed')
    await session.tell(
      told(
        undefined,
        Array.from({ length: 2000 }, (_, k) => [Math.sin(k), Math.cos(k), 1e-3]),
      ),
    )
    session.finish()
    expect(system.values['cmi.suspend_data']).toBe('')
  })

  it('keeps the circles of the last session until they are shown, also if it ends before', async () => {
    const before = new System()
    const first = new ScormSession(before, true)
    await first.tell(told(false, [[1, 2, 3]]))
    first.finish()
    const kept = before.values['cmi.suspend_data']
    const left = new ScormSession(before, true)
    await left.tell(told(false, [[7, 7, 7]]))
    left.finish()
    expect(before.values['cmi.suspend_data']).toBe(kept)
    const again = new ScormSession(before, true)
    await again.tell(told(false, [[7, 7, 7]]))
    expect(again.suspended).toBe(kept)
    again.markRestored()
    await again.tell(told(false, [[4, 5, 6]]))
    again.finish()
    const { circles } = await decodeLink(before.values['cmi.suspend_data'] as string)
    expect(circles).toEqual(Float64Array.of(4, 5, 6))
  })

  it('keeps the last circles whose link is at most as long as a system allows', async () => {
    const system = new System()
    const session = new ScormSession(system, true)
    const kept: number[] = []
    for (let count = 100; count < 600; count += 50) {
      const circles = Array.from({ length: count }, (_, k) => [Math.sin(k), Math.cos(k), 1e-3])
      if ((await encodeLink({ circles })).length <= 4096) kept.push(count)
      await session.tell(told(false, circles))
    }
    session.finish()
    expect([kept.length > 0, kept.length < 10]).toEqual([true, true])
    const { circles } = await decodeLink(system.values['cmi.suspend_data'] as string)
    expect((circles?.length ?? 0) / 3).toBe(kept.at(-1))
  })

  it('finds the interface in windows around it and in the one that opened it', () => {
    const api = new System()
    const top = { opener: null } as unknown as Window & { parent: Window }
    Object.assign(top, { parent: top })
    expect(findApi(top)).toBeUndefined()
    const forbidden = {
      get API() {
        throw new Error('another origin')
      },
      opener: null,
      parent: Object.assign({ API: api, opener: null }),
    } as unknown as Window
    expect(findApi(forbidden)).toBe(api)
    expect(findApi(Object.assign({ ...top, opener: forbidden }, { parent: top }) as Window)).toBe(api)
  })

  it('tells times as hours, minutes and seconds', () => {
    expect(durationOf(0)).toBe('0000:00:00.00')
    expect(durationOf(3_723_450)).toBe('0001:02:03.45')
    expect(durationOf(59_999)).toBe('0000:01:00.00')
  })
})
