// SPDX-License-Identifier: GPL-3.0-or-later

import type { State } from '../../editing/state.ts'
import type { Store } from '../../editing/store.ts'
import { DATA_SETS, dataSetOf, labelOf, sourceOf } from '../data-sets.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'

/** What is chosen to see all families and figures. */
const MORE = 'more'

/** The choice of circles, adding and deleting, undo and redo. `showMore`: shows all families and figures. */
export function mountToolbar(store: Store<State>, actions: PageActions, showMore: () => void): void {
  const figure = byId('figure', HTMLElement)
  const dataSet = byId('data-set', HTMLSelectElement)
  const again = byId('again', HTMLButtonElement)
  const remove = byId('remove', HTMLButtonElement)
  const undo = byId('undo', HTMLButtonElement)
  const redo = byId('redo', HTMLButtonElement)

  const own = new Option('Your circles', '')
  own.hidden = true
  const more = new Option('Families, figures …', MORE)
  dataSet.append(own, ...DATA_SETS.map(({ id, label }) => new Option(label, id)), more)
  const showChosen = ({ dataSet: name }: State) => {
    own.textContent = labelOf(name) || 'Your circles'
    dataSet.value = dataSetOf(name)?.id ?? ''
  }
  dataSet.addEventListener('change', () => {
    if (dataSet.value !== MORE) {
      actions.load(dataSet.value)
      return
    }
    showChosen(store.get())
    showMore()
  })
  again.addEventListener('click', () => actions.generateAgain())
  const tools = [
    ['select', byId('select', HTMLButtonElement)],
    ['pan', byId('pan', HTMLButtonElement)],
    ['add', byId('add', HTMLButtonElement)],
  ] as const
  for (const [tool, button] of tools) {
    button.addEventListener('click', () => (tool === 'add' ? actions.toggleAdding() : actions.useTool(tool)))
  }
  remove.addEventListener('click', () => actions.removeSelected())
  undo.addEventListener('click', () => actions.undo())
  redo.addEventListener('click', () => actions.redo())

  /** The focus of a button that is disabled would fall to the body. */
  const disable = (button: HTMLButtonElement, isDisabled: boolean) => {
    if (isDisabled && button === document.activeElement) figure.focus()
    button.disabled = isDisabled
  }

  store.subscribe((state) => {
    showChosen(state)
    again.hidden = !['family', 'former'].includes(sourceOf(state.dataSet)?.kind ?? '')
    for (const [tool, button] of tools) button.setAttribute('aria-pressed', String(state.tool === tool))
    disable(remove, state.selection.length === 0)
    disable(undo, state.history.done.length === 0)
    disable(redo, state.history.undone.length === 0)
  })
}
