// SPDX-License-Identifier: GPL-3.0-or-later

import { checkMetric, checkNumber, refuseArgument, shown } from '../base/check.ts'
import { COORDINATE_LIMIT } from '../base/coordinate-limits.ts'
import { type CircleLike, type Circles, circleRadius, circleX, circleY, coordinatesOf } from '../base/coordinates.ts'
import { NONE } from '../base/diagram-data.ts'
import { CircleVoronoiError, type ErrorCode } from '../base/errors.ts'
import type { Certificate, Circle, DiagramData, Disposal, Float64s, Int32s } from '../base/types.ts'
import type { Change } from '../diagram/change.ts'
import type { Diagram } from '../diagram/diagram.ts'

/**
 * One edit of a batch.
 *
 * @category Editing
 */
export type Edit =
  | { readonly kind: 'insert'; readonly circle: CircleLike }
  | { readonly kind: 'remove'; readonly id: number }
  | { readonly kind: 'replace'; readonly id: number; readonly circle: CircleLike }

/**
 * What an editor does.
 *
 * @category Editing
 */
export interface EditorMethods {
  /** Called with each change, before the method that made it returns. */
  onchange: ((change: Change) => void) | undefined
  /**
   * A new circle; its id is `inserted[0]` of the change. `hint`: a circle nearby, if one is known; what was edited last is one
   * anyway.
   *
   * @throws CircleVoronoiError as `compute`, `badArgument`
   */
  insert(circle: CircleLike, hint?: number): Change
  /** @throws CircleVoronoiError `unknownCircle`, `badArgument` */
  remove(id: number): Change
  /**
   * Moves or resizes a circle, or both.
   *
   * @throws CircleVoronoiError `unknownCircle`; as `compute`, `badArgument`
   */
  replace(id: number, circle: CircleLike): Change
  /**
   * All or none of the edits, one after the other: `{ kind: 'insert', circle }`, `{ kind: 'remove', id }`,
   * `{ kind: 'replace', id, circle }`. A circle that comes and goes in it is in no list of the change.
   *
   * @throws CircleVoronoiError as the methods above
   */
  apply(edits: Iterable<Edit>): Change
  /**
   * The circle of smallest signed distance, one of them up to rounding where several are. `NONE` if there are no circles, or a
   * coordinate is not finite.
   */
  nearest(x: number, y: number, hint?: number): number
  /** How many circles there are, hidden ones included. */
  size(): number
  /** A circle as it is now; `undefined` if there is none with this id. */
  circle(id: number): Circle | undefined
  /**
   * Whether a circle has no cell.
   *
   * @throws CircleVoronoiError `unknownCircle`
   */
  isHidden(id: number): boolean
  /** The ids of all circles, in increasing order. */
  ids(): Int32s
  /**
   * The diagram as it is now, its circles in the order of their ids: linear time. It stays as it is; `Diagram.apply` has it
   * follow the changes that come after, in the time that they take.
   */
  snapshot(): Diagram
  /** All judged once more: linear time. It is certified, as each edit was. */
  certificate(): Certificate
  /** Frees the memory. Whatever is asked afterwards is an error. */
  dispose(): void
}

/**
 * A certified Voronoi diagram whose circles come, go, move and grow.
 *
 * An edit changes what is around it and leaves the rest: microseconds, however many circles there are. It is certified by what
 * it changes before it is believed. One that is refused changes nothing. Circles have ids, from 0: one stays the same circle
 * through all edits, and is never given to another. A circle inside another is hidden, and has a cell again when that goes. The
 * diagram does not depend on the edits that led to it: it is that of `compute`.
 *
 * Errors have the id of the circle concerned as `circle`, -1 if it is new. `badArgument`, whatever is asked after `dispose`.
 *
 * It holds memory in WebAssembly: `dispose` frees it, as does `using`, or the garbage collector at some time.
 *
 * @example
 * ```js
 * const editor = library.edit([[0, 0, 1], [6, 0, 1], [0, 8, 1]])
 * const diagram = editor.snapshot()
 * editor.onchange = (change) => diagram.apply(change)
 * const [id] = editor.insert({ x: 3, y: 4, r: 1 }).inserted
 * editor.replace(id, { x: 3, y: 5, r: 2 })
 * diagram.cellPath(diagram.indexOf(id))
 * editor.remove(id)
 * editor.dispose()
 * ```
 *
 * @category Editing
 */
export type DiagramEditor = EditorMethods & Disposal

/**
 * A copy of the circles that are to be edited.
 *
 * @throws CircleVoronoiError `badInput`, `badArgument`
 */
export function editedCircles(circles: Circles | DiagramData): Float64s {
  if (!(typeof circles === 'object' && circles !== null && 'vertexCircles' in circles)) return coordinatesOf(circles)
  checkMetric(circles, 'edit', 'circles')
  if (circles.weights) refuseArgument('edit takes a diagram of circles, not of weights.')
  return coordinatesOf(circles.circles)
}

/** An edit that was checked, as plain data. */
export interface CheckedEdit {
  readonly kind: string
  readonly id?: number
  readonly circle?: Circle
}

/** @throws CircleVoronoiError as `apply`, but for ids that the editor does not know */
export function checkedEdits(edits: Iterable<Edit>): CheckedEdit[] {
  if (typeof (edits as Partial<Iterable<Edit>> | null | undefined)?.[Symbol.iterator] !== 'function') {
    refuseArgument(`apply takes a list of edits, not ${shown(edits)}.`)
  }
  return Array.from(edits, (edit) => {
    const { kind, id, circle }: { kind?: Edit['kind']; id?: number; circle?: CircleLike } = Object(edit)
    if (kind === 'insert') return { kind, circle: checkedCircle(circle as CircleLike, NONE) }
    if (kind !== 'remove' && kind !== 'replace') {
      refuseArgument(`An edit has a kind, insert, remove or replace, not ${shown(kind)}.`)
    }
    checkId(id, 'apply')
    return kind === 'remove' ? { kind, id } : { kind, id, circle: checkedCircle(circle as CircleLike, id) }
  })
}

/** Embind makes other numbers of what is no id. */
export function checkId(id: unknown, caller: string): asserts id is number {
  checkNumber(id, caller, 'the id of a circle')
  if (!Number.isInteger(id) || (id as number) < NONE || (id as number) >= 2 ** 31) {
    refuse('unknownCircle', -1, `There is no circle with id ${id}.`)
  }
}

/** @throws CircleVoronoiError `badInput`, and the codes of `compute`; by the id, where the core knows of places in a list */
export function checkedCircle(circle: CircleLike, id: number): Circle {
  const [x, y, r]: readonly unknown[] = [circleX(circle), circleY(circle), circleRadius(circle)]
  const who = id === NONE ? 'The new circle' : `Circle ${id}`
  if (typeof x !== 'number' || typeof y !== 'number' || typeof r !== 'number') {
    refuse('badInput', id, `${who} does not have three numbers x, y and r.`)
  }
  if (!Number.isFinite(x) || !Number.isFinite(y) || !Number.isFinite(r)) {
    refuse('nonFinite', id, `${who} has a number that is not finite.`)
  }
  if (r < 0) refuse('negativeRadius', id, `${who} has a negative radius.`)
  if (Math.max(Math.abs(x), Math.abs(y), r) > COORDINATE_LIMIT) {
    refuse('coordinateTooLarge', id, `${who} has a coordinate or a radius beyond 1e150.`)
  }
  return { x, y, r }
}

/** @throws CircleVoronoiError always */
export function refuse(code: ErrorCode, circle: number, message: string): never {
  throw new CircleVoronoiError(code, circle, message)
}
