// SPDX-License-Identifier: GPL-3.0-or-later
import type { Padding } from '../view/camera.ts'
import type { Store } from '../view/store.ts'
import type { View } from '../view/view.ts'
import { CameraActions } from './camera-actions.ts'
import { CircleActions } from './circle-actions.ts'
import type { Editing } from './editing.ts'
import { Messages } from './messages.ts'
import { OpeningActions } from './opening-actions.ts'
import { SelectionActions } from './selection-actions.ts'
import type { State } from './state.ts'
import { Tools } from './tools.ts'

/**
 * The actions of a user on a figure, grouped by their subjects. Input handlers and panels call these actions; apart
 * from results of the thread, nothing else changes the state.
 */
export interface FigureActions {
  readonly camera: CameraActions
  readonly selection: SelectionActions
  readonly tools: Tools
  readonly messages: Messages
  readonly opening: OpeningActions
  readonly circles: CircleActions
}

/** The actions that other actions call. */
export type SharedActions = Pick<FigureActions, 'camera' | 'selection' | 'tools' | 'messages'>

/** A view whose circles can be edited, and the state that it shows. */
export interface FigureParts {
  readonly store: Store<State>
  readonly editing: Editing
  readonly view: View
}

/** `padding` is kept free when everything is shown. */
export function figureActions(figure: FigureParts, padding: () => Padding): FigureActions {
  const messages = new Messages(figure)
  const tools = new Tools(figure.store, messages)
  const camera = new CameraActions(figure, padding)
  const selection = new SelectionActions(figure, { camera, messages })
  const shared = { camera, selection, tools, messages }
  return {
    ...shared,
    opening: new OpeningActions(figure, shared),
    circles: new CircleActions(figure, shared),
  }
}

/** Ends the current tool; without one, clears the selection. */
export function release({ tools, selection }: FigureActions): void {
  if (tools.tool !== 'select') tools.useTool('select')
  else selection.select([])
}
