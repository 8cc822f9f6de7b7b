// SPDX-License-Identifier: GPL-3.0-or-later

import type { State } from '../../editing/state.ts'
import type { Store } from '../../view/store.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'

/** Offset from the pointer, in pixels. */
const ASIDE = 14

/** Shows the name of the circle under the pointer. */
export function mountNames(store: Store<State>, { identity }: PageActions): void {
  const tag = byId('name-tag', HTMLElement)
  const figure = byId('figure', HTMLElement)
  let pointer = { x: 0, y: 0 }

  const place = () => {
    if (tag.hidden) return
    const x = Math.max(Math.min(pointer.x + ASIDE, figure.clientWidth - tag.offsetWidth - ASIDE), 0)
    const y = Math.max(Math.min(pointer.y + ASIDE, figure.clientHeight - tag.offsetHeight - ASIDE), 0)
    tag.style.translate = `${x}px ${y}px`
  }
  figure.addEventListener('pointermove', ({ offsetX, offsetY }) => {
    pointer = { x: offsetX, y: offsetY }
    place()
  })
  store.subscribe(({ hovered }) => {
    const name = hovered === undefined ? '' : identity.nameOf(hovered)
    tag.hidden = name === ''
    if (tag.textContent !== name) tag.textContent = name
    place()
  })
}
