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

/** Keys on the figure, and undo and redo anywhere but in a field. `editNumbers` moves the focus to the fields. */
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

  figure.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey) return
    let isKnown = false
    // What is clicked may not be selected yet.
    pointer.afterwards(() => {
      const isUsed = onFigureKey(event)
      if (isUsed && !isKnown) event.preventDefault()
      isKnown = true
    })
    if (!isKnown) event.preventDefault()
    isKnown = true
  })

  document.addEventListener('keydown', (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.target instanceof HTMLInputElement) return
    const key = event.key.toLowerCase()
    if (key === 'z' && !event.shiftKey) actions.undo()
    else if (key === 'y' || key === 'z') actions.redo()
    else return
    event.preventDefault()
  })
}
