// SPDX-License-Identifier: GPL-3.0-or-later

import { ARROWS } from '../editing/keyboard.ts'
import type { State } from '../editing/state.ts'
import type { Pen } from '../editing/tools.ts'
import type { Point } from '../lib/index.ts'
import { isDissolved, type RegionShape } from '../lib/regions/region-shape.ts'
import { ringsOf } from '../view/domain.ts'
import type { Store } from '../view/store.ts'
import type { View } from '../view/view.ts'
import type { PageActions } from './page-actions.ts'

/**
 * Draws a polygon, corner by corner, with the tool `draw`. The closed polygon becomes part of the region: a hole if it
 * lies inside, otherwise another polygon. If the region's polygons are merged, it is merged, too. An invalid polygon
 * stays for correction.
 */
export class RegionPen implements Pen {
  readonly #store: Store<State>
  readonly #actions: PageActions
  readonly #view: View
  #corners: Point[] = []
  /** The place of the next corner. */
  #next: Point | undefined

  constructor(store: Store<State>, actions: PageActions, view: View) {
    this.#store = store
    this.#actions = actions
    this.#view = view
    store.subscribe(({ tool }) => {
      if (tool !== 'draw' && (this.#next !== undefined || this.#corners.length > 0)) this.#clear()
    })
  }

  /** The number of corners. */
  get count(): number {
    return this.#corners.length
  }

  /**
   * Handles the keys of the tool: arrows move the next corner, Space places it, Backspace removes the last one, and
   * Enter closes the polygon.
   */
  key(key: string, step: number): boolean {
    const arrow = ARROWS[key]
    const { x, y } = this.#next ?? this.#corners.at(-1) ?? this.#view.camera
    if (arrow !== undefined) this.move({ x: x + arrow[0] * step, y: y + arrow[1] * step })
    else if (key === ' ') this.place({ x, y }, 0)
    else if (key === 'Enter') this.close()
    else if (key === 'Backspace' || key === 'Delete') this.undo()
    else return false
    return true
  }

  /** Removes the last corner. Returns false if there is none. */
  undo(): boolean {
    if (this.#corners.pop() === undefined) return false
    this.#changed()
    return true
  }

  /** Adds the polygon to the region. */
  async close(): Promise<void> {
    if (this.#corners.length < 3) {
      this.#actions.messages.complain('A polygon needs three corners or more.')
      return
    }
    const ring = this.#corners.map(({ x, y }) => [x, y] as const)
    const { region } = this.#store.get().domain
    const edited = await this.#actions.domain.setDomain({ region: withRing(region, ring) })
    if (edited !== undefined) this.#actions.tools.useTool('select')
  }

  move(point: Point): void {
    this.#next = point
    this.#draw()
  }

  place(point: Point, within: number): void {
    const [first, last] = [this.#corners[0], this.#corners.at(-1)]
    if (first !== undefined && this.#corners.length > 2 && distance(first, point) <= within) {
      this.close()
      return
    }
    this.#next = undefined
    // A double click consists of two presses.
    if (last === undefined || distance(last, point) > within / 2) this.#corners.push(point)
    this.#changed()
  }

  #changed(): void {
    const { length } = this.#corners
    const text = length === 1 ? '1 corner' : `${length} corners`
    this.#store.update((state) => ({ ...state, problem: '', said: { text } }))
    this.#draw()
  }

  #clear(): void {
    this.#corners = []
    this.#next = undefined
    this.#draw()
  }

  #draw(): void {
    const points = this.#next === undefined ? this.#corners : [...this.#corners, this.#next]
    this.#view.sketch = points.length === 0 ? undefined : Float64Array.from(points.flatMap(({ x, y }) => [x, y]))
  }
}

function distance(one: Point, other: Point): number {
  return Math.hypot(one.x - other.x, one.y - other.y)
}

/** The region with another ring. If its polygons are merged, the ring is a polygon of its own. */
function withRing(region: RegionShape | undefined, ring: readonly (readonly [x: number, y: number])[]): RegionShape {
  if (region === undefined || !isDissolved(region)) return [...ringsOf(region), ring]
  const { coordinates } = region as Extract<RegionShape, { type: 'MultiPolygon' }>
  return { type: 'MultiPolygon', coordinates: [...coordinates, [ring]], dissolve: true }
}
