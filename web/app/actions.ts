// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../lib/diagram-data.ts'
import type { Point } from '../lib/index.ts'
import { boundingBox, type Camera, fitted, type Padding, panned, type Size, zoomed } from './camera.ts'
import { DATA_SETS } from './data-sets.ts'
import { appendCircle, removeCircle, replaceCircle } from './edits.ts'
import { circleCount, edited, loaded, NOBODY, redone, type State, selectedCircle, undone } from './state.ts'
import type { Store } from './store.ts'

/** How far one may zoom in and out from the whole picture. */
const LARGEST_ZOOM = 1e7
const SMALLEST_ZOOM = 0.05

/** All that a user can do. Input and panels call these; nothing else changes the state, but for computed diagrams. */
export class Actions {
  readonly #store: Store<State>
  readonly #size: () => Size
  readonly #padding: () => Padding
  #gesture = 0

  constructor(store: Store<State>, size: () => Size, padding: () => Padding) {
    this.#store = store
    this.#size = size
    this.#padding = padding
  }

  /** A number for the edits of one gesture: they become one step of the history. */
  beginGesture(): number {
    this.#gesture += 1
    return this.#gesture
  }

  async load(id: string): Promise<void> {
    const dataSet = DATA_SETS.find((candidate) => candidate.id === id)
    if (dataSet === undefined) return
    try {
      const circles = await dataSet.load()
      this.#store.update((state) => loaded(state, id, circles))
      this.fit()
    } catch (error) {
      this.#store.update((state) => ({ ...state, problem: (error as Error).message }))
    }
  }

  setCircle(index: number, x: number, y: number, r: number, gesture = this.beginGesture()): void {
    this.#store.update((state) => edited(state, replaceCircle(state.circles, index, x, y, r), gesture))
  }

  /** Adds a circle and selects it. */
  add(center: Point, r: number, gesture = this.beginGesture()): void {
    this.#store.update((state) => ({
      ...edited(state, appendCircle(state.circles, center.x, center.y, r), gesture),
      isAdding: false,
    }))
  }

  /** Adds a circle that leaves some room to the nearest other one. */
  addFitting(center: Point): void {
    const { circles, camera } = this.#store.get()
    const usual = 24 / camera.scale
    let room = usual * 2
    for (let i = 0; i < circles.length; i += 3) {
      const distance = Math.hypot(center.x - at(circles, i), center.y - at(circles, i + 1)) - at(circles, i + 2)
      if (distance > 0) room = Math.min(room, distance)
    }
    this.add(center, Math.min(usual, room / 2))
  }

  toggleAdding(): void {
    this.#store.update((state) => ({ ...state, isAdding: !state.isAdding }))
  }

  removeSelected(): void {
    const { selected } = this.#store.get()
    if (selected === NOBODY) return
    const gesture = this.beginGesture()
    this.#store.update((state) => edited(state, removeCircle(state.circles, selected), gesture))
  }

  moveSelected(dx: number, dy: number, gesture: number): void {
    const { selected } = this.#store.get()
    const circle = selectedCircle(this.#store.get())
    if (circle !== undefined) this.setCircle(selected, circle.x + dx, circle.y + dy, circle.r, gesture)
  }

  /** The radius does not go below zero. */
  growSelected(dr: number, gesture: number): void {
    const { selected } = this.#store.get()
    const circle = selectedCircle(this.#store.get())
    if (circle !== undefined) this.setCircle(selected, circle.x, circle.y, Math.max(circle.r + dr, 0), gesture)
  }

  select(circle: number): void {
    this.#store.update((state) => (state.selected === circle ? state : { ...state, selected: circle, problem: '' }))
  }

  /** Selects the circle whose centre is nearest to the middle of the canvas. */
  selectNearMiddle(): void {
    const { circles, camera } = this.#store.get()
    let nearest = NOBODY
    let least = Number.POSITIVE_INFINITY
    for (let i = 0; i < circles.length / 3; i++) {
      const distance = Math.hypot(camera.x - at(circles, 3 * i), camera.y - at(circles, 3 * i + 1))
      if (distance < least) {
        nearest = i
        least = distance
      }
    }
    this.select(nearest)
  }

  /** Selects the next circle in input order, or the one before; reports whether there is one. */
  selectNext(step: 1 | -1): boolean {
    const state = this.#store.get()
    const next = state.selected + step
    if (next < 0 || next >= circleCount(state)) return false
    this.select(next)
    return true
  }

  hover(circle: number): void {
    this.#store.update((state) => (state.hovered === circle ? state : { ...state, hovered: circle }))
  }

  /** Gives up what is going on: adding, or else the selection. */
  release(): void {
    this.#store.update((state) => (state.isAdding ? { ...state, isAdding: false } : { ...state, selected: NOBODY }))
  }

  undo(): void {
    this.#store.update(undone)
  }

  redo(): void {
    this.#store.update(redone)
  }

  pan(dx: number, dy: number): void {
    this.#setCamera(({ camera }) => panned(camera, dx, dy))
  }

  /** `anchor`: the pixel whose point stays where it is. */
  zoom(factor: number, anchor: Point): void {
    this.#setCamera((state) => {
      const whole = this.#fittedCamera(state).scale
      const scale = Math.min(Math.max(state.camera.scale * factor, whole * SMALLEST_ZOOM), whole * LARGEST_ZOOM)
      return zoomed(state.camera, this.#size(), anchor, scale / state.camera.scale)
    })
  }

  zoomAtMiddle(factor: number): void {
    const { width, height } = this.#size()
    this.zoom(factor, { x: width / 2, y: height / 2 })
  }

  fit(): void {
    this.#setCamera((state) => this.#fittedCamera(state))
  }

  #fittedCamera({ circles }: State): Camera {
    return fitted(boundingBox(circles), this.#size(), this.#padding())
  }

  #setCamera(camera: (state: State) => Camera): void {
    this.#store.update((state) => ({ ...state, camera: camera(state) }))
  }
}
