// SPDX-License-Identifier: GPL-3.0-or-later

import type { Editing } from '../../editing/editing.ts'
import type { FigureActions } from '../../editing/figure-actions.ts'
import { type State, showStep } from '../../editing/state.ts'
import type { Box } from '../../lib/index.ts'
import type { Store } from '../../view/store.ts'
import type { View } from '../../view/view.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import { type Movement, type MovementName, movementOf } from './movements.ts'

/** Largest number of moving circles. Each is edited in each frame. */
export const MOST_MOVING = 2000
/** Longest time step in seconds. A late frame moves no farther. */
const LONGEST_STEP = 1 / 20

/** Animates circles by editing them. The whole animation is one undo step, and any other edit ends it, also undo. */
export class Motion {
  readonly #editing: Editing
  readonly #store: Store<State>
  readonly #view: View
  readonly #actions: FigureActions
  #frame = 0
  /** The gesture of the current animation. */
  #gesture = 0
  readonly #listeners = new Set<() => void>()

  constructor(store: Store<State>, editing: Editing, view: View, actions: FigureActions) {
    this.#store = store
    this.#view = view
    this.#editing = editing
    this.#actions = actions
  }

  get isMoving(): boolean {
    return this.#frame !== 0
  }

  /** Calls a function when the animation begins and ends. */
  onchange(listener: () => void): void {
    this.#listeners.add(listener)
  }

  #tell(): void {
    for (const listener of this.#listeners) listener()
  }

  start(name: MovementName): void {
    this.stop()
    const table = this.#editing.circles
    const circles = Array.from(table.ids(), (id) => ({ id, circle: table.get(id) })).flatMap(({ id, circle }) =>
      circle === undefined ? [] : [{ id, circle }],
    )
    if (circles.length === 0) return
    if (circles.length > MOST_MOVING) {
      this.#actions.messages.complain(`At most ${wholeNumber(MOST_MOVING)} circles can move at once; there are more.`)
      return
    }
    this.#actions.selection.select([])
    showStep(this.#store, undefined)
    if (name === 'compare') this.#view.setLayers({ edges: true, ordinary: true, power: true })
    this.#run(movementOf(name, circles, this.#room(table.box())))
    this.#tell()
  }

  stop(): void {
    if (this.#frame === 0) return
    cancelAnimationFrame(this.#frame)
    this.#frame = 0
    this.#tell()
  }

  /** Stops, and brings the circles back to where they were. */
  async cancel(): Promise<void> {
    this.stop()
    await this.#editing.cancel(this.#gesture)
  }

  #run(movement: Movement): void {
    const table = this.#editing.circles
    const gesture = this.#actions.circles.beginGesture()
    this.#gesture = gesture
    let last: number | undefined
    let isAsked = false
    let hasBegun = false
    /** Whether somebody else has edited the circles, or is about to. */
    const isOver = () => {
      const last = this.#store.get().history.done.at(-1)
      return this.#editing.unfinished > 0 || last?.kind !== 'edits' || last.gesture !== gesture
    }
    const frame = (now: number) => {
      // Other circles have been opened.
      if (this.#editing.circles !== table) return this.stop()
      this.#frame = requestAnimationFrame(frame)
      if (isAsked) return
      if (hasBegun && isOver()) return this.stop()
      const seconds = Math.min((now - (last ?? now)) / 1000, LONGEST_STEP)
      last = now
      isAsked = true
      this.#editing
        .edit(
          movement(seconds).map(({ id, circle }) => ({ kind: 'replace', id, circle })),
          gesture,
        )
        .then((edited) => {
          isAsked = false
          hasBegun = true
          // A new animation may have begun since.
          if (edited === undefined && this.#gesture === gesture) this.stop()
        })
    }
    this.#frame = requestAnimationFrame(frame)
  }

  /** The walls: the viewport if it contains all circles. */
  #room(box: Box): Box {
    const { minX, minY, maxX, maxY } = this.#actions.camera.uncovered
    return {
      minX: Math.min(minX, box.minX),
      minY: Math.min(minY, box.minY),
      maxX: Math.max(maxX, box.maxX),
      maxY: Math.max(maxY, box.maxY),
    }
  }
}
