// SPDX-License-Identifier: GPL-3.0-or-later
import type { Padding } from '../view/camera.ts'
import { mount } from '../view/mount.ts'
import { listenToPointer } from '../view/pointer.ts'
import { Actions } from './actions.ts'
import { DATA_SETS, type DataSet } from './data-sets.ts'
import { Editing } from './editing.ts'
import { FileActions } from './files/file-actions.ts'
import { listenToClipboard } from './input/clipboard.ts'
import { listenToFiles } from './input/dropping.ts'
import { listenToKeyboard } from './input/keyboard.ts'
import { Keeping } from './keeping.ts'
import { byId } from './panels/by-id.ts'
import { mountFiles } from './panels/files.ts'
import { mountGroup } from './panels/group.ts'
import { mountHelp } from './panels/help.ts'
import { mountInspector } from './panels/inspector.ts'
import { mountLayers } from './panels/layers.ts'
import { mountNumbers } from './panels/numbers.ts'
import { mountSaid } from './panels/said.ts'
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
      const selection = state.selection.filter((id) => editing.circles.get(id) !== undefined)
      const selected = selection.length === 1 ? selection[0] : undefined
      const circle = selected === undefined ? undefined : editing.circles.get(selected)
      const dataSet = editing.scene?.dataSet ?? ''
      return { ...state, dataSet, edited, history, selection, selected, circle, problem: '' }
    })
    // With the picture of the same edit.
    if (store.get().selection.length > 0) choose()
  },
  (problem) => store.update((state) => ({ ...state, problem })),
)

/** What the panels at the top and at the bottom cover, and a margin. */
const padding = (): Padding => ({ top: 72, right: 32, bottom: 64, left: 32 })
const actions = new Actions(store, editing, view, padding)

const keeping = new Keeping(() => actions.linkState())

let chosen = store.get().selection
const choose = () => {
  chosen = store.get().selection
  view.choose(chosen.flatMap((id) => editing.circles.get(id) ?? []))
}
let marked: readonly [number | undefined, number | undefined] = [undefined, undefined]
store.subscribe(({ selection, selected, hovered }) => {
  if (selection !== chosen) choose()
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
const fileActions = new FileActions(store, editing, actions, view)
mountFiles(fileActions)
// What is copied here is no file: this hears of it first.
listenToClipboard(actions)
listenToFiles(fileActions)
const editNumbers = mountInspector(store, actions)
const showHelp = mountHelp()
mountGroup(store, actions)
mountSaid(store)
mountLayers(store, actions, view)
mountNumbers(store, view)
mountScale(view)
const pointer = listenToPointer(figure, view, actions)
listenToKeyboard(figure, view, pointer, store, actions, { editNumbers, showHelp })

const kept = await keeping.begin()
if (kept === undefined || !(await actions.openLink(kept))) await actions.load((DATA_SETS[0] as DataSet).id)
view.on('camera', () => keeping.changed())
window.addEventListener('hashchange', () => location.hash !== '' && actions.openLink(location.hash))
