// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../lib/diagram-data.ts'
import type { Diagram } from '../lib/index.ts'
import type { Camera } from './camera.ts'
import { applyEdit, type Edit } from './edits.ts'
import { EMPTY_HISTORY, type History, record, stepBack, stepForth } from './history.ts'

/** No circle. */
export const NOBODY = -1

/** Everything that the page shows follows from this value. It is never changed, only replaced. */
export interface State {
  readonly dataSet: string
  /** x, y, r of each circle, as edited. */
  readonly circles: Float64Array
  readonly history: History
  /** The last diagram that was computed. It has its own circles, which lag behind `circles` for a moment. */
  readonly diagram: Diagram | undefined
  /** One sentence about what was refused, or empty. */
  readonly problem: string
  readonly selected: number
  readonly hovered: number
  readonly isAdding: boolean
  readonly camera: Camera
}

export const INITIAL_STATE: State = {
  dataSet: '',
  circles: new Float64Array(0),
  history: EMPTY_HISTORY,
  diagram: undefined,
  problem: '',
  selected: NOBODY,
  hovered: NOBODY,
  isAdding: false,
  camera: { x: 0, y: 0, scale: 1 },
}

export function circleCount({ circles }: State): number {
  return circles.length / 3
}

export function edited(state: State, edit: Edit, gesture: number): State {
  return { ...changed(state, edit), history: record(state.history, edit, gesture) }
}

export function undone(state: State): State {
  const step = stepBack(state.history)
  return step === undefined ? state : { ...changed(state, step.edit), history: step.history }
}

export function redone(state: State): State {
  const step = stepForth(state.history)
  return step === undefined ? state : { ...changed(state, step.edit), history: step.history }
}

/** The last edit taken back because the core refused its circles; it cannot be done again. */
export function refused(state: State, problem: string): State {
  const before = undone(state)
  return { ...before, history: { done: before.history.done, undone: [] }, problem }
}

/** Other circles from the start, without a history. */
export function loaded(state: State, dataSet: string, circles: Float64Array): State {
  return { ...INITIAL_STATE, camera: state.camera, diagram: state.diagram, dataSet, circles }
}

/** An edit of one circle leaves that circle selected; any other selects none. */
function changed(state: State, edit: Edit): State {
  const selected = edit.inserted.length === 3 ? edit.at : NOBODY
  return { ...state, circles: applyEdit(state.circles, edit), selected, hovered: NOBODY, problem: '' }
}

/** x, y, r of the selected circle. */
export function selectedCircle({ circles, selected }: State): { x: number; y: number; r: number } | undefined {
  if (selected === NOBODY) return undefined
  return { x: at(circles, 3 * selected), y: at(circles, 3 * selected + 1), r: at(circles, 3 * selected + 2) }
}
