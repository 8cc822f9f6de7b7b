// SPDX-License-Identifier: GPL-3.0-or-later

import type { Figure } from '../player/figure.ts'
import type { Padding } from '../view/camera.ts'
import { disable } from '../view/disable.ts'
import { ADD, FIT, MINUS, PLUS, REDO, REMOVE, UNDO } from '../view/icons.ts'
import { make, type Shell } from './shell.ts'
import type { Words } from './words.ts'

/** Margin around all circles, in pixels. Buttons need more room above. */
const MARGIN = 16
const BELOW_BUTTONS = 12
const SVG = 'http://www.w3.org/2000/svg'

/** The padding of the picture below the buttons. */
export function paddingBelow(controls: HTMLElement): Padding {
  const { clientHeight } = controls
  // In a narrow figure the buttons are below the picture.
  const isAbove = clientHeight > 0 && getComputedStyle(controls).position === 'absolute'
  const top = isAbove ? clientHeight + BELOW_BUTTONS : MARGIN
  return { top, right: MARGIN, bottom: MARGIN, left: MARGIN }
}

/** Mounts the buttons of a running figure. `isReadonly` leaves out the buttons that edit. */
export function mountControls(
  { controls, figure }: Shell,
  { actions, store }: Figure,
  { buttons }: Words,
  isReadonly: boolean,
): void {
  const button = (label: string, path: string, act: () => void): HTMLButtonElement => {
    const element = make('button', '')
    element.type = 'button'
    element.title = label
    element.ariaLabel = label
    const icon = document.createElementNS(SVG, 'svg')
    icon.setAttribute('viewBox', '0 0 20 20')
    icon.ariaHidden = 'true'
    icon.appendChild(document.createElementNS(SVG, 'path')).setAttribute('d', path)
    element.append(icon)
    element.addEventListener('click', act)
    return element
  }
  const add = button(buttons.add, ADD, () => actions.tools.toggleAdding())
  const remove = button(buttons.remove, REMOVE, () => actions.circles.removeSelected())
  const undo = button(buttons.undo, UNDO, () => actions.circles.undo())
  const redo = button(buttons.redo, REDO, () => actions.circles.redo())
  const zoomOut = button(buttons.zoomOut, MINUS, () => actions.camera.zoomAtMiddle(-1))
  const zoomIn = button(buttons.zoomIn, PLUS, () => actions.camera.zoomAtMiddle(1))
  const fit = button(buttons.fit, FIT, () => actions.camera.fit())
  controls.replaceChildren(...(isReadonly ? [] : [add, remove, undo, redo]), zoomOut, zoomIn, fit)

  const unsubscribe = store.subscribe(({ tool, selection, history }) => {
    // The buttons have been replaced or removed.
    if (fit.parentElement !== controls) return unsubscribe()
    add.ariaPressed = String(tool === 'add')
    disable(remove, selection.length === 0, figure)
    disable(undo, history.done.length === 0, figure)
    disable(redo, history.undone.length === 0, figure)
  })
}
