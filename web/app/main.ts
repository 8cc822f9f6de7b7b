// SPDX-License-Identifier: GPL-3.0-or-later

import { loadedOnce } from '../lib/base/loaded-once.ts'
import { Figure } from '../player/figure.ts'
import { arrangeAround } from './arrange.ts'
import { askAhead, DATA_SETS, type DataSet } from './data-sets.ts'
import { FilesClient } from './files/files-client.ts'
import { listenToClipboard } from './input/clipboard.ts'
import { listenToFiles } from './input/dropping.ts'
import { restoreInvalidNumbers } from './input/invalid-numbers.ts'
import { listenToMenu } from './input/menu-key.ts'
import { markTabbing } from './input/tabbing.ts'
import { LinkWriter } from './link-writer.ts'
import { NOT_LOADED } from './not-loaded.ts'
import { workOffline } from './offline.ts'
import { paddingOfPage } from './padding.ts'
import { pageActions } from './page-actions.ts'
import { byId } from './panels/by-id.ts'
import { mountLegend } from './panels/legend.ts'
import { mountMethod } from './panels/method.ts'
import { mountNames } from './panels/names.ts'
import { mountOneLine } from './panels/one-line.ts'
import { panelLater } from './panels/panel.ts'
import { mountProgress } from './panels/progress.ts'
import { mountSay } from './panels/say.ts'
import { mountScale } from './panels/scale.ts'
import { mountStatus } from './panels/status.ts'
import { mountToolbar } from './panels/toolbar.ts'
import { mountTrial } from './panels/trial.ts'
import { mountViewControls } from './panels/view-controls.ts'
import { RegionPen } from './region-pen.ts'
import { StatePersistence } from './state-persistence.ts'
import { styleSheetsLoaded } from './style-sheets.ts'

// input ──► actions ──► editing ──► view ──► painter's thread
//              │           │                       │
//              ▼           ▼      confirmed        │
//            store ◄───────┴───────────────────────┘
//              │
//              └──► panels, and highlights in the view

const firstPicture = document.getElementById('first-picture')
if (location.hash === '') askAhead((DATA_SETS[0] as DataSet).id)
else firstPicture?.remove()
await styleSheetsLoaded()

const files = new FilesClient()
const reader = new FilesClient()
let hasShown = false
let steps = 0
export const figure = new Figure(
  {
    figure: byId('figure', HTMLElement),
    around: document,
    player: byId('played', HTMLElement),
    said: byId('said', HTMLParagraphElement),
  },
  {
    actions: (figure) => pageActions(figure, paddingOfPage, reader),
    keys: {
      editNumbers: async () => (await cards().catch(() => complain(NOT_LOADED)))?.(),
      showHelp: () => showHelp(),
      drawRegion: () => actions.tools.useTool('draw'),
    },
    played: (kept) => played(kept),
    onstep: (_, all) => {
      steps = all
    },
    onoutcome: (outcome) => {
      actions.coloring.follow(outcome)
      // The initial data set is not saved.
      if (hasShown) persistence.changed()
      hasShown = true
    },
  },
)
const { view, store, editing, actions } = figure
const complain = (problem: string) => actions.messages.complain(problem)

const links = new LinkWriter(files)
const persistence = new StatePersistence(links, () => actions.opening.linkState())
view.on('layers', () => persistence.changed())

const openFile = async (file: File) => {
  const opening = await fileActions().catch(() => complain(NOT_LOADED))
  await opening?.openFile(file)
}
const gallery = loadedOnce(async () => {
  const { mountGenerate } = await import('./panels/generate.ts')
  return mountGenerate(store, actions, files, openFile)
})
panelLater('generate', complain, gallery)
mountToolbar(store, actions, async () => (await gallery().catch(() => complain(NOT_LOADED)))?.())
mountTrial(view, actions.messages)
mountViewControls(actions)
mountStatus(store, view)
mountProgress(actions)
mountLegend(store, view)
const fileActions = loadedOnce(async () => {
  const { FileActions } = await import('./files/file-actions.ts')
  return new FileActions(store, editing, actions, view, { files, reader, links })
})
const photoBar = loadedOnce(async () => {
  const { mountPhoto } = await import('./panels/photo.ts')
  mountPhoto(store, actions, await fileActions(), await motion())
})
store.subscribe(({ attributes }) => {
  if (actions.coloring.photos.has(attributes)) photoBar().catch(() => complain(NOT_LOADED))
})
const degreesNotice = loadedOnce(async () => {
  const { mountDegrees } = await import('./panels/degrees.ts')
  mountDegrees(store, editing, actions, files)
})
store.subscribe(({ scene }) => {
  if (scene?.degrees !== undefined) degreesNotice().catch(() => complain(NOT_LOADED))
})
mountSay(store, openFile)
const motion = loadedOnce(async () => {
  const { stoppableMotion } = await import('./motion/stop.ts')
  return stoppableMotion(store, editing, view, actions)
})
const pen = new RegionPen(store, actions, view)
actions.tools.pen = pen
// Handles copied circles before the listener for files sees them.
listenToClipboard(actions)
listenToFiles(fileActions, complain)
restoreInvalidNumbers(document)
markTabbing()
const cards = loadedOnce(async () => {
  const { mountSelectionCards } = await import('./panels/selection-cards.ts')
  return mountSelectionCards(store, editing, actions)
})
let selected: readonly number[] = []
store.subscribe(({ selection }) => {
  if (selection === selected) return
  selected = selection
  if (selection.length > 0) cards().catch(() => complain(NOT_LOADED))
})
const showHelp = () =>
  import('./panels/help.ts').then(
    ({ showHelp }) => showHelp(),
    () => complain(NOT_LOADED),
  )
byId('show-help', HTMLButtonElement).addEventListener('click', showHelp)
mountOneLine()
const menu = loadedOnce(async () => {
  const { contextMenu } = await import('./panels/context-menu.ts')
  return contextMenu(store, actions, view, () => byId('field-name', HTMLInputElement).focus())
})
listenToMenu(
  byId('figure', HTMLElement),
  view,
  () => view.selected,
  async (at) => (await menu().catch(() => complain(NOT_LOADED)))?.(at),
)
const played = mountMethod(store)
mountScale(view)
mountNames(store, actions)
panelLater('table', complain, async () => (await import('./panels/table.ts')).mountTable(store, editing, actions, view))
panelLater('files', complain, async () => (await import('./panels/files.ts')).mountFiles(await fileActions()))
panelLater('share', complain, async () => {
  const { mountShare } = await import('./panels/share.ts')
  mountShare(await fileActions(), store, editing, view, actions, await motion(), () => steps)
})
panelLater('layers', complain, async () => {
  const [{ mountLayers }, { Radii }] = await Promise.all([import('./panels/layers.ts'), import('./motion/radii.ts')])
  mountLayers(store, actions, view, await motion(), new Radii(store, editing))
})
panelLater('numbers', complain, async () => (await import('./panels/numbers.ts')).mountNumbers(store, view))
panelLater('motion', complain, async () => {
  const { mountMotion } = await import('./panels/motion.ts')
  mountMotion(await motion(), view, actions)
})
panelLater('region', complain, async () => {
  const { mountRegion } = await import('./panels/region.ts')
  mountRegion(store, actions, await fileActions(), pen)
})

const kept = await persistence.begin()
// The user may have opened something else by now.
const open = () => (kept === undefined ? 'refused' : actions.data.openLink(kept))
const begun = actions.opening.hasOpened ? 'superseded' : await open()
if (begun === 'refused') {
  const { problem } = store.get()
  // The user may have opened something else by now, which must not be replaced.
  const [how, drift] = await Promise.all([
    actions.data.load((DATA_SETS[0] as DataSet).id),
    // The circles stay where they are if this fails.
    import('./motion/drift.ts').catch(() => undefined),
  ])
  if (how === 'opened') {
    // The problem of the link that these circles replace.
    actions.messages.complain(problem)
    // Panels show the numbers of a selected circle, which has moved.
    drift?.driftAtStart(view, byId('figure', HTMLElement), () => store.update((state) => ({ ...state })))
  }
  figure.whenPainted().then(() => firstPicture?.remove())
} else {
  firstPicture?.remove()
  if (begun === 'superseded') {
    hasShown = true
    persistence.changed()
  }
}
arrangeAround(store, view, actions)
import('./panels/tooltips.ts').then(
  ({ mountTooltips }) => mountTooltips(),
  // Browsers have tooltips of their own.
  () => {},
)
import('./printing.ts').then(
  ({ printDrawing }) => printDrawing(view, byId('paper', HTMLElement)),
  // The screen is printed.
  () => {},
)
store.watch((state, before) => {
  if (state.camera !== before.camera || state.step !== before.step) persistence.changed()
})
let addresses = 0
const openAddress = async () => {
  addresses += 1
  const turn = addresses
  const { hash } = location
  const how = hash === '' ? 'opened' : await actions.data.openLink(hash)
  // The same address may have been requested again.
  if (turn === addresses) persistence.wasOpened(hash, how === 'opened')
}
window.addEventListener('hashchange', openAddress)
// The address may have changed during loading.
if (persistence.isAddressNew) await openAddress()
await workOffline()
