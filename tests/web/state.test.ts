// SPDX-License-Identifier: GPL-3.0-or-later
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { appendCircle, applyEdit, removeCircle, replaceAll, replaceCircle, reverse } from '../../web/app/edits.ts'
import { EMPTY_HISTORY, record } from '../../web/app/history.ts'
import { edited, INITIAL_STATE, loaded, NOBODY, redone, refused, type State, undone } from '../../web/app/state.ts'

const TWO = Float64Array.of(0, 0, 1, 5, 5, 2)
const state: State = loaded(INITIAL_STATE, 'two', TWO)

const number = fc.double({ noNaN: true })
const circles = fc
  .array(number, { maxLength: 12 })
  .map((values) => Float64Array.from(values.slice(0, 3 * Math.floor(values.length / 3))))

describe('edits', () => {
  it('are undone by their reverse', () => {
    fc.assert(
      fc.property(circles, circles, number, (before, others, x) => {
        const edits = [
          appendCircle(before, x, 1, 2),
          replaceAll(before, others),
          ...(before.length > 0
            ? [removeCircle(before, 0), replaceCircle(before, before.length / 3 - 1, x, 1, 2)]
            : []),
        ]
        for (const edit of edits) expect(applyEdit(applyEdit(before, edit), reverse(edit))).toEqual(before)
      }),
    )
  })

  it('leave the circles they start from as they are', () => {
    applyEdit(TWO, replaceCircle(TWO, 0, 9, 9, 9))
    expect([...TWO]).toEqual([0, 0, 1, 5, 5, 2])
  })
})

describe('history', () => {
  it('makes one step of the edits of one gesture', () => {
    const dragged = [1, 2, 3].reduce((s, x) => edited(s, replaceCircle(s.circles, 0, x, 0, 1), 1), state)
    expect(dragged.history.done).toHaveLength(1)
    expect(undone(dragged).circles).toEqual(TWO)
    expect(redone(undone(dragged)).circles).toEqual(dragged.circles)
  })

  it('keeps the steps of two gestures apart', () => {
    const once = edited(state, replaceCircle(state.circles, 0, 1, 0, 1), 1)
    const twice = edited(once, replaceCircle(once.circles, 0, 2, 0, 1), 2)
    expect(undone(twice).circles).toEqual(once.circles)
  })

  it('makes one step of adding a circle and dragging its rim', () => {
    const added = edited(state, appendCircle(state.circles, 9, 9, 0), 1)
    const sized = edited(added, replaceCircle(added.circles, 2, 9, 9, 3), 1)
    expect(sized.history.done).toHaveLength(1)
    expect(undone(sized).circles).toEqual(TWO)
  })

  it('forgets what was undone at the next edit', () => {
    const back = undone(edited(state, removeCircle(state.circles, 1), 1))
    expect(edited(back, removeCircle(back.circles, 0), 2).history.undone).toEqual([])
  })

  it('has an end', () => {
    let history = EMPTY_HISTORY
    for (let gesture = 0; gesture < 600; gesture++) history = record(history, removeCircle(TWO, 0), gesture)
    expect(history.done).toHaveLength(500)
  })
})

describe('state', () => {
  it('does nothing where there is nothing to undo or to do again', () => {
    expect(undone(state)).toBe(state)
    expect(redone(state)).toBe(state)
  })

  it('selects the circle that an edit is about, and none after a deletion', () => {
    const moved = edited(state, replaceCircle(state.circles, 1, 0, 0, 1), 1)
    expect(moved.selected).toBe(1)
    expect(edited(moved, removeCircle(moved.circles, 1), 2).selected).toBe(NOBODY)
  })

  it('goes back to the last good circles when the core refuses an edit, for good', () => {
    const bad = edited(state, replaceCircle(state.circles, 0, 0, 0, -1), 1)
    const good = refused(bad, 'The radius of circle 0 is negative.')
    expect(good.circles).toEqual(TWO)
    expect(good.problem).toBe('The radius of circle 0 is negative.')
    expect(redone(good)).toBe(good)
  })

  it('drops the problem with the next edit', () => {
    const bad = refused(edited(state, replaceCircle(state.circles, 0, 0, 0, -1), 1), 'No.')
    expect(edited(bad, removeCircle(bad.circles, 0), 2).problem).toBe('')
  })
})
