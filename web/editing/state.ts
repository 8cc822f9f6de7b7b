// SPDX-License-Identifier: GPL-3.0-or-later
import type { CircleTable } from '../view/circle-table.ts'
import { type Domain, NO_DOMAIN } from '../view/domain.ts'
import type { Edited } from '../view/scene-client.ts'
import type { Store } from '../view/store.ts'
import { initialView, type ViewState } from '../view/view-state.ts'
import { type Attributes, NO_ATTRIBUTES } from './attributes.ts'
import { type CircleSet, EMPTY_HISTORY, type History } from './history.ts'

/** The state that panels show. It is replaced, never modified. The circles are kept separately, in a `CircleTable`. */
export interface State extends ViewState {
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

export const initialState = (): State => ({
  ...initialView(),
  scene: undefined,
  edited: undefined,
  history: EMPTY_HISTORY,
  domain: NO_DOMAIN,
  attributes: NO_ATTRIBUTES,
  colors: undefined,
  problem: '',
  remedy: undefined,
  step: undefined,
  stage: undefined,
  method: undefined,
  tool: 'select',
  isSnapping: false,
  said: { text: '' },
})

/** Shows a step of a method; `undefined` ends playback. `stage` is that of the state. */
export function showStep(
  store: Store<State>,
  step: number | undefined,
  method = store.get().method,
  stage?: string,
): void {
  store.update((state) => {
    const isSame = state.step === step && state.method === method && state.stage === stage
    return isSame ? state : { ...state, step, method, stage }
  })
}

/** The name of the opened data set, or an empty text. */
export function dataSetName({ scene }: State): string {
  return scene?.dataSet ?? ''
}

/** The state after circles were opened or edited. Removed circles leave the selection; an opening clears it. */
export function stateAfter(state: State, circles: CircleTable, isOpened: boolean): State {
  const isGone = (id: number) => circles.get(id) === undefined
  if (isOpened) return { ...state, selection: [], hovered: undefined, problem: '' }
  const { selection } = state
  return {
    ...state,
    selection: selection.some(isGone) ? selection.filter((id) => !isGone(id)) : selection,
    problem: '',
  }
}
