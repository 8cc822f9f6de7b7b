// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { EMPTY_HISTORY, idsOnceOpened, record, renamed } from '../../web/editing/history.ts'
import type { Step } from '../../web/view/circle-table.ts'
import { NO_DOMAIN } from '../../web/view/domain.ts'

const CIRCLE = { x: 0, y: 0, r: 1 }
const back = (id: number, x: number): Step => ({ kind: 'replace', id, circle: { x, y: 0, r: 1 } })

describe('what goes back to before edits', () => {
  it('of one gesture is where each circle was at first, the newest before what is older', () => {
    const begun = record(EMPTY_HISTORY, [back(0, 1)], 7)
    const gone: Step = { kind: 'insert', circle: CIRCLE, formerId: 0 }
    const { done } = record(record(begun, [back(0, 2), back(1, 5)], 7), [gone], 7)
    expect(done).toEqual([{ kind: 'edits', gesture: 7, steps: [gone, back(1, 5), back(0, 1)] }])
  })

  it('takes away what the gesture has brought, wherever that was moved', () => {
    const brought = record(EMPTY_HISTORY, [{ kind: 'remove', id: 2 }], 3)
    expect(record(brought, [back(2, 4)], 3).done).toEqual([
      { kind: 'edits', gesture: 3, steps: [{ kind: 'remove', id: 2 }] },
    ])
  })

  it('goes back to a circle that the gesture removed and brought again under its id', () => {
    const removed = record(EMPTY_HISTORY, [{ kind: 'insert', circle: CIRCLE, formerId: 0 }], 3)
    expect(record(removed, [back(0, 4)], 3).done.at(-1)).toMatchObject({
      steps: [back(0, 4), { kind: 'insert', formerId: 0 }],
    })
  })

  it('takes away what came in the place of a circle that the gesture moved before', () => {
    const moved = record(EMPTY_HISTORY, [back(0, 1)], 3)
    const steps: Step[] = [
      { kind: 'remove', id: 0 },
      { kind: 'insert', circle: CIRCLE, formerId: 0 },
    ]
    expect(record(moved, steps, 3).done).toEqual([{ kind: 'edits', gesture: 3, steps: [...steps, back(0, 1)] }])
  })

  it('of one gesture is the region and the areas that were there at first', () => {
    const [first, second] = [
      { ...NO_DOMAIN, areas: [1, 2] },
      { ...NO_DOMAIN, areas: [3, 4] },
    ] as const
    const begun = record(EMPTY_HISTORY, [back(0, 1)], 5)
    const { done } = record(record(begun, [], 5, first), [], 5, second)
    expect(done).toEqual([{ kind: 'edits', gesture: 5, steps: [back(0, 1)], domain: first }])
  })

  it('of another gesture is another entry, and nothing can be done again', () => {
    const undone = { done: [], undone: record(EMPTY_HISTORY, [back(0, 1)], 1).done }
    const { done, undone: left } = record(record(undone, [back(0, 1)], 1), [back(0, 2)], 2)
    expect(done.map((entry) => 'gesture' in entry && entry.gesture)).toEqual([1, 2])
    expect(left).toEqual([])
  })
})

it('names what came back as it is called now, up to other circles', () => {
  const opening = {
    kind: 'opening',
    scene: { circles: new Float64Array(), dataSet: '', isEdited: false },
    ids: Int32Array.of(0),
  } as const
  const steps: Step[] = [
    { kind: 'remove', id: 1 },
    { kind: 'insert', circle: CIRCLE, formerId: 2 },
  ]
  const bare: Step = { kind: 'insert', circle: CIRCLE }
  const edits = { kind: 'edits', gesture: 1, steps: [...steps, bare] } as const
  expect(renamed({ done: [edits, opening, edits], undone: [edits] }, (id) => id + 10)).toEqual({
    done: [
      edits,
      opening,
      { ...edits, steps: [{ kind: 'remove', id: 11 }, { kind: 'insert', circle: CIRCLE, formerId: 12 }, bare] },
    ],
    undone: [{ ...edits, steps: [{ kind: 'remove', id: 11 }, { kind: 'insert', circle: CIRCLE, formerId: 12 }, bare] }],
  })
})

it('calls the circles that are opened by their places, and each other one by a name of its own', () => {
  let last = 0
  const idOf = idsOnceOpened(Int32Array.of(2, 5, 9), () => --last)
  expect([2, 5, 9, 0, 7, 10, 0].map(idOf)).toEqual([0, 1, 2, -1, -2, -3, -1])
})
