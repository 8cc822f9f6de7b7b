// SPDX-License-Identifier: GPL-3.0-or-later
import type { Editing } from '../../editing/editing.ts'
import type { FigureActions } from '../../editing/figure-actions.ts'
import type { State } from '../../editing/state.ts'
import type { Store } from '../../view/store.ts'
import type { View } from '../../view/view.ts'
import { byId } from '../panels/by-id.ts'
import { showStop } from '../panels/stop.ts'
import { Motion } from './motion.ts'

/** Animations that are stopped by the button on the picture, by Escape, or when a method is played. */
export function stoppableMotion(store: Store<State>, editing: Editing, view: View, actions: FigureActions): Motion {
  const motion = new Motion(store, editing, view, actions)
  const tool = document.querySelector('[aria-controls="motion"]') as HTMLElement
  motion.onchange(() => {
    showStop(motion.isMoving)
    tool.ariaPressed = motion.isMoving ? 'true' : null
  })
  byId('stop', HTMLButtonElement).addEventListener('click', () => motion.stop())
  store.subscribe(({ step }) => step !== undefined && motion.stop())
  // Before the panels and the figure, where Escape has other effects.
  const stopByKey = (event: KeyboardEvent) => {
    const isOfOther = event.target instanceof Element && event.target.closest('dialog, [popover]') !== null
    if (event.key !== 'Escape' || isOfOther || !motion.isMoving) return
    event.preventDefault()
    event.stopPropagation()
    motion.stop()
  }
  document.addEventListener('keydown', stopByKey, { capture: true })
  return motion
}
