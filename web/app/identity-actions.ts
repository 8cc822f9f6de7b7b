// SPDX-License-Identifier: GPL-3.0-or-later
import { textIn, valueIn } from '../editing/attributes.ts'
import type { Editing } from '../editing/editing.ts'
import { COLOR, colorColumn, isColor, NAME, nameColumn, nameIn } from '../editing/identity.ts'

/** The names and the colors of circles. */
export class IdentityActions {
  readonly #editing: Editing

  constructor(editing: Editing) {
    this.#editing = editing
  }

  /** The name of a circle, or an empty text. */
  nameOf(id: number): string {
    return nameIn(this.#editing.attributes, id)
  }

  /** Names a circle; an empty text removes its name. */
  async setName(id: number, name: string): Promise<void> {
    const column = nameColumn(this.#editing.attributes.columns)?.name ?? NAME
    await this.#editing.setValues(column, new Map([[id, name === '' ? '' : JSON.stringify(name)]]))
  }

  /** Gives circles a CSS color of their own; `undefined` removes it. */
  async setColor(ids: readonly number[], color: string | undefined, gesture?: number): Promise<void> {
    const column = colorColumn(this.#editing.attributes.columns)?.name ?? COLOR
    const value = color === undefined ? '' : JSON.stringify(color)
    await this.#editing.setValues(column, new Map(ids.map((id) => [id, value])), gesture)
  }

  /** The CSS color of its own that a circle has. */
  ownColorOf(id: number): string | undefined {
    const color = textIn(
      valueIn(this.#editing.attributes, colorColumn(this.#editing.attributes.columns)?.name ?? COLOR, id),
    )
    return isColor(color) ? color : undefined
  }
}
