// SPDX-License-Identifier: GPL-3.0-or-later
import type { Box, Circle, Point } from '../lib/index.ts'
import { boundingBox, type Camera, fitted, type Padding, panned, toScreen, zoomed } from '../view/camera.ts'
import type { Edited } from '../view/painter.ts'
import type { Hands } from '../view/pointer.ts'
import type { View } from '../view/view.ts'
import { DATA_SETS } from './data-sets.ts'
import type { Editing } from './editing.ts'
import type { State } from './state.ts'
import type { Store } from './store.ts'

/** How far one may zoom in from the picture without outliers, and out from the whole one. */
const LARGEST_ZOOM = 1e7
const SMALLEST_ZOOM = 0.05
/** The radius of a circle that is added with room around, in pixels. */
const USUAL_RADIUS = 24

/** All that a user can do. Input and panels call these; nothing else changes the state, but for what was computed. */
export class Actions implements Hands {
  readonly #store: Store<State>
  readonly #editing: Editing
  readonly #view: View
  readonly #padding: () => Padding
  #lastLoad = 0

  constructor(store: Store<State>, editing: Editing, view: View, padding: () => Padding) {
    this.#store = store
    this.#editing = editing
    this.#view = view
    this.#padding = padding
  }

  get isAdding(): boolean {
    return this.#store.get().isAdding
  }

  circle(id: number): Circle | undefined {
    return this.#editing.circles.get(id)
  }

  beginGesture(): number {
    return this.#editing.beginGesture()
  }

  async load(dataSetId: string): Promise<void> {
    const dataSet = DATA_SETS.find(({ id }) => id === dataSetId)
    if (dataSet === undefined) return
    this.#lastLoad += 1
    const load = this.#lastLoad
    try {
      const circles = await dataSet.load()
      // Another was chosen meanwhile.
      if (load !== this.#lastLoad) return
      this.#view.camera = fitted(boundingBox(circles), this.#view.size, this.#padding())
      const opened = await this.#editing.open(circles)
      if (opened !== undefined) this.#store.update((state) => ({ ...state, dataSet: dataSetId, isAdding: false }))
      this.select(undefined)
    } catch (error) {
      this.#store.update((state) => ({ ...state, problem: (error as Error).message }))
    }
  }

  set(id: number, circle: Circle, gesture = this.beginGesture()): void {
    // A drag may go on where the circle was removed by a key.
    if (this.#editing.latest(id) !== undefined) this.#editing.edit([{ kind: 'replace', id, circle }], gesture)
  }

  /** Adds a circle and selects it. */
  async add(circle: Circle, gesture = this.beginGesture()): Promise<number | undefined> {
    const edited = await this.#editing.edit([{ kind: 'insert', circle }], gesture)
    const id = edited?.inserted[0]
    this.#store.update((state) => ({ ...state, isAdding: false }))
    if (id !== undefined) this.select(id)
    return id
  }

  async addFitting({ x, y }: Point): Promise<void> {
    const usual = USUAL_RADIUS / this.#view.camera.scale
    const nearest = await this.#view.hit(x, y, 0)
    const other = nearest === undefined ? undefined : this.circle(nearest.id)
    const room = other === undefined ? 2 * usual : Math.hypot(x - other.x, y - other.y) - other.r
    await this.add({ x, y, r: room > 0 ? Math.min(usual, room / 2) : usual })
  }

  cancel(gesture: number): void {
    this.#editing.cancel(gesture)
  }

  toggleAdding(): void {
    this.#store.update((state) => ({ ...state, isAdding: !state.isAdding }))
  }

  removeSelected(): void {
    const { selected } = this.#store.get()
    if (selected === undefined) return
    this.select(undefined)
    this.#editing.edit([{ kind: 'remove', id: selected }])
  }

  moveSelected(dx: number, dy: number, gesture: number): void {
    this.#changeSelected(({ x, y, r }) => ({ x: x + dx, y: y + dy, r }), gesture)
  }

  /** The radius does not go below zero. */
  growSelected(dr: number, gesture: number): void {
    this.#changeSelected(({ x, y, r }) => ({ x, y, r: Math.max(r + dr, 0) }), gesture)
  }

  select(id: number | undefined): void {
    this.#store.update((state) =>
      state.selected === id
        ? state
        : {
            ...state,
            selected: id,
            circle: id === undefined ? undefined : this.circle(id),
            described: undefined,
            problem: '',
          },
    )
  }

  /** Selects a circle and has the view show it. */
  goTo(id: number): void {
    this.select(id)
    this.#reveal(id)
  }

  /** Selects the circle nearest to the middle of the view. */
  async selectNearMiddle(): Promise<void> {
    const { x, y } = this.#view.camera
    this.select((await this.#view.hit(x, y, 0))?.id)
  }

  /** Selects the next circle by number, or the one before; reports whether there is one. */
  selectNext(step: 1 | -1): boolean {
    const { selected } = this.#store.get()
    const next = selected === undefined ? undefined : this.#editing.circles.next(selected + step, step)
    if (next !== undefined) this.goTo(next)
    return next !== undefined
  }

  hover(id: number | undefined): void {
    this.#store.update((state) => (state.hovered === id ? state : { ...state, hovered: id }))
  }

  /** Gives up what is going on: adding, or else the selection. */
  release(): void {
    if (this.isAdding) this.toggleAdding()
    else this.select(undefined)
  }

  async undo(): Promise<void> {
    this.#selectWhatCame(await this.#editing.undo())
  }

  async redo(): Promise<void> {
    this.#selectWhatCame(await this.#editing.redo())
  }

  #selectWhatCame(edited: Edited | undefined): void {
    const id = edited?.inserted[0]
    if (id !== undefined) this.goTo(id)
  }

  pan(dx: number, dy: number): void {
    this.#view.camera = panned(this.#view.camera, dx, dy)
  }

  zoom(factor: number, anchor: Point): void {
    const { camera, size } = this.#view
    const whole = this.#fitted(this.#editing.circles.box()).scale
    const core = this.#fitted(this.#editing.circles.core()).scale
    const largest = Math.max(whole, core) * LARGEST_ZOOM
    const scale = Math.min(Math.max(camera.scale * factor, whole * SMALLEST_ZOOM), largest)
    this.#view.camera = zoomed(camera, size, anchor, scale / camera.scale)
  }

  zoomAtMiddle(factor: number): void {
    const { width, height } = this.#view.size
    this.zoom(factor, { x: width / 2, y: height / 2 })
  }

  /** Shows everything, or where everything is shown already, all but what lies far outside. */
  fit(): void {
    const { circles } = this.#editing
    const [whole, core] = [this.#fitted(circles.box()), this.#fitted(circles.core())]
    const { x, y, scale } = this.#view.camera
    this.#view.camera = x === whole.x && y === whole.y && scale === whole.scale ? core : whole
  }

  #fitted(box: Box): Camera {
    return fitted(box, this.#view.size, this.#padding())
  }

  /** Has the view show the centre of a circle, where it does not. */
  #reveal(id: number): void {
    const circle = this.circle(id)
    if (circle === undefined) return
    const { camera, size } = this.#view
    const { top, right, bottom, left } = this.#padding()
    const { x, y } = toScreen(camera, size, circle)
    const isShown = x >= left && x <= size.width - right && y >= top && y <= size.height - bottom
    if (!isShown) this.#view.camera = { ...camera, x: circle.x, y: circle.y }
  }

  #changeSelected(change: (circle: Circle) => Circle, gesture: number): void {
    const { selected } = this.#store.get()
    const circle = selected === undefined ? undefined : this.#editing.latest(selected)
    if (selected !== undefined && circle !== undefined) this.set(selected, change(circle), gesture)
  }
}
