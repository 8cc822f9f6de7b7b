// SPDX-License-Identifier: GPL-3.0-or-later

import type { Listening } from '../../view/pointer.ts'
import type { View } from '../../view/view.ts'
import type { Actions } from '../actions.ts'
import type { State } from '../state.ts'
import type { Store } from '../store.ts'

/** The step of one arrow key, in pixels; Shift makes it bigger, Alt finer. */
const STEP = 4
const BIGGER = 8
const FINER = 1 / 8
const PAN_STEP = 48
const ZOOM_STEP = 1.25

const ARROWS: { readonly [key: string]: readonly [number, number] } = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
}

/** Keys on the figure; undo, redo, Delete and Escape anywhere but in a field. `editNumbers` moves the focus to the fields. */
export function listenToKeyboard(
  figure: HTMLElement,
  view: View,
  pointer: Listening,
  store: Store<State>,
  actions: Actions,
  editNumbers: () => void,
): void {
  // A key that is held down is one gesture.
  let gesture = 0

  const onFigureKey = (event: KeyboardEvent): boolean => {
    const { selected, isAdding } = store.get()
    const hasSelection = selected !== undefined
    const step = (STEP * (event.shiftKey ? BIGGER : 1) * (event.altKey ? FINER : 1)) / view.camera.scale
    const arrow = ARROWS[event.key]
    if (!event.repeat) gesture = actions.beginGesture()

    if (arrow !== undefined) {
      if (hasSelection) actions.moveSelected(arrow[0] * step, arrow[1] * step, gesture)
      else actions.pan(-arrow[0] * PAN_STEP, arrow[1] * PAN_STEP)
      return true
    }
    switch (event.key) {
      case 'Tab':
        return hasSelection && actions.selectNext(event.shiftKey ? -1 : 1)
      case 'Enter':
        if (hasSelection) editNumbers()
        else actions.selectNearMiddle()
        return true
      case '+':
      case '=':
        if (hasSelection) actions.growSelected(step, gesture)
        else actions.zoomAtMiddle(ZOOM_STEP)
        return true
      case '-':
      case '_':
        if (hasSelection) actions.growSelected(-step, gesture)
        else actions.zoomAtMiddle(1 / ZOOM_STEP)
        return true
      case '0':
        actions.fit()
        return true
      case 'Delete':
      case 'Backspace':
        actions.removeSelected()
        return true
      case 'Escape':
        actions.release()
        return hasSelection || isAdding
      default:
        return false
    }
  }

  /** What is clicked may not be selected yet: then it is not known whether the key is used, and the browser does not get it. */
  const afterPointer = (event: KeyboardEvent, act: () => boolean) => {
    const { pending } = pointer
    if (pending !== undefined) pending.finally(act)
    if (pending !== undefined || act()) event.preventDefault()
  }

  figure.addEventListener('keydown', (event) => {
    if (!(event.ctrlKey || event.metaKey)) afterPointer(event, () => onFigureKey(event))
  })

  document.addEventListener('keydown', (event) => {
    if (event.target instanceof Element && event.target.closest('input, textarea, select, dialog') !== null) return
    const act = actionOf(event)
    if (act === undefined) return
    afterPointer(event, () => {
      act()
      return true
    })
  })

  const actionOf = (event: KeyboardEvent): (() => void) | undefined => {
    const key = event.key.toLowerCase()
    if (event.ctrlKey || event.metaKey) {
      if (key === 'z' && !event.shiftKey) return () => actions.undo()
      return key === 'y' || key === 'z' ? () => actions.redo() : undefined
    }
    // The focus may be on a button of the toolbar.
    if (event.target === figure) return undefined
    if (key === 'escape') return () => actions.release()
    return key === 'delete' || key === 'backspace' ? () => actions.removeSelected() : undefined
  }
}
