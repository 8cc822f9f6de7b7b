// SPDX-License-Identifier: GPL-3.0-or-later
import type { Edit } from '../lib/index.ts'
import type { LinkState, LinkView } from '../lib/link.ts'
import { attributesOfLink } from './attributes.ts'
import type { CircleSet } from './history.ts'

/** Circles to open, with the viewport, layers and step of a link. */
export interface OpenRequest extends CircleSet {
  readonly edits?: readonly Edit[] | undefined
  readonly view?: LinkView | undefined
  readonly layers?: LinkState['layers']
  /** The step of playback. If `step` is missing, a running player restarts. */
  readonly step?: number | undefined
  /** The method to play. Default: the usual one. */
  readonly method?: string | undefined
}

/**
 * The request that opens a state: that of a link, a file, an element or a figure. `named` has the circles of a data set,
 * whose region the state may replace or remove.
 */
export function requestOf(state: LinkState, named?: CircleSet): OpenRequest {
  const { circles = new Float64Array(), region, lattice, areas, colors, headings, edits, view, layers } = state
  const attributes = attributesOfLink(state, circles.length / 3)
  const { domain, ...set } = named ?? { circles, headings, attributes, dataSet: '', isEdited: false }
  const hasOwn = region !== undefined || lattice !== undefined || areas !== undefined
  const own = {
    region: region === undefined ? domain?.region : (region ?? undefined),
    lattice: lattice ?? undefined,
    areas,
  }
  const played = 'step' in state && { step: state.step, method: state.method }
  return { ...set, domain: hasOwn ? own : domain, colors, edits, view, layers, ...played }
}
