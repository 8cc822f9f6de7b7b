// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle } from '../lib/index.ts'
import type { CircleTable } from '../view/circle-table.ts'
import { type Domain, NO_DOMAIN } from '../view/domain.ts'
import { DEFAULT_LAYERS, type Layers } from '../view/layers.ts'
import type { Described, GlobalResults } from '../view/protocol.ts'
import type { Edited } from '../view/scene-client.ts'
import { type Attributes, NO_ATTRIBUTES } from './attributes.ts'
import { type CircleSet, EMPTY_HISTORY, type History } from './history.ts'

/** The state that panels show. It is replaced, never modified. The circles are kept separately, in a `CircleTable`. */
export interface State {
  /** The opened circles without later edits; `undefined` before the first opening. */
  readonly scene: CircleSet | undefined
  /** The last result; `undefined` before the first opening. */
  readonly edited: Edited | undefined
  readonly history: History
  /** The clipping region and the periods, and the areas by id. */
  readonly domain: Domain
  /** The attributes of circles, by their ids. */
  readonly attributes: Attributes
  /** The colors that tell circles from their neighbors, by ascending id, once they are known (`Edited`). */
  readonly colors: string | undefined
  /** The current problem in one sentence, or an empty text. */
  readonly problem: string
  /** The remedy for the current problem. */
  readonly remedy: Remedy | undefined
  /** The ids of selected circles, the newest last. */
  readonly selection: readonly number[]
  /** The selected circle's id, if exactly one is selected. */
  readonly selected: number | undefined
  /** The selected circle's current values. */
  readonly circle: Circle | undefined
  /** The description of the selected circle, which arrives later. */
  readonly described: Described | undefined
  readonly hovered: number | undefined
  /** The visible layers. */
  readonly layers: Layers
  /** Results for layers that depend on all circles, once computed. */
  readonly found: GlobalResults | undefined
  /** The step of playback, which the player shows and changes here; `undefined` if no method is played. */
  readonly step: number | undefined
  /** The program line of the step, while the trace of changed circles is loading and the step has no number yet. */
  readonly stage: string | undefined
  /** The method of playback; `undefined` for the usual one. */
  readonly method: string | undefined
  readonly tool: Tool
  /** Whether dragged circles snap without a modifier key. */
  readonly isSnapping: boolean
  /** The last announcement for screen readers. A new object announces again. */
  readonly said: { readonly text: string }
}

/** An action that solves a problem. */
export interface Remedy {
  readonly problem: string
  readonly label: string
  act(): void
}

/** The action of a press on the figure. */
export type Tool = 'select' | 'pan' | 'add' | 'draw'

export const INITIAL_STATE: State = {
  scene: undefined,
  edited: undefined,
  history: EMPTY_HISTORY,
  domain: NO_DOMAIN,
  attributes: NO_ATTRIBUTES,
  colors: undefined,
  problem: '',
  remedy: undefined,
  selection: [],
  selected: undefined,
  circle: undefined,
  described: undefined,
  hovered: undefined,
  layers: DEFAULT_LAYERS,
  found: undefined,
  step: undefined,
  stage: undefined,
  method: undefined,
  tool: 'select',
  isSnapping: false,
  said: { text: '' },
}

/** The name of the opened data set, or an empty text. */
export function dataSetName({ scene }: State): string {
  return scene?.dataSet ?? ''
}

/** The state after circles were opened or edited. Removed circles leave the selection; an opening clears it. */
export function stateAfter(state: State, circles: CircleTable, isOpened: boolean): State {
  const selection = isOpened ? [] : state.selection.filter((id) => circles.get(id) !== undefined)
  const next = { ...withSelection(state, selection, circles), problem: '' }
  return isOpened ? { ...next, described: undefined, hovered: undefined } : next
}

/** The state with a selection of circles at their current values. */
export function withSelection(state: State, selection: readonly number[], circles: CircleTable): State {
  const selected = selection.length === 1 ? selection[0] : undefined
  const circle = selected === undefined ? undefined : circles.get(selected)
  return { ...state, selection, selected, circle }
}
