// SPDX-License-Identifier: GPL-3.0-or-later
import { isNumeric, numbersIn } from '../editing/attributes.ts'
import type { Editing } from '../editing/editing.ts'
import type { FigureActions } from '../editing/figure-actions.ts'
import type { Circle, Edit, Lattice, Point } from '../lib/index.ts'
import type { Areas, Domain } from '../view/domain.ts'
import type { Edited } from '../view/scene-client.ts'
import { boxAround } from './box-around.ts'

/** The region, the areas and the periods of the circles. */
export class DomainActions {
  readonly #editing: Editing
  readonly #actions: FigureActions

  constructor(editing: Editing, actions: FigureActions) {
    this.#editing = editing
    this.#actions = actions
  }

  /** Like `CircleActions.setDomain`, with its progress. */
  async setDomain(change: Partial<Domain>, gesture?: number, edits: readonly Edit[] = []): Promise<Edited | undefined> {
    const { count } = this.#editing.circles
    // Cells are cut to a region, or they repeat in a box.
    const isOther = change.region !== undefined && this.#editing.domain.lattice !== undefined
    const { areas, region } = { ...this.#editing.domain, ...change }
    this.#actions.opening.onstage(
      areas !== undefined ? 'fitting' : region !== undefined ? 'clipping' : 'repeating',
      count,
    )
    try {
      return await this.#actions.circles.setDomain(isOther ? { lattice: undefined, ...change } : change, gesture, edits)
    } finally {
      this.#actions.opening.onstage('opened', count)
    }
  }

  /** Prescribes areas; `undefined` restores the former radii. */
  async setAreas(areas: Areas | undefined, gesture?: number): Promise<Edited | undefined> {
    const { circles, domain } = this.#editing
    const known: number[] = []
    for (const id of circles.ids()) known[id] = (circles.get(id) as Circle).r
    const radii = domain.areas === undefined ? known : domain.radii
    return this.setDomain({ areas, radii }, gesture, areas === undefined ? this.#withRadii() : [])
  }

  /** Edits that give circles the radii again that they had before areas. */
  #withRadii(move: Point = { x: 0, y: 0 }): Edit[] {
    const { circles } = this.#editing
    const radii = this.radii()
    return Array.from(circles.ids(), (id, k): Edit => {
      const { x, y } = circles.get(id) as Circle
      return { kind: 'replace', id, circle: { x: x + move.x, y: y + move.y, r: radii[k] as number } }
    })
  }

  /** Makes the circles periodic in a box around them with a corner at the origin. Moves them there if necessary. */
  async repeat(): Promise<void> {
    const { circles } = this.#editing
    const { lattice, move } = boxAround(circles.box(), circles.count)
    await this.setLattice(lattice, move)
  }

  /** Sets or removes the periods after moving the circles. Periodic cells are whole, so a region is removed. */
  async setLattice(lattice: Lattice | undefined, move: Point = { x: 0, y: 0 }): Promise<void> {
    const { areas } = this.#editing.domain
    const isMoved = move.x !== 0 || move.y !== 0
    const edits = lattice !== undefined && (isMoved || areas !== undefined) ? this.#withRadii(move) : []
    const change = lattice === undefined ? { lattice } : { lattice, region: undefined, areas: undefined }
    const edited = await this.setDomain(change, undefined, edits)
    if (edited !== undefined && lattice !== undefined) this.#actions.camera.showView(undefined)
  }

  /** The names of numeric columns. */
  get columns(): readonly string[] {
    return this.#editing.attributes.columns.filter(isNumeric).map(({ name }) => name)
  }

  /**
   * Prescribes areas by a column. Circles without a number get the mean. Resolves to how many got the mean, or to
   * `undefined` if refused.
   */
  async setAreasBy(column: string): Promise<number | undefined> {
    const { circles } = this.#editing
    const values = numbersIn(this.#editing.attributes, column, circles)
    const wrong = values.findIndex((value) => value <= 0)
    if (wrong >= 0) {
      this.#actions.messages.complain(
        `${column}: circle ${circles.ids()[wrong]} has ${values[wrong]}. Areas need numbers above 0.`,
      )
      return undefined
    }
    const known = values.filter((value) => value > 0)
    const mean = known.reduce((sum, value) => sum + value, 0) / known.length
    const edited = await this.setAreas(Array.from(values, (value) => (value > 0 ? value : mean)))
    return edited && values.length - known.length
  }

  /** The radii of the circles, or their radii before areas were prescribed. */
  radii(): number[] {
    const { circles, domain } = this.#editing
    return Array.from(circles.ids(), (id) => {
      const known = domain.areas === undefined ? undefined : domain.radii?.[id]
      return known ?? (circles.get(id) as Circle).r
    })
  }

  /** Removes the region and restores the radii. */
  async removeRegion(): Promise<void> {
    const gesture = this.#editing.beginGesture()
    if (this.#editing.domain.areas !== undefined) await this.setAreas(undefined, gesture)
    await this.setDomain({ region: undefined }, gesture)
  }

  /** Sets a cell's share of the region, between 0 and 1. The other cells keep their proportions. */
  async setShare(id: number, share: number, gesture?: number): Promise<void> {
    const { circles, areas } = this.#editing
    const list = Array.isArray(areas) ? [...areas] : Array<number>(circles.count).fill(1)
    const k = circles.countBelow(id)
    const others = list.reduce((sum, area, i) => (i === k ? sum : sum + area), 0)
    list[k] = (share / (1 - share)) * others
    await this.setDomain({ areas: list }, gesture)
  }

  /** The prescribed share of a circle's cell. */
  shareOf(id: number): number | undefined {
    const { circles, areas } = this.#editing
    if (areas === undefined) return undefined
    if (areas === 'equal') return 1 / circles.count
    return (areas[circles.countBelow(id)] as number) / areas.reduce((sum, area) => sum + area, 0)
  }
}
