// SPDX-License-Identifier: GPL-3.0-or-later
import { type FigureActions, type FigureParts, figureActions } from '../editing/figure-actions.ts'
import { LINK_LIMITS } from '../lib/link.ts'
import type { Padding } from '../view/camera.ts'
import { ColoringActions } from './coloring-actions.ts'
import { DataActions, type Reader } from './data-actions.ts'
import { DomainActions } from './domain-actions.ts'
import { IdentityActions } from './identity-actions.ts'

/** Everything that a user can do with the page. */
export interface PageActions extends FigureActions {
  readonly domain: DomainActions
  readonly identity: IdentityActions
  readonly coloring: ColoringActions
  readonly data: DataActions
}

export function pageActions(figure: FigureParts, padding: () => Padding, reader: Reader): PageActions {
  const { store, editing, view } = figure
  const actions = figureActions(figure, padding)
  const { opening } = actions
  const coloring = new ColoringActions(editing, view)
  // Names in links are limited like circles in links.
  opening.mostNamed = LINK_LIMITS.circles
  opening.onopened = ({ layers }) => {
    const column: unknown = layers?.column
    if (typeof column === 'string') coloring.colorBy(column)
  }
  return {
    ...actions,
    coloring,
    domain: new DomainActions(editing, actions),
    identity: new IdentityActions(editing),
    data: new DataActions(store, opening, coloring, reader),
  }
}
