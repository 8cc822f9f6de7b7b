// SPDX-License-Identifier: GPL-3.0-or-later

import type { Circle, Edit, Point } from '../lib/index.ts'
import { plainRegion } from '../lib/regions/region-shape.ts'
import { gridSpacing } from '../view/axes.ts'
import type { Domain } from '../view/domain.ts'
import { roundStep } from '../view/round-step.ts'
import type { Edited } from '../view/scene-client.ts'
import { short } from '../view/short.ts'
import { type IdentifiedCircle, middleOf, scaled, snappedInPlace, snappedInSize, stepped } from './arranging.ts'
import { USUAL_RADIUS } from './camera-actions.ts'
import type { FigureParts, SharedActions } from './figure-actions.ts'

/** Offset of a copy from its original, in pixels. */
const ASIDE = 16

/** Adding, changing and removing circles. */
export class CircleActions {
  readonly #figure: FigureParts
  readonly #actions: SharedActions
  /** Whether the circles can be selected but not edited. */
  isReadonly = false
  #pending: Promise<unknown> | undefined

  constructor(figure: FigureParts, actions: SharedActions) {
    this.#figure = figure
    this.#actions = actions
  }

  circle(id: number): Circle | undefined {
    return this.isReadonly ? undefined : this.#figure.editing.circles.get(id)
  }

  beginGesture(): number {
    return this.#figure.editing.beginGesture()
  }

  /** The selected circles, with pending edits applied. */
  selectedCircles(): IdentifiedCircle[] {
    if (this.isReadonly) return []
    return this.#figure.store.get().selection.flatMap((id) => {
      const circle = this.#figure.editing.latest(id)
      return circle === undefined ? [] : [{ id, circle }]
    })
  }

  set(changes: readonly IdentifiedCircle[], gesture = this.beginGesture()): void {
    this.#figure.editing.replace(changes, gesture)
  }

  /**
   * Changes the region or the areas (in the order of the circles), and edits circles, in one undo step. Resolves to
   * `undefined` if refused.
   * @throws CircleVoronoiError `badOption` if the region is invalid
   */
  setDomain(change: Partial<Domain>, gesture?: number, edits: readonly Edit[] = []): Promise<Edited | undefined> {
    const { region } = change
    const plain = region === undefined ? change : { ...change, region: plainRegion(region) }
    return this.#figure.editing.edit(edits, gesture, plain)
  }

  /** Applies all edits or none as one undo step. Resolves to `undefined` if refused. */
  edit(edits: readonly Edit[]): Promise<Edited | undefined> {
    return this.#figure.editing.edit(edits)
  }

  /** Adds circles and selects them. Returns their ids, or none if they were refused. */
  add(circles: readonly Circle[], gesture = this.beginGesture()): Promise<readonly number[]> {
    return this.#selecting(() => this.#add(circles, gesture))
  }

  async #add(circles: readonly Circle[], gesture: number): Promise<readonly number[]> {
    if (this.isReadonly) return []
    const edited = await this.#figure.editing.edit(
      circles.map((circle) => ({ kind: 'insert', circle })),
      gesture,
    )
    if (edited === undefined) return []
    const ids = [...edited.inserted]
    this.#actions.selection.select(ids)
    this.#actions.messages.say(
      ids.length === 1
        ? this.#actions.messages.words.added(this.#actions.messages.called(ids[0] as number))
        : this.#actions.messages.words.addedMany(ids.length),
    )
    return ids
  }

  async addFitting(center: Point): Promise<void> {
    const circle = this.fitted(center)
    if (circle !== undefined) await this.add([circle])
  }

  /** Adds a circle where there is room for it, as near as possible to the middle of the view. */
  async addInRoom(): Promise<void> {
    if (this.isReadonly) return
    const gesture = this.beginGesture()
    const { x, y, scale } = this.#figure.view.camera
    const usual = USUAL_RADIUS / scale
    const room = await this.#figure.view.scene.ask('room', [x, y])
    const circle = room === undefined ? { x, y, r: usual } : { ...room, r: Math.min(room.r, usual) }
    const ids = await this.add([circle], gesture)
    if (ids[0] !== undefined) this.#actions.camera.revealCircle(ids[0])
  }

  /** A new circle at a point, with some room to the nearest circle; `undefined` where none fits. */
  fitted({ x, y }: Point): Circle | undefined {
    if (this.isReadonly) return undefined
    const usual = USUAL_RADIUS / this.#figure.view.camera.scale
    const nearest = this.#figure.view.hitAt({ x, y }, 0)
    const other = nearest === undefined ? undefined : this.circle(nearest.id)
    const room = other === undefined ? 2 * usual : Math.hypot(x - other.x, y - other.y) - other.r
    return { x, y, r: room > 0 ? Math.min(usual, room / 2) : usual }
  }

  /** Adds copies of the selected circles at an offset. */
  async duplicateSelected(): Promise<void> {
    const aside = roundStep(ASIDE / this.#figure.view.camera.scale)
    const circles = this.selectedCircles().map(({ circle: { x, y, r } }) => ({
      x: stepped(x, aside),
      y: stepped(y, -aside),
      r,
    }))
    const { length } = circles.length > 0 ? await this.add(circles) : []
    if (length > 0) this.#actions.messages.say(this.#actions.messages.words.duplicated(length))
  }

  /** Adds copies of circles: at an offset, or in the middle of the view if they are outside. */
  async paste(circles: readonly Circle[], times: number): Promise<void> {
    const { x, y } = middleOf(circles)
    const { camera } = this.#figure.view
    const aside = times * roundStep(ASIDE / camera.scale)
    const [dx, dy] = this.#actions.camera.shows({ x, y })
      ? [aside, -aside]
      : [camera.x + aside - x, camera.y - aside - y]
    await this.add(circles.map((circle) => ({ x: stepped(circle.x, dx), y: stepped(circle.y, dy), r: circle.r })))
  }

  async removeSelected(): Promise<void> {
    const ids = this.selectedCircles().map(({ id }) => id)
    if (ids.length === 0) return
    this.#actions.selection.select([])
    const edited = await this.#figure.editing.edit(ids.map((id) => ({ kind: 'remove', id })))
    if (edited === undefined) return
    this.#actions.messages.say(
      ids.length === 1
        ? this.#actions.messages.words.deleted(this.#actions.messages.called(ids[0] as number))
        : this.#actions.messages.words.deletedMany(ids.length),
    )
  }

  /** Moves the selected circles in steps that keep their coordinates short. */
  moveSelected(dx: number, dy: number, gesture: number): void {
    this.#changeSelected(({ x, y, r }) => ({ x: stepped(x, dx), y: stepped(y, dy), r }), gesture)
  }

  /** Changes a single radius by a step, not below zero, or scales several circles by a factor. */
  growSelected(dr: number, factor: number, gesture: number): void {
    const held = this.selectedCircles()
    if (held.length === 1) this.#changeSelected(({ x, y, r }) => ({ x, y, r: Math.max(stepped(r, dr), 0) }), gesture)
    else this.#scale(held, factor, gesture)
  }

  #scale(held: readonly IdentifiedCircle[], factor: number, gesture: number): void {
    const middle = middleOf(held.map(({ circle }) => circle))
    this.set(
      held.map(({ id, circle }) => ({ id, circle: scaled(circle, middle, factor) })),
      gesture,
    )
  }

  #changeSelected(change: (circle: Circle) => Circle, gesture: number): void {
    const changed = this.selectedCircles().map(({ id, circle }) => ({ id, circle: change(circle) }))
    this.set(changed, gesture)
    const [only, ...others] = changed
    if (only === undefined) return
    const { x, y, r } = only.circle
    const numbers = () =>
      this.#actions.messages.words.numbers(this.#actions.messages.called(only.id), short(x), short(y), short(r))
    this.#actions.messages.say(others.length === 0 ? numbers() : this.#actions.messages.words.moved(changed.length))
  }

  /**
   * Snaps a dragged circle to its neighbors or the grid if they are within a distance. `sizes` means that the drag
   * changes its radius.
   */
  snapped(circle: Circle, within: number, sizes: boolean): Circle {
    const grid = gridSpacing(this.#figure.view.camera.scale)
    // Circles on a visible grid always have its coordinates, and do not touch their neighbors instead.
    const snapping = this.#figure.view.layers.grid
      ? { others: [], grid, within: grid }
      : { others: this.#actions.selection.neighbors(), grid, within }
    return sizes ? snappedInSize(circle, snapping) : snappedInPlace(circle, snapping)
  }

  /** While a polygon is drawn, undo removes its last corner. */
  async undo(): Promise<void> {
    if (this.#actions.tools.tool === 'draw' && this.#actions.tools.pen?.undo() === true) return
    await this.#selecting(() => this.#goThroughHistory('undo'))
  }

  redo(): Promise<void> {
    return this.#selecting(() => this.#goThroughHistory('redo'))
  }

  /** Settles once all edits that select circles are done; `undefined` if none are pending. */
  get pending(): Promise<unknown> | undefined {
    return this.#pending
  }

  #selecting<Result>(edit: () => Promise<Result>): Promise<Result> {
    const edited = edit()
    const all = Promise.allSettled([this.#pending, edited]).then(() => {
      if (this.#pending === all) this.#pending = undefined
    })
    this.#pending = all
    return edited
  }

  async #goThroughHistory(step: 'undo' | 'redo'): Promise<void> {
    if (this.isReadonly) return
    const { editing } = this.#figure
    const { scene, domain } = editing
    const edited = await editing[step]()
    const ids = [...(edited?.inserted ?? [])]
    if (ids.length > 0) this.#actions.selection.select(ids)
    if (ids.length === 1) this.#actions.camera.revealCircle(ids[0] as number)
    // Circles that repeat have moved into their box, or back.
    if (editing.scene !== scene || editing.domain.lattice !== domain.lattice) this.#actions.camera.showView(undefined)
  }
}
