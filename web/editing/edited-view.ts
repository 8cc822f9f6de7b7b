// SPDX-License-Identifier: GPL-3.0-or-later
import type { View } from '../view/view.ts'
import type { Attributes } from './attributes.ts'
import { Editing, type Outcome } from './editing.ts'
import { namesOf, ownColorsOf } from './identity.ts'
import { INITIAL_STATE, type State, withSelection } from './state.ts'
import { createStore, type Store } from './store.ts'

/** The editable circles of a view, with their history and query results. */
export interface EditedView {
  readonly store: Store<State>
  readonly editing: Editing
}

/** Makes the circles of a view editable. The store receives query results; its highlights are shown in the view. */
export function editView(
  view: View,
  onOutcome: (outcome: Outcome) => void,
  onProblem: (error: Error) => void,
): EditedView {
  const store = createStore<State>(INITIAL_STATE)
  const editing = new Editing(
    store,
    view,
    (outcome) => {
      // Waits for the picture of the same edit, so that highlights and circles change together.
      if (store.get().selection.length > 0) choose()
      identify(outcome)
      onOutcome(outcome)
    },
    onProblem,
  )
  let known: Attributes | undefined
  const identify = ({ edited, isOpened }: Outcome) => {
    const { attributes } = store.get()
    const isOther = isOpened || attributes !== known || edited.inserted.length > 0
    known = attributes
    if (isOther) view.setIdentities(namesOf(editing), ownColorsOf(editing))
  }
  const choose = () => {
    const circles = store.get().selection.flatMap((id) => editing.circles.get(id) ?? [])
    // Radii are weights if areas are given.
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
    // The failed request may have been one for highlights.
    if (marks) store.update((state) => ({ ...withSelection(state, [], editing.circles), hovered: undefined }))
    onProblem(error)
  })
  view.on('found', (found) => store.update((state) => ({ ...state, found })))
  view.on('layers', (layers) => store.update((state) => ({ ...state, layers })))
  return { store, editing }
}
