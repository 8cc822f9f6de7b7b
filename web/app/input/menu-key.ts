// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle, Point } from '../../lib/index.ts'
import { pointOf } from '../../view/on-screen.ts'
import type { View } from '../../view/view.ts'

/** Opens a menu at the pointer, or at the selected circle by the menu key. A long press has its own effects. */
export function listenToMenu(
  figure: HTMLElement,
  view: View,
  selected: () => Circle | undefined,
  open: (at: Point) => void,
): void {
  let pressed = ''
  figure.addEventListener('pointerdown', ({ pointerType }) => {
    pressed = pointerType
  })
  figure.addEventListener('keydown', () => {
    pressed = 'key'
  })
  figure.addEventListener('contextmenu', (event) => {
    if (pressed === 'touch') return
    event.preventDefault()
    const circle = pressed === 'key' ? selected() : undefined
    open(circle === undefined ? pointOf(event) : view.toScreen(circle))
  })
}
