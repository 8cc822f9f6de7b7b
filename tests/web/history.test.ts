// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { namedAs } from '../../web/editing/attributes.ts'
import { EMPTY_HISTORY, type History, limited, record } from '../../web/editing/history.ts'
import { PackedSteps } from '../../web/editing/packed-steps.ts'
import type { Edit } from '../../web/lib/index.ts'

const back = (id: number, x: number): Edit => ({ kind: 'replace', id, circle: { x, y: 0, r: 1 } })

describe('a history', () => {
  const entry = (gesture: number, count = 1) => ({
    kind: 'edits' as const,
    gesture,
    steps: PackedSteps.of(Array.from({ length: count }, (_, id) => back(id, gesture))),
  })
  const gestures = ({ done, undone }: History) =>
    [done, undone].map((side) => side.map((entry) => ('gesture' in entry ? entry.gesture : entry.kind)))

  it('takes 29 bytes for a moved circle, however often a gesture moves it', () => {
    const { steps } = entry(1, 100_000)
    expect([steps.bytes, steps.length]).toEqual([2_900_000, 100_000])
    let history = EMPTY_HISTORY
    for (const x of [1, 2, 3]) history = record(history, [back(0, x)], 7)
    const [only] = history.done
    expect(only?.kind === 'edits' && only.steps.bytes).toBe(29)
  })

  it('forgets what is farthest from now where it takes too many bytes, and never the last step', () => {
    const many = { done: [1, 2, 3, 4].map((k) => entry(k, 100)), undone: [8, 7, 6].map((k) => entry(k, 100)) }
    expect(gestures(limited(many, 1e6))).toEqual([
      [1, 2, 3, 4],
      [8, 7, 6],
    ])
    expect(limited(many, 1e6).done).toBe(many.done)
    expect(gestures(limited(many, 5 * 3100))).toEqual([
      [3, 4],
      [8, 7, 6],
    ])
    expect(gestures(limited(many, 3 * 3100))).toEqual([[4], [7, 6]])
    expect(gestures(limited(many, 0))).toEqual([[4], [6]])
  })

  it('counts the circles and the attributes of what was opened', () => {
    const kept = { ids: new Int32Array(1000), nextId: 1000 }
    const opening = (names?: string[]) => {
      const circles = new Float64Array(3000)
      return {
        kind: 'opening' as const,
        scene: { circles, kept, dataSet: '', isEdited: false, attributes: names && namedAs(names) },
      }
    }
    const two = { done: [opening(), opening()], undone: [] }
    expect(limited(two, 2 * 28_200).done).toHaveLength(2)
    expect(limited(two, 2 * 28_200 - 1).done).toHaveLength(1)
    const named = { done: [opening(), opening(Array(1000).fill('a name'))], undone: [] }
    expect(limited(named, 2 * 28_200).done).toHaveLength(1)
  })
})
