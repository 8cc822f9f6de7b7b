// SPDX-License-Identifier: GPL-3.0-or-later

import { figureActions } from '../../../web/editing/figure-actions.ts'
import { Figure } from '../../../web/player/figure.ts'
import { toPNG, toSVG } from '../../../web/view/export.ts'

const circles = Float64Array.of(0, 0, 2, 10, 0, 1, 5, 8, 1.5)
const padding = { top: 16, right: 16, bottom: 16, left: 16 }
const mount = (id: string) => {
  const figure = document.getElementById(id) as HTMLElement
  const [player, said] = [document.createElement('div'), document.createElement('p')]
  return new Figure(
    { figure, around: figure, player, said },
    { actions: (parts) => figureActions(parts, () => padding), onoutcome() {}, played: () => ({}) },
  )
}
const [one, other] = [mount('one'), mount('other')]
for (const figure of [one, other]) await figure.open({ circles, dataSet: '', isEdited: false })

/** The interface of the page for the test. */
export interface TwoViews {
  one: Figure
  other: Figure
  mount: typeof mount
  toSVG: typeof toSVG
  toPNG: typeof toPNG
}

Object.assign(globalThis, { views: { one, other, mount, toSVG, toPNG } })
