// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { namedAs } from '../../web/editing/attributes.ts'
import { EMPTY_HISTORY, type History, limited, record } from '../../web/editing/history.ts'
import { PackedSteps } from '../../web/editing/packed-steps.ts'
import type { Edit } from '../../web/lib/index.ts'
import { NO_DOMAIN } from '../../web/view/domain.ts'

/** Converts entries to plain objects. */
const plain = (entries: History['done']) =>
  entries.map((entry) => (entry.kind === 'edits' ? { ...entry, steps: entry.steps.unpacked() } : entry))
const back = (id: number, x: number): Edit => ({ kind: 'replace', id, circle: { x, y: 0, r: 1 } })

describe('what goes back to before edits', () => {
  it('of one gesture is where each circle was at first, the newest before what is older', () => {
    const begun = record(EMPTY_HISTORY, [back(0, 1)], 7)
    const gone: Edit = { kind: 'insert', circle: { x: 0, y: 0, r: 1 }, id: 0 }
    const { done } = record(record(begun, [back(0, 2), back(1, 5)], 7), [gone], 7)
    expect(plain(done)).toEqual([{ kind: 'edits', gesture: 7, steps: [gone, back(1, 5), back(0, 1)] }])
  })

  it('of one gesture is the region, the areas and the attributes that were there at first', () => {
    const [names, others] = [namedAs(['a']), namedAs(['b'])]
    const [first, second] = [
      { ...NO_DOMAIN, areas: [1, 2] },
      { ...NO_DOMAIN, areas: [3, 4] },
    ] as const
    const begun = record(EMPTY_HISTORY, [back(0, 1)], 5)
    const { done } = record(record(begun, [], 5, { domain: first, attributes: names }), [], 5, {
      domain: second,
      attributes: others,
    })
    const [entry] = plain(done)
    expect(entry).toEqual({ kind: 'edits', gesture: 5, steps: [back(0, 1)], domain: first, attributes: names })
  })

  it('of another gesture is another entry, and nothing can be done again', () => {
    const undone = { done: [], undone: record(EMPTY_HISTORY, [back(0, 1)], 1).done }
    const { done, undone: left } = record(record(undone, [back(0, 1)], 1), [back(0, 2)], 2)
    expect(done.map((entry) => 'gesture' in entry && entry.gesture)).toEqual([1, 2])
    expect(left).toEqual([])
  })
})

describe('a history', () => {
  const entry = (gesture: number, count = 1) => ({
    kind: 'edits' as const,
    gesture,
    steps: PackedSteps.of(Array.from({ length: count }, (_, id) => back(id, gesture))),
  })
  const gestures = ({ done, undone }: History) =>
    [done, undone].map((side) => side.map((entry) => ('gesture' in entry ? entry.gesture : entry.kind)))

  it('takes 29 bytes for a moved circle', () => {
    const { steps } = entry(1, 100_000)
    expect([steps.bytes, steps.length]).toEqual([2_900_000, 100_000])
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
