// SPDX-License-Identifier: GPL-3.0-or-later

import type { Box, Circle } from '../lib/index.ts'
import { describedIn, selectedIn } from '../view/view-state.ts'
import { nextInDirection } from './arranging.ts'
import type { FigureActions, FigureParts } from './figure-actions.ts'

/** Choosing circles. */
export class SelectionActions {
  readonly #figure: FigureParts
  readonly #actions: Pick<FigureActions, 'camera' | 'messages'>
  constructor(figure: FigureParts, actions: Pick<FigureActions, 'camera' | 'messages'>) {
    this.#figure = figure
    this.#actions = actions
  }

  select(ids: readonly number[]): void {
    this.#figure.store.update((state) => {
      if (ids.length === state.selection.length && ids.every((id, k) => id === state.selection[k])) return state
      return { ...state, selection: ids, problem: '' }
    })
  }

  isSelected(id: number): boolean {
    return this.#figure.store.get().selection.includes(id)
  }

  /** Adds a circle to the selection, or removes it. */
  toggle(id: number): void {
    const { selection } = this.#figure.store.get()
    this.select(selection.includes(id) ? selection.filter((other) => other !== id) : [...selection, id])
  }

  /** Adds the circles with centers in a box to the selection. */
  selectWithin(box: Box): void {
    const { selection } = this.#figure.store.get()
    this.select([...new Set([...selection, ...this.#figure.editing.circles.within(box)])])
    this.#saySelected()
  }

  selectAll(): void {
    this.select([...this.#figure.editing.circles.ids()])
    this.#saySelected()
  }

  /** Selects a circle and brings it into view. */
  goTo(id: number): void {
    this.select([id])
    this.#actions.camera.revealCircle(id)
  }

  /** Selects the circle nearest to the middle of the view. */
  selectNearMiddle(): void {
    const hit = this.#figure.view.hitAt(this.#figure.view.camera, 0)
    if (hit !== undefined) this.select([hit.id])
  }

  /** Selects the next or previous circle by number. Returns whether there is one. */
  selectNext(step: 1 | -1): boolean {
    const last = this.#figure.store.get().selection.at(-1)
    const next = last === undefined ? undefined : this.#figure.editing.circles.next(last + step, step)
    if (next !== undefined) this.goTo(next)
    return next !== undefined
  }

  /** Selects the neighbor in a direction of length 1. */
  selectNeighbor(direction: readonly [number, number]): void {
    const selected = selectedIn(this.#figure.store.get())
    const circle = selected === undefined ? undefined : this.#figure.editing.circles.get(selected)
    const next = circle === undefined ? undefined : nextInDirection(circle, this.neighbors(), direction)
    if (next !== undefined) this.goTo(next.id)
  }

  /** The neighbors of the selected circles that are not selected. */
  neighbors(): (Circle & { id: number })[] {
    const ids = describedIn(this.#figure.store.get())?.neighbors ?? []
    return [...ids].flatMap((id) => {
      const circle = this.#figure.editing.circles.get(id)
      return circle === undefined ? [] : [{ ...circle, id }]
    })
  }

  #saySelected(): void {
    const count = this.#figure.store.get().selection.length
    if (count !== 1) this.#actions.messages.say(this.#actions.messages.words.selected(count))
  }

  hover(id: number | undefined): void {
    this.#figure.store.update((state) => (state.hovered === id ? state : { ...state, hovered: id }))
  }
}
