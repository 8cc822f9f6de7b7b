// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle, Edit, Point } from '../lib/index.ts'
import { zoomed } from './camera.ts'
import type { Hands } from './pointer.ts'
import type { View } from './view.ts'

/** The radius of a circle that is added, in pixels. */
const USUAL_RADIUS = 24

/** What the gestures do to a view that has no client with a history of its own. */
export class PlainHands implements Hands {
  readonly isAdding = false
  readonly #view: View
  readonly #isEditable: boolean
  #lastGesture = 0
  /** Where the circles of the gesture that goes on were before. */
  #before = new Map<number, Circle>()
  #isBusy = false
  #next: Edit | undefined
  #selected: number | undefined

  constructor(view: View, isEditable: boolean) {
    this.#view = view
    this.#isEditable = isEditable
  }

  circle(id: number): Circle | undefined {
    return this.#isEditable ? this.#view.circle(id) : undefined
  }

  beginGesture(): number {
    this.#before = new Map()
    this.#lastGesture += 1
    return this.#lastGesture
  }

  select(id: number | undefined): void {
    this.#selected = id
    this.#view.mark(id, undefined)
  }

  hover(id: number | undefined): void {
    this.#view.mark(this.#selected, id)
  }

  set(id: number, circle: Circle, gesture: number): void {
    const before = this.#view.circle(id)
    if (gesture !== this.#lastGesture || before === undefined) return
    if (!this.#before.has(id)) this.#before.set(id, before)
    this.#edit({ kind: 'replace', id, circle })
  }

  async add(circle: Circle): Promise<number | undefined> {
    if (!this.#isEditable) return undefined
    return (await this.#view.apply([{ kind: 'insert', circle }])).inserted[0]
  }

  async addFitting({ x, y }: Point): Promise<void> {
    await this.add({ x, y, r: USUAL_RADIUS / this.#view.camera.scale })
  }

  cancel(gesture: number): void {
    if (gesture !== this.#lastGesture) return
    for (const [id, circle] of this.#before) this.#edit({ kind: 'replace', id, circle })
    this.beginGesture()
  }

  zoom(factor: number, anchor: Point): void {
    this.#view.setCamera(zoomed(this.#view.camera, this.#view.size, anchor, factor))
  }

  /** One at a time; of those that wait, the last. */
  async #edit(edit: Edit): Promise<void> {
    this.#next = edit
    if (this.#isBusy) return
    this.#isBusy = true
    while (this.#next !== undefined) {
      const next = this.#next
      this.#next = undefined
      // What is refused leaves all as it was.
      await this.#view.apply([next]).catch(() => {})
    }
    this.#isBusy = false
  }
}
