// SPDX-License-Identifier: GPL-3.0-or-later
import type { FigureLoadOptions } from '../view/load.ts'
import { mount } from '../view/mount.ts'
import { createStore, type Store } from '../view/store.ts'
import type { View } from '../view/view.ts'
import { Editing, type Outcome } from './editing.ts'
import { namesOf, ownColorsOf } from './identity.ts'
import { INITIAL_STATE, type State } from './state.ts'

/** A view whose circles can be edited, and the state that it shows. */
export interface EditedView {
  readonly view: View
  readonly store: Store<State>
  readonly editing: Editing
}

/** Shows circles that can be edited in an element of a page. */
export function mountEdited(
  container: HTMLElement,
  load: FigureLoadOptions | undefined,
  onOutcome: (outcome: Outcome) => void,
  onProblem: (error: Error) => void,
): EditedView {
  const store = createStore(INITIAL_STATE)
  const view = mount(container, load, store)
  let named = store.get().attributes
  const identify = ({ edited, isOpened }: Outcome) => {
    const { attributes } = store.get()
    const isOther = isOpened || attributes !== named || edited.inserted.length > 0
    named = attributes
    if (isOther) view.setIdentities(namesOf(editing), ownColorsOf(editing))
  }
  const editing = new Editing(
    store,
    view,
    (outcome) => {
      identify(outcome)
      onOutcome(outcome)
    },
    onProblem,
  )
  view.on('failed', onProblem)
  return { view, store, editing }
}
