// SPDX-License-Identifier: GPL-3.0-or-later

import { dataSetName, type State } from '../../editing/state.ts'
import { disable } from '../../view/disable.ts'
import type { Store } from '../../view/store.ts'
import { DATA_SETS, dataSetOf, labelOf, sourceOf } from '../data-sets.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'

/** The menu entry that opens all families and figures. */
const MORE = 'more'
/** The menu entry for circles from other sources. */
const OWN = ''

/** The menu of circles, and the tools of the rail. `showMore` opens all families and figures. */
export function mountToolbar(store: Store<State>, actions: PageActions, showMore: () => void): void {
  const figure = byId('figure', HTMLElement)
  const dataSet = byId('data-set', HTMLSelectElement)
  const again = byId('again', HTMLButtonElement)
  const undo = byId('undo', HTMLButtonElement)
  const redo = byId('redo', HTMLButtonElement)

  // Edited circles have an entry of their own, so that choosing the data set restores it.
  const own = new Option('Your circles', OWN)
  own.hidden = true
  const more = new Option('More …', MORE)
  dataSet.append(own, ...DATA_SETS.map(({ id, label }) => new Option(label, id)), more)
  const showChosen = (state: State) => {
    const { history, edited } = state
    const name = dataSetName(state)
    const isEdited = history.done.at(-1)?.kind === 'edits'
    const label = labelOf(name)
    own.textContent = edited?.counts.circles === 0 ? 'No circles' : nameOf(label, isEdited)
    dataSet.value = isEdited ? OWN : (dataSetOf(name)?.id ?? OWN)
  }
  dataSet.addEventListener('change', () => {
    if (dataSet.value !== MORE) {
      actions.data.load(dataSet.value)
      return
    }
    showChosen(store.get())
    showMore()
  })
  again.addEventListener('click', () => actions.data.generateAgain())
  const tools = [
    ['select', byId('select', HTMLButtonElement)],
    ['pan', byId('pan', HTMLButtonElement)],
    ['add', byId('add', HTMLButtonElement)],
  ] as const
  for (const [tool, button] of tools) {
    button.addEventListener('click', () =>
      tool === 'add' ? actions.tools.toggleAdding() : actions.tools.useTool(tool),
    )
  }
  undo.addEventListener('click', () => actions.circles.undo())
  redo.addEventListener('click', () => actions.circles.redo())
  mountMore()

  store.subscribe((state) => {
    showChosen(state)
    again.hidden = sourceOf(dataSetName(state))?.kind !== 'family'
    for (const [tool, button] of tools) button.setAttribute('aria-pressed', String(state.tool === tool))
    disable(undo, state.history.done.length === 0, figure)
    disable(redo, state.history.undone.length === 0, figure)
  })
}

function nameOf(label: string, isEdited: boolean): string {
  if (label === '') return 'Your circles'
  return isEdited ? `${label}, edited` : label
}

/** The second row of tools on phones. */
function mountMore(): void {
  const rail = byId('rail', HTMLElement)
  const more = byId('more', HTMLButtonElement)
  more.addEventListener('click', () => {
    const isOpen = rail.classList.toggle('open')
    more.setAttribute('aria-expanded', String(isOpen))
  })
}
