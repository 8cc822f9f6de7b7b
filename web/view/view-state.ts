// SPDX-License-Identifier: GPL-3.0-or-later
import type { Camera } from './camera.ts'
import { DEFAULT_LAYERS, type Layers } from './layers.ts'
import type { Described, GlobalResults, Highlights } from './protocol.ts'

/** The part of a figure's state that its view draws, besides the circles. It is replaced, never modified. */
export interface ViewState {
  readonly camera: Camera
  /** The layers. They are not drawn if only circles are shown (`View.hasDiagram`). */
  readonly layers: Layers
  /** The ids of selected circles, the newest last. */
  readonly selection: readonly number[]
  readonly hovered: number | undefined
  /** The descriptions of the selected and the hovered circle, which arrive later. */
  readonly highlights: Highlights
  /** Results for layers that depend on all circles, once computed. */
  readonly found: GlobalResults | undefined
}

export const NO_HIGHLIGHTS: Highlights = { selected: undefined, hovered: undefined }

/** The state before the first opening. It is a function, because a bundler may evaluate the layers after this module. */
export const initialView = (): ViewState => ({
  camera: { x: 0, y: 0, scale: 1 },
  layers: DEFAULT_LAYERS,
  selection: [],
  hovered: undefined,
  highlights: NO_HIGHLIGHTS,
  found: undefined,
})

/** The description of the selected circle, once it is known. */
export function describedIn(state: ViewState): Described | undefined {
  const { selected } = state.highlights
  return selected?.id === selectedIn(state) ? selected : undefined
}

/** The selected circle's id, if exactly one is selected. */
export function selectedIn({ selection }: Pick<ViewState, 'selection'>): number | undefined {
  return selection.length === 1 ? selection[0] : undefined
}
