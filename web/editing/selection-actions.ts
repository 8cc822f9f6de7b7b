// SPDX-License-Identifier: GPL-3.0-or-later

import type { Box, Circle } from '../lib/index.ts'
import type { Layers } from '../view/layers.ts'
import { describedIn, selectedIn } from '../view/view-state.ts'
import { nextInDirection } from './arranging.ts'
import { CameraActions } from './camera-actions.ts'
import { nameIn } from './identity.ts'
import type { Tool } from './state.ts'
import { ENGLISH_EDITING } from './words.ts'

/** A user's choice of circles, tools and layers, and what screen readers hear of it. */
export class SelectionActions extends CameraActions {
  /** The texts for screen readers. */
  words = ENGLISH_EDITING
  /** A circle within a sentence: its name, or its number. */
  readonly called = (id: number): string => this.words.called(id, nameIn(this.editing.attributes, id))
  #isPanning = false

  get tool(): Tool {
    return this.#isPanning ? 'pan' : this.store.get().tool
  }

  get snaps(): boolean {
    return this.store.get().isSnapping
  }

  /** Shows a step of a method; `undefined` ends playback. `stage` is that of the state. */
  showStep(step: number | undefined, method = this.store.get().method, stage?: string): void {
    this.store.update((state) => {
      const isSame = state.step === step && state.method === method && state.stage === stage
      return isSame ? state : { ...state, step, method, stage }
    })
  }

  useTool(tool: Tool): void {
    this.store.update((state) => (state.tool === tool ? state : { ...state, tool }))
  }

  /** Switches the tool for adding circles on or off. */
  toggleAdding(): void {
    this.useTool(this.store.get().tool === 'add' ? 'select' : 'add')
  }

  /** Lets drags pan while a key is held. */
  holdPanning(isHeld: boolean): void {
    this.#isPanning = isHeld
  }

  toggleSnapping(): void {
    const isSnapping = !this.snaps
    this.store.update((state) => ({ ...state, isSnapping }))
    this.say(isSnapping ? this.words.snaps : this.words.snapsNot)
  }

  /** Shows a problem in one sentence. An empty text clears it. */
  complain(problem: string): void {
    this.store.update((state) => ({ ...state, problem }))
  }

  select(ids: readonly number[]): void {
    this.store.update((state) => {
      if (ids.length === state.selection.length && ids.every((id, k) => id === state.selection[k])) return state
      return { ...state, selection: ids, problem: '' }
    })
  }

  isSelected(id: number): boolean {
    return this.store.get().selection.includes(id)
  }

  /** Adds a circle to the selection, or removes it. */
  toggle(id: number): void {
    const { selection } = this.store.get()
    this.select(selection.includes(id) ? selection.filter((other) => other !== id) : [...selection, id])
  }

  /** Adds the circles with centers in a box to the selection. */
  selectWithin(box: Box): void {
    const { selection } = this.store.get()
    this.select([...new Set([...selection, ...this.editing.circles.within(box)])])
    this.#saySelected()
  }

  selectAll(): void {
    this.select([...this.editing.circles.ids()])
    this.#saySelected()
  }

  /** Selects a circle and brings it into view. */
  goTo(id: number): void {
    this.select([id])
    this.revealCircle(id)
  }

  /** Selects the circle nearest to the middle of the view. */
  selectNearMiddle(): void {
    const hit = this.view.hitAt(this.view.camera, 0)
    if (hit !== undefined) this.select([hit.id])
  }

  /** Selects the next or previous circle by number. Returns whether there is one. */
  selectNext(step: 1 | -1): boolean {
    const last = this.store.get().selection.at(-1)
    const next = last === undefined ? undefined : this.editing.circles.next(last + step, step)
    if (next !== undefined) this.goTo(next)
    return next !== undefined
  }

  /** Selects the neighbor in a direction of length 1. */
  selectNeighbor(direction: readonly [number, number]): void {
    const selected = selectedIn(this.store.get())
    const circle = selected === undefined ? undefined : this.editing.circles.get(selected)
    const next = circle === undefined ? undefined : nextInDirection(circle, this.neighbors(), direction)
    if (next !== undefined) this.goTo(next.id)
  }

  /** The neighbors of the selected circles that are not selected. */
  protected neighbors(): (Circle & { id: number })[] {
    const ids = describedIn(this.store.get())?.neighbors ?? []
    return [...ids].flatMap((id) => {
      const circle = this.editing.circles.get(id)
      return circle === undefined ? [] : [{ ...circle, id }]
    })
  }

  protected say(text: string): void {
    this.store.update((state) => ({ ...state, said: { text } }))
  }

  #saySelected(): void {
    const count = this.store.get().selection.length
    if (count !== 1) this.say(this.words.selected(count))
  }

  hover(id: number | undefined): void {
    this.store.update((state) => (state.hovered === id ? state : { ...state, hovered: id }))
  }

  /** Ends the current tool; without one, clears the selection. */
  release(): void {
    if (this.store.get().tool !== 'select') this.useTool('select')
    else this.select([])
  }

  /** Changes some of the layers. */
  setLayers(change: Partial<Layers>): void {
    this.view.setLayers(change)
  }
}
