// SPDX-License-Identifier: GPL-3.0-or-later
import type { DiagramBackend } from '../../web/editing/editing.ts'
import type { Change, DiagramEditor } from '../../web/lib/index.ts'
import { loadRegions } from '../../web/lib/regions.ts'
import { CircleTable, type KeptIds, NO_CHANGE } from '../../web/view/circle-table.ts'
import { fitted } from '../../web/view/painter/fitted.ts'
import type { Computations, DomainChange } from '../../web/view/protocol.ts'
import { library } from './library.ts'

/** A backend for `Editing`: an editor of the library. Each request waits for `before`. */
export class LibraryBackend implements DiagramBackend {
  circles = new CircleTable(new Float64Array())
  editor: DiagramEditor = library.edit([])
  readonly #before: () => Promise<unknown>

  constructor(before: () => Promise<unknown>) {
    this.#before = before
  }

  async open(circles: Float64Array, { colors }: DomainChange = {}, kept?: KeptIds) {
    await this.#before()
    this.editor = library.edit(circles, kept)
    this.circles = new CircleTable(Float64Array.from(circles), 0, kept)
    return { ...this.#edited(), colors }
  }

  async edit(edits: Parameters<DiagramBackend['edit']>[0]) {
    await this.#before()
    return this.#edited(this.editor.apply(edits))
  }

  async ask(_: 'fit', args: Parameters<Computations['fit']>) {
    await this.#before()
    return fitted(await loadRegions(), ...args)
  }

  #edited(change: Pick<Change, keyof typeof NO_CHANGE> = NO_CHANGE) {
    const counts = { circles: this.editor.size(), hidden: 0, vertices: 0, edges: 0 }
    return { counts, inserted: change.inserted, back: this.circles.follow(change), seconds: 0 }
  }
}
