// SPDX-License-Identifier: GPL-3.0-or-later
import { type Attributes, columnIn } from '../editing/attributes.ts'
import type { Editing, Outcome } from '../editing/editing.ts'
import type { Layers } from '../view/layers.ts'
import type { View } from '../view/view.ts'
import { cellValues } from './cell-values.ts'
import type { Photo } from './files/files-protocol.ts'

/** The layers of a photo. */
const MOSAIC = { fullColor: true, circles: false, edges: false, vertices: false } as const

/** Colors by columns, and mosaics of photos. */
export class ColoringActions {
  readonly #editing: Editing
  readonly #view: View
  /** The photos of the session by the attributes of their circles, which undo brings back, too. */
  readonly photos = new WeakMap<Attributes, Photo>()
  /** The layers that the last photo replaced. */
  #beforeMosaic: Partial<Layers> = { fullColor: false, circles: true, edges: true, vertices: true }

  constructor(editing: Editing, view: View) {
    this.#editing = editing
    this.#view = view
  }

  /** Colors cells by a column; an unknown name ends coloring by column. */
  colorBy(name: string): void {
    const { circles, attributes } = this.#editing
    const column = columnIn(attributes, name)
    this.#view.setLayers({ column: column && cellValues(column, circles) })
  }

  /** Updates the colors after an edit, a change of values or an opening. Call with each outcome. */
  follow({ isOpened, hasNewAttributes }: Outcome): void {
    if (isOpened) this.#showMosaic(this.photos.has(this.#editing.attributes))
    const { column } = this.#view.layers
    if (column !== undefined && hasNewAttributes) this.colorBy(column.name)
  }

  /** Shows the circles of a photo as a mosaic, and others with the layers from before. */
  #showMosaic(isPhoto: boolean): void {
    const { fullColor, circles, edges, vertices } = this.#view.layers
    const isMosaic = fullColor && !circles && !edges && !vertices
    if (isPhoto === isMosaic) return
    if (isPhoto) this.#beforeMosaic = { fullColor, circles, edges, vertices }
    this.#view.setLayers(isPhoto ? MOSAIC : this.#beforeMosaic)
  }
}
