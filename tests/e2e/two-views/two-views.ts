// SPDX-License-Identifier: GPL-3.0-or-later
import { mount } from '../../../web/view/mount.ts'
import type { View } from '../../../web/view/view.ts'

const circles = Float64Array.of(0, 0, 2, 10, 0, 1, 5, 8, 1.5)
const [one, other] = ['one', 'other'].map((id) => mount(document.getElementById(id) as HTMLElement, { circles }))

/** What the test talks to. */
export interface TwoViews {
  one: View
  other: View
  mount: typeof mount
}

Object.assign(globalThis, { views: { one, other, mount } })
