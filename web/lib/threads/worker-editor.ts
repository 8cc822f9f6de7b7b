// SPDX-License-Identifier: GPL-3.0-or-later

import type { CircleLike } from '../base/coordinates.ts'
import type { Certificate, Circle, Disposal, Int32s } from '../base/types.ts'
import type { Change } from '../diagram/change.ts'
import type { DiagramSnapshot } from '../diagram/diagram-snapshot.ts'
import type { Edit } from '../wasm/editor.ts'

/** The methods of an editor in a worker. */
export interface AsyncEditorMethods {
  /** A callback for each change, called in order, before the promise of the change is fulfilled. */
  onchange: ((change: Change) => void) | undefined
  /** Inserts a circle, as `insert` of `DiagramEditor` does. */
  insert(circle: CircleLike, hint?: number): Promise<Change>
  /** Removes a circle, as `remove` of `DiagramEditor` does. */
  remove(id: number): Promise<Change>
  /**
   * Moves or resizes a circle, as `replace` of `DiagramEditor` does. If a circle is replaced again or removed before a
   * pending replacement has begun, only the last request is carried out, and all promises get its change. This keeps a
   * drag at most one edit behind.
   */
  replace(id: number, circle: CircleLike): Promise<Change>
  /** Applies all edits or none, as `apply` of `DiagramEditor` does. */
  apply(edits: Iterable<Edit>): Promise<Change>
  /** Finds the nearest circle, as `nearest` of `DiagramEditor` does. */
  nearest(x: number, y: number, hint?: number): Promise<number>
  /** Returns the number of circles. */
  size(): Promise<number>
  /** Returns the circle with this id, or `undefined` if there is none. */
  circle(id: number): Promise<Circle | undefined>
  /** Returns whether a circle is hidden. */
  isHidden(id: number): Promise<boolean>
  /** Returns the ids of all circles in increasing order. */
  ids(): Promise<Int32s>
  /** Returns a copy of the current diagram in this thread. Its `apply` updates it with later changes. */
  snapshot(): Promise<DiagramSnapshot>
  /** Checks the whole diagram again in linear time. */
  certificate(): Promise<Certificate>
  /** Ends the thread of the editor and rejects all pending requests. */
  dispose(): void
}

/**
 * A `DiagramEditor` in a thread of its own. Requests are answered in order, except for replacements that are combined.
 * Promises are rejected with the errors of `DiagramEditor`, or with a `DOMException` named AbortError after `dispose`.
 */
export type AsyncDiagramEditor = AsyncEditorMethods & Disposal
