// SPDX-License-Identifier: GPL-3.0-or-later
import type { Padding } from '../view/camera.ts'
import { mount } from '../view/mount.ts'
import { listenToPointer } from '../view/pointer.ts'
import { Actions } from './actions.ts'
import { DATA_SETS, type DataSet } from './data-sets.ts'
import { Editing } from './editing.ts'
import { FileActions } from './files/file-actions.ts'
import { listenToFiles } from './input/dropping.ts'
import { listenToKeyboard } from './input/keyboard.ts'
import { Keeping } from './keeping.ts'
import { byId } from './panels/by-id.ts'
import { mountFiles } from './panels/files.ts'
import { mountInspector } from './panels/inspector.ts'
import { mountLayers } from './panels/layers.ts'
import { mountNumbers } from './panels/numbers.ts'
import { mountScale } from './panels/scale.ts'
import { mountStatus } from './panels/status.ts'
import { mountToolbar } from './panels/toolbar.ts'
import { mountViewControls } from './panels/view-controls.ts'
import { INITIAL_STATE, type State } from './state.ts'
import { createStore } from './store.ts'

// input ──► actions ──► editing ──► view ──► painter's thread
//              │           │                       │
//              ▼           ▼      confirmed        │
//            store ◄───────┴───────────────────────┘
//              │
//              └──► panels, and what stands out in the view

const figure = byId('figure', HTMLElement)
const view = mount(figure, { gestures: 'none' })
const store = createStore<State>(INITIAL_STATE)

const editing = new Editing(
  view,
  ({ edited, history }) => {
    // What is shown at first is there without being kept.
    if (store.get().edited !== undefined) keeping.changed()
    store.update((state) => {
      // What was selected may be gone.
      const selected = state.selected !== undefined && editing.circles.get(state.selected) ? state.selected : undefined
      const circle = selected === undefined ? undefined : editing.circles.get(selected)
      const dataSet = editing.scene?.dataSet ?? ''
      return { ...state, dataSet, edited, history, selected, circle, problem: '' }
    })
  },
  (problem) => store.update((state) => ({ ...state, problem })),
)

/** What the panels at the top and at the bottom cover, and a margin. */
const padding = (): Padding => ({ top: 72, right: 32, bottom: 64, left: 32 })
const actions = new Actions(store, editing, view, padding)

const keeping = new Keeping(() => actions.linkState())

let marked: readonly [number | undefined, number | undefined] = [undefined, undefined]
store.subscribe(({ selected, hovered }) => {
  if (selected !== marked[0] || hovered !== marked[1]) view.mark(selected, hovered)
  marked = [selected, hovered]
})
view.on('marked', ({ selected }) => store.update((state) => ({ ...state, described: selected })))
view.on('found', (found) => store.update((state) => ({ ...state, found })))
view.on('layers', (layers) => {
  store.update((state) => ({ ...state, layers }))
  keeping.changed()
})

mountToolbar(store, actions)
mountViewControls(actions)
mountStatus(store)
const fileActions = new FileActions(store, editing, actions)
mountFiles(fileActions)
listenToFiles(fileActions)
const editNumbers = mountInspector(store, actions)
mountLayers(store, actions, view)
mountNumbers(store, view)
mountScale(view)
const pointer = listenToPointer(figure, view, actions)
listenToKeyboard(figure, view, pointer, store, actions, editNumbers)

const kept = await keeping.begin()
if (kept === undefined || !(await actions.openLink(kept))) await actions.load((DATA_SETS[0] as DataSet).id)
view.on('camera', () => keeping.changed())
window.addEventListener('hashchange', () => location.hash !== '' && actions.openLink(location.hash))
