// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../lib/base/diagram-data.ts'
import type { Change, Diagram, Edit } from '../../lib/index.ts'
import type { CircleVoronoi } from '../../lib/wasm/library.ts'
import { idOf } from './cell-boxes.ts'
import { type Difference, type FollowingPicture, Picture } from './picture.ts'

/** The Voronoi diagram of the circles' centers, kept up to date by an editor of points. */
export class Centers implements FollowingPicture {
  readonly picture: Picture
  /** Maps each circle's id to the id of its center. */
  readonly #ids = new Map<number, number>()

  constructor(library: CircleVoronoi, diagram: Diagram) {
    this.picture = new Picture(library.edit(diagram.circles.map((value, k) => (k % 3 === 2 ? 0 : value))))
    for (let i = 0; i < diagram.circles.length / 3; i++) this.#ids.set(idOf(diagram, i), i)
  }

  apply({ removed, replaced, inserted, circles }: Change): Difference {
    const idOf = (id: number) => this.#ids.get(id) as number
    const circleAt = (k: number) => ({ x: at(circles, 3 * k), y: at(circles, 3 * k + 1), r: 0 })
    const edits: Edit[] = [
      ...Array.from(removed, (id): Edit => ({ kind: 'remove', id: idOf(id) })),
      ...Array.from(
        replaced,
        (id, k): Edit => ({ kind: 'replace', id: idOf(id), circle: circleAt(inserted.length + k) }),
      ),
      ...Array.from(inserted, (_, k): Edit => ({ kind: 'insert', circle: circleAt(k) })),
    ]
    const change = this.picture.editor.apply(edits)
    for (const id of removed) this.#ids.delete(id)
    inserted.forEach((id, k) => {
      this.#ids.set(id, at(change.inserted, k))
    })
    return this.picture.apply(change)
  }

  dispose(): void {
    this.picture.editor.dispose()
  }
}
