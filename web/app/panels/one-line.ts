// SPDX-License-Identifier: GPL-3.0-or-later
import { byId } from './by-id.ts'

/** A shorter movement counts as a tap, in pixels. */
const TAP = 4

/**
 * On a phone, the card of the selection is one line while a finger drags, so that it does not cover what the finger
 * moves. A tap opens it (style.css).
 */
export function mountOneLine(): void {
  const figure = byId('figure', HTMLElement)
  const { classList } = document.body
  let start: PointerEvent | undefined
  figure.addEventListener('pointerdown', (event) => {
    if (event.pointerType !== 'touch') return
    start = event
    classList.add('one-line')
  })
  figure.addEventListener('pointerup', (event) => {
    const isTap = start !== undefined && Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) < TAP
    if (isTap) classList.remove('one-line')
  })
  for (const id of ['inspector', 'group']) {
    byId(id, HTMLElement).addEventListener('click', () => classList.remove('one-line'))
  }
}
