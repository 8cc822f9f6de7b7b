// SPDX-License-Identifier: GPL-3.0-or-later
import type { View } from '../view/view.ts'
import { Editing, type Outcome } from './editing.ts'
import { INITIAL_STATE, type State, stateAfter, withSelection } from './state.ts'
import { createStore, type Store } from './store.ts'

/** The circles of a view with their history, and what is known of them. */
export interface EditedView {
  readonly store: Store<State>
  readonly editing: Editing
}

/** Edits the circles of a view: the store has what is known of them, and what it says stands out is what stands out in the view. */
export function editView(
  view: View,
  onOutcome: (outcome: Outcome) => void,
  onProblem: (error: Error) => void,
): EditedView {
  const store = createStore<State>(INITIAL_STATE)
  const editing = new Editing(
    view,
    (outcome) => {
      const dataSet = editing.scene?.dataSet ?? ''
      store.update((state) => ({ ...stateAfter(state, outcome, editing.circles), dataSet }))
      // With the picture of the same edit.
      if (store.get().selection.length > 0) choose()
      onOutcome(outcome)
    },
    onProblem,
  )
  const choose = () => {
    const circles = store.get().selection.flatMap((id) => editing.circles.get(id) ?? [])
    // Where areas are given, radii are weights.
    view.choose(editing.domain.areas === undefined ? circles : circles.map(({ x, y }) => ({ x, y, r: 0 })))
  }
  let before = store.get()
  store.subscribe((state) => {
    if (state.selection !== before.selection) choose()
    if (state.selected !== before.selected || state.hovered !== before.hovered) view.mark(state.selected, state.hovered)
    before = state
  })
  view.on('marked', ({ selected }) => store.update((state) => ({ ...state, described: selected })))
  view.on('failed', ({ error, marks }) => {
    // What stood out may have been the cause.
    if (marks) store.update((state) => ({ ...withSelection(state, [], editing.circles), hovered: undefined }))
    onProblem(error)
  })
  view.on('found', (found) => store.update((state) => ({ ...state, found })))
  view.on('layers', (layers) => store.update((state) => ({ ...state, layers })))
  return { store, editing }
}
