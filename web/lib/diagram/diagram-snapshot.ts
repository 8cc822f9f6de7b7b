// SPDX-License-Identifier: GPL-3.0-or-later
import { checkNumber, checkThing } from '../base/check.ts'
import type { SnapshotData, SnapshotNumbers } from '../base/types.ts'
import type { Change } from './change.ts'
import { Diagram } from './diagram.ts'
import { DiagramPatch } from './diagram-patch.ts'

/**
 * The diagram of an editor, which follows the changes of the editor. `new DiagramSnapshot(data)` restores the methods of
 * a structured clone.
 *
 * @category Editing
 * @example
 * const editor = library.edit([[0, 0, 1], [6, 0, 1], [0, 8, 1]])
 * const now = editor.snapshot()
 * const change = editor.remove(0)
 * now.apply(change).numbers.circles // Int32Array(2) [ 2, 1 ]
 * Array.from(change.cells, (id) => now.neighbors(now.indexOf(id)).length) // [ 1, 1 ]
 * new DiagramSnapshot(structuredClone(now)).indexOf(0) // -1
 */
export class DiagramSnapshot extends Diagram implements SnapshotData {
  declare readonly numbers: SnapshotNumbers
  #patch: DiagramPatch | undefined

  /** Wraps the arrays of `data` without copying them. */
  constructor(data: SnapshotData) {
    checkThing(data, 'numbers', 'new DiagramSnapshot', 'a snapshot of an editor')
    checkThing(data.numbers, 'revision', 'new DiagramSnapshot', 'the numbers of an editor')
    super(data)
    this.numbers = data.numbers
  }

  /**
   * Applies the next change of the editor, in time proportional to the change. Arrays are changed in place; an array
   * whose length changes is replaced. `cells` and the search structure of `find` stay valid. Indices have no gaps: when
   * a circle, vertex or edge is removed, the last one may take its index. Use `indexOf` to find the index of a circle
   * and `numbers.circles` for the ids. The `by` of a hidden circle is a circle that contains it, but not always the
   * largest.
   *
   * @throws CircleVoronoiError `badInput`, if a change has been left out
   */
  apply(change: Change): this {
    const patch = this.#patched()
    const changed = patch.apply(change)
    const arrays = patch.arrays()
    const counts = { ...this.stats.counts, circles: arrays.circles.length / 3, hidden: arrays.hidden.length / 2 }
    this.renew({ ...arrays, stats: { ...this.stats, counts } }, (finder) => finder.follow(changed))
    return this
  }

  /** Returns the index of the circle with this id, or `NONE` if there is none. */
  indexOf(id: number): number {
    checkNumber(id, 'indexOf', 'the id of a circle')
    return this.#patched().indexOf(id)
  }

  #patched(): DiagramPatch {
    this.#patch ??= new DiagramPatch(this, this.numbers)
    return this.#patch
  }
}
