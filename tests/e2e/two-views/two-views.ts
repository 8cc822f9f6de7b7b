// SPDX-License-Identifier: GPL-3.0-or-later

import { mountEdited } from '../../../web/editing/edited-view.ts'
import { figureActions } from '../../../web/editing/figure-actions.ts'
import { listenToPointer } from '../../../web/editing/pointer.ts'
import { toPNG, toSVG } from '../../../web/view/export.ts'
import { mount } from '../../../web/view/mount.ts'
import type { View } from '../../../web/view/view.ts'

const circles = Float64Array.of(0, 0, 2, 10, 0, 1, 5, 8, 1.5)
const nothing = () => {}
const edited = async (id: string) => {
  const container = document.getElementById(id) as HTMLElement
  const { view, store, editing } = mountEdited(container, undefined, nothing, nothing)
  const actions = figureActions(store, editing, view, () => ({ top: 16, right: 16, bottom: 16, left: 16 }))
  listenToPointer(container, { view, editing, actions })
  await actions.opening.open(async () => ({ circles, dataSet: '', isEdited: false }))
  return view
}
const [one, other] = await Promise.all([edited('one'), edited('other')])

/** The interface of the page for the test. */
export interface TwoViews {
  one: View
  other: View
  mount: typeof mount
  toSVG: typeof toSVG
  toPNG: typeof toPNG
}

Object.assign(globalThis, { views: { one, other, mount, toSVG, toPNG } })
