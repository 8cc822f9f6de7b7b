// SPDX-License-Identifier: GPL-3.0-or-later

import { roundStep } from '../view/round-step.ts'
import type { Store } from '../view/store.ts'
import type { View } from '../view/view.ts'
import { type FigureActions, release } from './figure-actions.ts'
import type { State } from './state.ts'

/** Step of an arrow key in pixels. Shift enlarges it, Alt reduces it. */
const STEP = 4
const BIGGER = 10
const FINER = 1 / 10
/** Factor minus 1 of one scaling step for several circles. */
const SCALE_STEP = 0.04
const PAN_STEP = 48

/** The direction of each arrow key in the plane. */
export const ARROWS: { readonly [key: string]: readonly [number, number] } = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
}

/** Keyboard shortcuts that do not concern circles. */
export interface KeyActions {
  /** Moves the focus to the number fields of the selected circle. */
  editNumbers?(): void
  showHelp?(): void
  /** Begins to draw a region. */
  drawRegion?(): void
}

export interface KeyboardOptions {
  /** Receives the shortcuts that work wherever the focus is. */
  readonly around: Document | HTMLElement
  /** Aborting the signal removes all listeners. */
  readonly signal: AbortSignal
}

/** Listens to keys on the figure, and to some shortcuts anywhere in `around` except in fields. */
export function listenToKeyboard(
  figure: HTMLElement,
  view: View,
  store: Store<State>,
  actions: FigureActions,
  { editNumbers, showHelp, drawRegion }: KeyActions,
  { around, signal }: KeyboardOptions,
): void {
  // A held key is one gesture.
  let gesture = 0

  const letters: { readonly [key: string]: (() => void) | undefined } = {
    '?': showHelp,
    v: () => actions.tools.useTool('select'),
    h: () => actions.tools.useTool('pan'),
    a: () => actions.tools.useTool('add'),
    s: () => actions.tools.toggleSnapping(),
    p: drawRegion,
  }

  const onFigureKey = (event: KeyboardEvent): boolean => {
    const { selection, tool } = store.get()
    const hasSelection = selection.length > 0
    const times = (event.shiftKey ? BIGGER : 1) * (event.altKey ? FINER : 1)
    const step = Number((roundStep(STEP / view.camera.scale) * times).toPrecision(1))
    const arrow = ARROWS[event.key]
    if (!event.repeat) gesture = actions.circles.beginGesture()

    if (tool === 'draw' && actions.tools.pen?.key(event.key, step) === true) return true
    if (arrow !== undefined) {
      if (hasSelection && !actions.circles.isReadonly)
        actions.circles.moveSelected(arrow[0] * step, arrow[1] * step, gesture)
      else actions.camera.pan(-arrow[0] * PAN_STEP, arrow[1] * PAN_STEP)
      return true
    }
    switch (event.key) {
      case 'Tab':
        return hasSelection && actions.selection.selectNext(event.shiftKey ? -1 : 1)
      case 'Enter':
        if (hasSelection) editNumbers?.()
        else actions.selection.selectNearMiddle()
        return true
      case '+':
      case '=':
        if (hasSelection && !actions.circles.isReadonly)
          actions.circles.growSelected(step, 1 + SCALE_STEP * times, gesture)
        else actions.camera.zoomAtMiddle(1)
        return true
      case '-':
      case '_':
        if (hasSelection && !actions.circles.isReadonly)
          actions.circles.growSelected(-step, 1 / (1 + SCALE_STEP * times), gesture)
        else actions.camera.zoomAtMiddle(-1)
        return true
      case '0':
        actions.camera.fit()
        return true
      case 'f':
        actions.camera.zoomToSelection()
        return hasSelection
      case 'n':
        actions.circles.addInRoom()
        return true
      case 'Delete':
      case 'Backspace':
        actions.circles.removeSelected()
        return true
      case 'Escape':
        release(actions)
        return hasSelection || tool !== 'select'
      case ' ':
        actions.tools.holdPanning(true)
        return true
      default: {
        const act = event.altKey ? undefined : letters[event.key.toLowerCase()]
        act?.()
        return act !== undefined
      }
    }
  }

  /** Shortcuts with Ctrl or Cmd, on the figure and elsewhere. */
  const commandOf = (event: KeyboardEvent): (() => void) | undefined => {
    const arrow = event.target === figure ? ARROWS[event.key] : undefined
    if (arrow !== undefined) return () => actions.selection.selectNeighbor(arrow)
    switch (event.key.toLowerCase()) {
      case 'z':
        return event.shiftKey ? () => actions.circles.redo() : () => actions.circles.undo()
      case 'y':
        return () => actions.circles.redo()
      case 'a':
        return () => actions.selection.selectAll()
      case 'd':
        return () => actions.circles.duplicateSelected()
      default:
        return undefined
    }
  }

  /** Shortcuts that work wherever the focus is. Letters would disturb speech input there. */
  const actionOf = ({ key, target }: KeyboardEvent): (() => void) | undefined => {
    if (target === figure) return undefined
    if (key === 'Escape') return () => release(actions)
    return key === 'Delete' ? () => actions.circles.removeSelected() : undefined
  }

  /**
   * Defers a shortcut until the edits that select circles are done. As its effect is not known yet, the browser's
   * default action is suppressed.
   */
  const afterwards = (event: KeyboardEvent, act: () => boolean) => {
    const { pending } = actions.circles
    if (pending !== undefined) pending.finally(act)
    if (pending !== undefined || act()) event.preventDefault()
  }

  const onKey = (event: KeyboardEvent) => {
    if (!(event.ctrlKey || event.metaKey)) afterwards(event, () => onFigureKey(event))
  }
  const onKeyUp = (event: KeyboardEvent) => {
    if (event.key === ' ') actions.tools.holdPanning(false)
  }
  figure.addEventListener('keydown', onKey, { signal })
  figure.addEventListener('keyup', onKeyUp, { signal })
  figure.addEventListener('blur', () => actions.tools.holdPanning(false), { signal })

  const onKeyAround = (event: KeyboardEvent) => {
    if (event.target instanceof Element && event.target.closest('input, textarea, select, dialog') !== null) return
    const act = event.ctrlKey || event.metaKey ? commandOf(event) : event.altKey ? undefined : actionOf(event)
    if (act === undefined) return
    afterwards(event, () => {
      act()
      return true
    })
  }
  // TypeScript finds no common signature of the two.
  ;(around as HTMLElement).addEventListener('keydown', onKeyAround, { signal })
  if ('body' in around) return
  // The surrounding page may use the same keys, as slides do.
  around.addEventListener(
    'keydown',
    (event) => {
      const isOfButton = ['Enter', ' '].includes(event.key) && (event.target as Element).localName === 'button'
      if (event.defaultPrevented || isOfButton) event.stopPropagation()
    },
    { signal },
  )
}
