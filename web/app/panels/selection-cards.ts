// SPDX-License-Identifier: GPL-3.0-or-later
import type { Editing } from '../../editing/editing.ts'
import type { State } from '../../editing/state.ts'
import type { Store } from '../../view/store.ts'
import type { PageActions } from '../page-actions.ts'
import { mountGroup } from './group.ts'
import { mountIdentity } from './identity.ts'
import { mountInspector } from './inspector.ts'
import { mountInspectorFacts } from './inspector-facts.ts'
import { mountInspectorShare } from './inspector-share.ts'

/**
 * The cards of the selection: one of a single circle, one of several circles. Returns a function that moves the focus
 * to the numbers of the selected circle.
 */
export function mountSelectionCards(store: Store<State>, editing: Editing, actions: PageActions): () => void {
  const editNumbers = mountInspector(store, actions)
  mountIdentity(store, actions)
  mountInspectorFacts(store, editing, actions)
  mountInspectorShare(store, actions)
  mountGroup(store, actions)
  return editNumbers
}
