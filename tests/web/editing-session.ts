// SPDX-License-Identifier: GPL-3.0-or-later
export { aTurn, eventually } from './turns.ts'

import { pageActions } from '../../web/app/page-actions.ts'
import { Editing } from '../../web/editing/editing.ts'
import { figureActions } from '../../web/editing/figure-actions.ts'
import { initialState } from '../../web/editing/state.ts'
import type { Edit } from '../../web/lib/index.ts'
import { type Camera, NO_PADDING, type Padding, type Size } from '../../web/view/camera.ts'
import { DEFAULT_LAYERS } from '../../web/view/layers.ts'
import { createStore } from '../../web/view/store.ts'
import type { View } from '../../web/view/view.ts'
import { LibraryBackend } from './library-backend.ts'

/** A scene to open that has no edits. */
export function sceneOf(circles: Float64Array, dataSet = '') {
  return { circles: circles as Float64Array<ArrayBuffer>, dataSet, isEdited: false }
}

/** Edits circles in a view without a picture. Each request of the backend waits for `before`. */
export function editingSession({
  before = async () => {},
  size = { width: 100, height: 100 },
  padding = NO_PADDING,
  onproblem = () => {},
}: {
  readonly before?: () => Promise<unknown>
  readonly size?: Size
  readonly padding?: Padding
  readonly onproblem?: (error: Error) => void
} = {}) {
  const computer = new LibraryBackend(before)
  const store = createStore(initialState())
  const problems: string[] = []
  const editing = new Editing(
    store,
    computer,
    () => {},
    (error) => {
      const { message: problem } = error
      problems.push(problem)
      store.update((state) => ({ ...state, problem }))
      onproblem(error)
    },
  )
  const fake = {
    camera: { x: 0, y: 0, scale: 1 } as Camera,
    size,
    layers: DEFAULT_LAYERS,
    get circles() {
      return editing.circles
    },
    setCamera(camera: Camera) {
      fake.camera = camera
    },
    setLayers(layers: object) {
      fake.layers = { ...fake.layers, ...layers }
    },
    scene: { edit: (edits: readonly Edit[]) => computer.edit(edits), ask: async (): Promise<unknown> => undefined },
  }
  const view = fake as unknown as View
  const actions = figureActions({ store, editing, view }, () => padding)
  return { computer, store, problems, editing, fake, view, actions, circles: () => [...editing.circles.circles()] }
}

/** Throws a problem that no test expects. */
export function fail(error: Error): never {
  throw error
}

/** An editing session with the actions of the page. There are no files to read. */
export function pageSession(options?: Parameters<typeof editingSession>[0]) {
  const session = editingSession(options)
  const reader = { call: () => Promise.reject(new Error('There are no files.')), cancel() {} }
  return { ...session, actions: pageActions(session, () => NO_PADDING, reader) }
}
