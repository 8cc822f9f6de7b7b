// SPDX-License-Identifier: GPL-3.0-or-later

import {
  checkMemory,
  checkMetric,
  checkNumber,
  checkOptionNames,
  refuseInput,
  refuseOption,
  shown,
} from '../base/check.ts'
import { COORDINATE_LIMIT, COORDINATE_LIMIT_TEXT } from '../base/coordinate-limits.ts'
import {
  CIRCLE_NAMES,
  type CircleLike,
  type Circles,
  circleRadius,
  circleX,
  circleY,
  coordinatesOf,
} from '../base/coordinates.ts'
import { NONE } from '../base/diagram-data.ts'
import { CircleVoronoiError, type ErrorCode } from '../base/errors.ts'
import { missingNumber } from '../base/missing-number.ts'
import type { Certificate, Circle, DiagramData, Disposal, Float64s, Int32s } from '../base/types.ts'
import type { Change } from '../diagram/change.ts'
import type { DiagramSnapshot } from '../diagram/diagram-snapshot.ts'
import { checkWeights } from './options.ts'

/**
 * One edit of a batch.
 *
 * @category Editing
 */
export type Edit =
  | {
      readonly kind: 'insert'
      readonly circle: CircleLike
      /** The id of a circle that was removed before the batch. Default: a new id. */
      readonly id?: number | undefined
    }
  | { readonly kind: 'remove'; readonly id: number }
  | { readonly kind: 'replace'; readonly id: number; readonly circle: CircleLike }

/**
 * Options of an editor.
 *
 * @category Editing
 */
export interface EditorOptions {
  /**
   * Whether the radii are additive weights, which may be negative, as in `compute`. Default: the value of the diagram,
   * or false for circles.
   */
  readonly weights?: boolean | undefined
  /** The ids of the circles, in increasing order. Default: circle i gets the id i. */
  readonly ids?: Iterable<number> | undefined
  /**
   * The id of the first new circle. Lower ids that no circle has are those of removed circles, which can be inserted
   * again. Default: one more than the largest id.
   */
  readonly nextId?: number | undefined
}

/**
 * The methods of an editor.
 *
 * @category Editing
 */
export interface EditorMethods {
  /**
   * A callback for each change, called before the method that made the change returns. If the callback throws, the
   * error is reported as uncaught, and the change stays. The callback may call any method, also `dispose`. An edit
   * inside it calls the callback for its own change, so apply the first change to a snapshot before you edit. Another
   * callback is used from the next change on.
   */
  onchange: ((change: Change) => void) | undefined
  /**
   * Inserts a circle. Its id is `inserted[0]` of the change. `hint` is the id of a nearby circle, if you know one; by
   * default the search starts at the last edit.
   *
   * @throws CircleVoronoiError as `compute`, `badInput`
   */
  insert(circle: CircleLike, hint?: number): Change
  /**
   * Removes the circle with this id. A circle that it hid gets a cell, unless another circle contains it.
   *
   * @throws CircleVoronoiError `unknownCircle`, `badInput`
   */
  remove(id: number): Change
  /**
   * Moves or resizes a circle.
   *
   * @throws CircleVoronoiError `unknownCircle`; as `compute`, `badInput`
   */
  replace(id: number, circle: CircleLike): Change
  /**
   * Applies all edits in order, or no edit if one is invalid: `{ kind: 'insert', circle }`, `{ kind: 'remove', id }`,
   * `{ kind: 'replace', id, circle }`. A circle that is both inserted and removed appears in no list of the change. An
   * insertion with the `id` of a removed circle brings it back under this id.
   *
   * @throws CircleVoronoiError as the methods above
   */
  apply(edits: Iterable<Edit>): Change
  /**
   * Returns the circle with the smallest signed distance to (x, y). Ties up to rounding may go to any of the nearest
   * circles. Returns `NONE` if there are no circles or a coordinate is not finite.
   */
  nearest(x: number, y: number, hint?: number): number
  /** Returns the number of circles, including hidden ones. */
  size(): number
  /** Returns the circle with this id, or `undefined` if there is none. */
  circle(id: number): Circle | undefined
  /**
   * Returns whether a circle is hidden and has no cell.
   *
   * @throws CircleVoronoiError `unknownCircle`
   */
  isHidden(id: number): boolean
  /** Returns the ids of all circles in increasing order. */
  ids(): Int32s
  /**
   * Returns a copy of the current diagram in linear time, with its circles in the order of their ids. The copy does not
   * change by itself; its `apply` updates it with later changes, in time proportional to each change.
   */
  snapshot(): DiagramSnapshot
  /** Checks the whole diagram again in linear time. Each edit has already been certified. */
  certificate(): Certificate
  /** Frees the memory. Calling any method afterwards throws. */
  dispose(): void
}

/**
 * Maintains a certified Voronoi diagram while circles are inserted, removed, moved and resized.
 *
 * An edit changes only its surroundings and takes microseconds, regardless of the number of circles. Each edit is
 * certified by checking the parts that it changed. An edit that is refused changes nothing. Circles have ids, counted
 * from 0; an id stays with its circle and is never reused for another one. `apply` brings a removed circle back under
 * its id. A circle inside another circle is hidden. It gets a cell again when the outer circle is removed. The diagram
 * does not depend on the edits that led to it: it equals the result of `compute`.
 *
 * Errors contain the id of the circle as `circle`, or `undefined` for a new circle. After `dispose`, every method
 * throws `badInput`.
 *
 * The editor holds WebAssembly memory. `dispose` or `using` frees it; otherwise the garbage collector does so at some
 * point.
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

/** The initial data of an editor. */
export interface EditorStart {
  readonly circles: Float64s
  readonly weights: boolean
  readonly ids?: Int32Array | undefined
  readonly nextId?: number | undefined
}

/**
 * Copies the circles to edit.
 *
 * @throws CircleVoronoiError `badInput`, `badOption`
 */
export function editorStart(circles: Circles | DiagramData, options: EditorOptions): EditorStart {
  checkOptionNames(options, 'edit', ['weights', 'ids', 'nextId'])
  const isDiagram = typeof circles === 'object' && circles !== null && 'vertexCircles' in circles
  const { weights = isDiagram && circles.weights === true, nextId } = options
  checkWeights(weights)
  if (isDiagram) checkMetric(circles, 'edit', 'circles')
  if (nextId !== undefined && !isId(nextId)) {
    refuseOption(`nextId must be a whole number from 0 to 2147483647, not ${shown(nextId)}.`)
  }
  return { circles: coordinatesOf(isDiagram ? circles.circles : circles), weights, ids: idsFrom(options.ids), nextId }
}

/** Copies ids. The core checks their order. */
function idsFrom(given: Iterable<number> | undefined): Int32Array | undefined {
  if (given === undefined) return undefined
  if (typeof (given as Partial<Iterable<number>> | null)?.[Symbol.iterator] !== 'function') {
    refuseOption(`ids must be a list of whole numbers, not ${shown(given)}.`)
  }
  checkMemory(given, 'edit', 'ids')
  return Int32Array.from(given, (id) => {
    if (isId(id)) return id
    refuseOption(`ids must be whole numbers from 0 to 2147483646 in increasing order; ${shown(id)} is not.`)
  })
}

function isId(id: unknown): boolean {
  return Number.isInteger(id) && (id as number) >= 0 && (id as number) < 2 ** 31
}

/** A checked edit as plain data. */
export interface CheckedEdit {
  readonly kind: string
  readonly id?: number | undefined
  readonly circle?: Circle
}

/** @throws CircleVoronoiError as `apply`, except for unknown ids */
export function checkedEdits(edits: Iterable<Edit>, weights: boolean): CheckedEdit[] {
  if (typeof (edits as Partial<Iterable<Edit>> | null | undefined)?.[Symbol.iterator] !== 'function') {
    refuseInput(`apply takes a list of edits, not ${shown(edits)}.`)
  }
  return Array.from(edits, (edit) => {
    const { kind, id, circle }: { kind?: Edit['kind']; id?: number; circle?: CircleLike } = Object(edit)
    if (kind === 'insert') {
      if (id !== undefined) checkFormerId(id)
      return { kind, id, circle: checkedCircle(circle as CircleLike, weights, id) }
    }
    if (kind !== 'remove' && kind !== 'replace') {
      refuseInput(`An edit has a kind, insert, remove or replace, not ${shown(kind)}.`)
    }
    checkId(id, 'apply')
    return kind === 'remove' ? { kind, id } : { kind, id, circle: checkedCircle(circle as CircleLike, weights, id) }
  })
}

/** Checks an id, because embind would convert other values to numbers. */
export function checkId(id: unknown, caller: string): asserts id is number {
  checkNumber(id, caller, 'the id of a circle')
  if (!isId(id) && id !== NONE) {
    refuse('unknownCircle', `There is no circle with id ${id}.`)
  }
}

function checkFormerId(id: unknown): void {
  checkNumber(id, 'apply', 'the id of a circle')
  if (!isId(id)) refuse('unknownCircle', `There is no removed circle with id ${id}.`)
}

/**
 * @throws CircleVoronoiError `badInput`, and the codes of `compute`. Messages name the id, where the core would name
 *   the place in a list.
 */
export function checkedCircle(circle: CircleLike, weights: boolean, id?: number): Circle {
  const [x, y, r]: readonly unknown[] = [circleX(circle), circleY(circle), circleRadius(circle)]
  const who = id === undefined ? 'The new circle' : `Circle ${id}`
  if (typeof x !== 'number' || typeof y !== 'number' || typeof r !== 'number') {
    refuse('badInput', missingNumber(who, CIRCLE_NAMES, [x, y, r], circle), id)
  }
  if (!Number.isFinite(x) || !Number.isFinite(y) || !Number.isFinite(r)) {
    refuse('nonFinite', `${who} has a number that is not finite.`, id)
  }
  if (r < 0 && !weights) refuse('negativeRadius', `${who} has a negative radius.`, id)
  if (Math.max(Math.abs(x), Math.abs(y), Math.abs(r)) > COORDINATE_LIMIT) {
    refuse('coordinateTooLarge', `${who} has a coordinate or a radius beyond ${COORDINATE_LIMIT_TEXT}.`, id)
  }
  return { x, y, r }
}

/** @throws CircleVoronoiError always */
export function refuse(code: ErrorCode, message: string, circle?: number): never {
  throw new CircleVoronoiError(code, message, { circle })
}
