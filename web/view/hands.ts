// SPDX-License-Identifier: GPL-3.0-or-later
import { NewestQueue } from '../lib/base/newest-queue.ts'
import type { Box, Circle, Edit, Point } from '../lib/index.ts'
import { zoomed } from './camera.ts'
import type { Hands, Held } from './gestures.ts'
import type { View } from './view.ts'

/** The radius of a circle that is added, in pixels. */
const USUAL_RADIUS = 24

/** What the gestures do to a view that has no client with a history of its own. */
export class PlainHands implements Hands {
  readonly tool = 'select'
  readonly snaps = false
  readonly #view: View
  readonly #isEditable: boolean
  #lastGesture = 0
  /** Where the circles of the gesture that goes on were before. */
  #before = new Map<number, Circle>()
  readonly #queue = new NewestQueue<readonly Edit[], void>()
  #selected: number | undefined

  constructor(view: View, isEditable: boolean) {
    this.#view = view
    this.#isEditable = isEditable
  }

  circle(id: number): Circle | undefined {
    return this.#isEditable ? this.#view.circles.get(id) : undefined
  }

  beginGesture(): number {
    this.#before = new Map()
    this.#lastGesture += 1
    return this.#lastGesture
  }

  held(): readonly Held[] {
    const circle = this.#selected === undefined ? undefined : this.circle(this.#selected)
    return circle === undefined ? [] : [{ id: this.#selected as number, circle }]
  }

  isSelected(id: number): boolean {
    return id === this.#selected
  }

  /** One at most. */
  select([id]: readonly number[]): void {
    this.#selected = id
    this.#view.mark(id, undefined)
  }

  toggle(id: number): void {
    this.select(this.isSelected(id) ? [] : [id])
  }

  selectWithin(_: Box): void {}

  hover(id: number | undefined): void {
    this.#view.mark(this.#selected, id)
  }

  set(circles: readonly Held[], gesture: number): void {
    if (gesture !== this.#lastGesture) return
    for (const { id } of circles) {
      const before = this.#view.circles.get(id)
      if (before !== undefined && !this.#before.has(id)) this.#before.set(id, before)
    }
    const there = circles.filter(({ id }) => this.#view.circles.get(id) !== undefined)
    this.#edit(there.map(({ id, circle }) => ({ kind: 'replace', id, circle })))
  }

  snapped(circle: Circle): Circle {
    return circle
  }

  async add(circles: readonly Circle[]): Promise<readonly number[]> {
    if (!this.#isEditable) return []
    // What is refused is told as an event.
    const edited = await this.#view.apply(circles.map((circle) => ({ kind: 'insert', circle }))).catch(() => undefined)
    return [...(edited?.inserted ?? [])]
  }

  async fitted({ x, y }: Point): Promise<Circle | undefined> {
    return this.#isEditable ? { x, y, r: USUAL_RADIUS / this.#view.camera.scale } : undefined
  }

  async addFitting(center: Point): Promise<void> {
    const circle = await this.fitted(center)
    if (circle !== undefined) await this.add([circle])
  }

  cancel(gesture: number): void {
    if (gesture !== this.#lastGesture) return
    this.#edit([...this.#before].map(([id, circle]) => ({ kind: 'replace', id, circle })))
    this.beginGesture()
  }

  zoom(factor: number, anchor: Point): void {
    this.#view.setCamera(zoomed(this.#view.camera, this.#view.size, anchor, factor))
  }

  /** One at a time; of those that wait, the last. */
  #edit(edits: readonly Edit[]): void {
    if (edits.length === 0) return
    this.#queue.add(edits, 'edit')
    // What is refused leaves all as it was.
    this.#queue.drain((next) => this.#view.apply(next).then(NOTHING, NOTHING))
  }
}

const NOTHING = () => {}
