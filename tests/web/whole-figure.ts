// SPDX-License-Identifier: GPL-3.0-or-later
// A figure with its thread and its player, without the page around it.
import { type FigureActions, figureActions } from '../../web/editing/figure-actions.ts'
import { Figure, type FigureOptions } from '../../web/player/figure.ts'
import { NO_PADDING } from '../../web/view/camera.ts'
import { make, measure } from './page-document.ts'

export const FIGURE_SIZE = { width: 400, height: 300 }

export function newFigure(more: Partial<FigureOptions<FigureActions>> = {}) {
  const element = document.body.appendChild(make('div', { tabIndex: 0 }))
  measure(element, { clientWidth: FIGURE_SIZE.width, clientHeight: FIGURE_SIZE.height })
  const [player, said] = [make('div'), make('p')]
  document.body.append(player, said)
  const figure = new Figure(
    { figure: element, around: element, player, said },
    {
      actions: (parts) => figureActions(parts, () => NO_PADDING),
      onoutcome() {},
      played: (method) => ({ method: method === 'auto' ? 'auto' : 'touching-disc' }),
      ...more,
    },
  )
  return Object.assign(figure, { element, player, said })
}
