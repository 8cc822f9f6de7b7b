// SPDX-License-Identifier: GPL-3.0-or-later

import type { CircleLike } from '../base/coordinates.ts'
import type { Certificate, Circle, Disposal, Int32s } from '../base/types.ts'
import type { Change } from '../diagram/change.ts'
import type { Diagram } from '../diagram/diagram.ts'
import type { Edit } from '../wasm/editor.ts'

/** What an editor in a worker does. */
export interface AsyncEditorMethods {
  /** Called with each change, in their order, before its promise is fulfilled. */
  onchange: ((change: Change) => void) | undefined
  /** As `insert` of an editor. */
  insert(circle: CircleLike, hint?: number): Promise<Change>
  /** As `remove`. */
  remove(id: number): Promise<Change>
  /**
   * As `replace`. Where a circle is to be replaced again, or removed, before the first has begun, only the last is done, and all
   * of these promises get its change: so a drag is never behind by more than what is under way.
   */
  replace(id: number, circle: CircleLike): Promise<Change>
  /** As `apply`. */
  apply(edits: Iterable<Edit>): Promise<Change>
  /** As `nearest`. */
  nearest(x: number, y: number, hint?: number): Promise<number>
  /** As `size`. */
  size(): Promise<number>
  /** As `circle`. */
  circle(id: number): Promise<Circle | undefined>
  /** As `isHidden`. */
  isHidden(id: number): Promise<boolean>
  /** As `ids`. */
  ids(): Promise<Int32s>
  /** As `snapshot`: here, and for `Diagram.apply` of the changes that come after. */
  snapshot(): Promise<Diagram>
  /** As `certificate`. */
  certificate(): Promise<Certificate>
  /** Ends its thread, and rejects what has not been answered. */
  dispose(): void
}

/**
 * A `DiagramEditor` in a thread of its own. What is asked is answered in order, but for replacements that are merged. Errors are
 * those of `DiagramEditor`, or a `DOMException` named AbortError if it is disposed of; each as a rejection.
 */
export type AsyncDiagramEditor = AsyncEditorMethods & Disposal
