// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle } from '../lib/index.ts'
import type { CircleTable } from '../view/circle-table.ts'
import { type Domain, NO_DOMAIN } from '../view/domain.ts'
import { DEFAULT_LAYERS, type Layers } from '../view/layers.ts'
import type { Edited } from '../view/painter.ts'
import type { Described, Found } from '../view/protocol.ts'
import { type Attributes, NO_ATTRIBUTES } from './attributes.ts'
import type { Outcome } from './editing.ts'
import { EMPTY_HISTORY, type History } from './history.ts'

/** What the panels show. It is never changed, only replaced; the circles themselves are in a `CircleTable`. */
export interface State {
  readonly dataSet: string
  /** Of the circles as they are; `undefined`: none yet. */
  readonly edited: Edited | undefined
  readonly history: History
  readonly domain: Domain
  /** What else is known of circles, by their numbers. */
  readonly attributes: Attributes
  /** One sentence about what was refused, or empty. */
  readonly problem: string
  /** What can be done about a problem, as long as it is that one. */
  readonly remedy: Remedy | undefined
  /** Those that are selected, the newest last. */
  readonly selection: readonly number[]
  /** The one that is, if there is only one. */
  readonly selected: number | undefined
  /** The selected circle as it is. */
  readonly circle: Circle | undefined
  /** What is known of it, a moment later. */
  readonly described: Described | undefined
  readonly hovered: number | undefined
  /** What is drawn. */
  readonly layers: Layers
  /** What of it depends on all circles, once it is known. */
  readonly found: Found | undefined
  /** The step of the method that is shown; `undefined`: it is not played. */
  readonly step: number | undefined
  /** Which method that is; `undefined`: as usual. */
  readonly method: string | undefined
  readonly tool: Tool
  /** Whether dragged circles snap without a key. */
  readonly isSnapping: boolean
  /** What is said to screen-reader users; another object each time. */
  readonly said: { readonly text: string }
}

/** A way out of a problem. */
export interface Remedy {
  readonly problem: string
  readonly label: string
  act(): void
}

/** What a press on the figure does. */
export type Tool = 'select' | 'pan' | 'add' | 'draw'

export const INITIAL_STATE: State = {
  dataSet: '',
  edited: undefined,
  history: EMPTY_HISTORY,
  domain: NO_DOMAIN,
  attributes: NO_ATTRIBUTES,
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
  method: undefined,
  tool: 'select',
  isSnapping: false,
  said: { text: '' },
}

/** The state once circles were opened or edited: those that were selected may be gone, and other circles have other ids. */
export function stateAfter(state: State, outcome: Outcome, circles: CircleTable): State {
  const { edited, history, domain, attributes, isOpened } = outcome
  const selection = isOpened ? [] : state.selection.filter((id) => circles.get(id) !== undefined)
  const next = { ...withSelection(state, selection, circles), edited, history, domain, attributes, problem: '' }
  return isOpened ? { ...next, described: undefined, hovered: undefined } : next
}

/** The state with this selection of circles, as they are. */
export function withSelection(state: State, selection: readonly number[], circles: CircleTable): State {
  const selected = selection.length === 1 ? selection[0] : undefined
  const circle = selected === undefined ? undefined : circles.get(selected)
  return { ...state, selection, selected, circle }
}
