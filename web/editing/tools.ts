// SPDX-License-Identifier: GPL-3.0-or-later
import type { Point } from '../lib/index.ts'
import type { Store } from '../view/store.ts'
import type { Messages } from './messages.ts'
import type { State, Tool } from './state.ts'

/** Draws a polygon corner by corner. */
export interface Pen {
  /** Moves the next corner. */
  move(point: Point): void
  /** Places a corner. At the first corner, `within` a distance in units, it closes the polygon. */
  place(point: Point, within: number): void
  close(): void
  /** Handles a key, and returns whether it used the key. `step` is that of arrow keys, in units. */
  key(key: string, step: number): boolean
  /** Removes the last corner. Returns false if there is none. */
  undo(): boolean
}

/** The tool of a press, and snapping. */
export class Tools {
  readonly #store: Store<State>
  readonly #messages: Messages
  #isPanning = false
  /** Draws regions with the tool `draw`. */
  pen: Pen | undefined

  constructor(store: Store<State>, messages: Messages) {
    this.#store = store
    this.#messages = messages
  }

  get tool(): Tool {
    return this.#isPanning ? 'pan' : this.#store.get().tool
  }

  /** Whether dragged circles snap without a modifier key. */
  get snaps(): boolean {
    return this.#store.get().isSnapping
  }

  useTool(tool: Tool): void {
    this.#store.update((state) => (state.tool === tool ? state : { ...state, tool }))
  }

  /** Switches the tool for adding circles on or off. */
  toggleAdding(): void {
    this.useTool(this.#store.get().tool === 'add' ? 'select' : 'add')
  }

  /** Lets drags pan while a key is held. */
  holdPanning(isHeld: boolean): void {
    this.#isPanning = isHeld
  }

  toggleSnapping(): void {
    const isSnapping = !this.snaps
    this.#store.update((state) => ({ ...state, isSnapping }))
    const { words } = this.#messages
    this.#messages.say(isSnapping ? words.snaps : words.snapsNot)
  }
}
