// SPDX-License-Identifier: GPL-3.0-or-later
import type { Actions } from '../actions.ts'
import { DATA_SETS, dataSetOf } from '../data-sets.ts'
import type { State } from '../state.ts'
import type { Store } from '../store.ts'
import { byId } from './by-id.ts'

/** The choice of circles, adding and deleting, undo and redo. */
export function mountToolbar(store: Store<State>, actions: Actions): void {
  const figure = byId('figure', HTMLElement)
  const dataSet = byId('data-set', HTMLSelectElement)
  const again = byId('again', HTMLButtonElement)
  const remove = byId('remove', HTMLButtonElement)
  const undo = byId('undo', HTMLButtonElement)
  const redo = byId('redo', HTMLButtonElement)

  const own = new Option('Your circles', '')
  own.hidden = true
  dataSet.append(own, ...DATA_SETS.map(({ id, label }) => new Option(label, id)))
  dataSet.addEventListener('change', () => actions.load(dataSet.value))
  again.addEventListener('click', () => actions.load(dataSet.value))
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
    const chosen = dataSetOf(state.dataSet)
    dataSet.value = chosen?.id ?? ''
    again.hidden = chosen?.count === undefined
    for (const [tool, button] of tools) button.setAttribute('aria-pressed', String(state.tool === tool))
    disable(remove, state.selection.length === 0)
    disable(undo, state.history.done.length === 0)
    disable(redo, state.history.undone.length === 0)
  })
}
