// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * A condition for a number: the number itself, or a range.
 *
 * @category Links
 */
export type NumberCondition = number | { readonly min?: number | undefined; readonly max?: number | undefined }

/**
 * Conditions for the cell of a circle, all of which must hold.
 *
 * @category Links
 */
export interface CellCheck {
  /** The id of the circle, counted from 0. */
  readonly cell: number
  /** The number of edges of the cell. */
  readonly edges?: NumberCondition | undefined
  /** The number of neighboring cells. */
  readonly neighbors?: NumberCondition | undefined
  /** The id of a circle whose cell must share an edge with this cell. */
  readonly neighbor?: number | undefined
  readonly area?: NumberCondition | undefined
  readonly bounded?: boolean | undefined
  /** Whether the circle must be hidden, which means that another circle contains it. */
  readonly hidden?: boolean | undefined
  readonly x?: NumberCondition | undefined
  readonly y?: NumberCondition | undefined
  readonly r?: NumberCondition | undefined
}

/**
 * Conditions for the numbers of circles, hidden circles, vertices and edges of the diagram.
 *
 * @category Links
 */
export interface DiagramCheck {
  readonly circles?: NumberCondition | undefined
  readonly hidden?: NumberCondition | undefined
  readonly vertices?: NumberCondition | undefined
  readonly edges?: NumberCondition | undefined
}

/**
 * A condition that a reader has to reach. A check is plain data, never code.
 *
 * @category Links
 */
export type Check =
  | CellCheck
  | DiagramCheck
  | { readonly all: readonly Check[] }
  | { readonly any: readonly Check[] }
  | { readonly not: Check }
