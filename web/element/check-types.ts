// SPDX-License-Identifier: GPL-3.0-or-later

/** What a number has to be: this one, or one of a range. */
export type NumberCondition = number | { readonly min?: number | undefined; readonly max?: number | undefined }

/** What has to be so of the cell of a circle: all that is named. */
export interface CellCheck {
  /** The number of the circle: they are counted from 0. */
  readonly cell: number
  /** How many edges the cell has. */
  readonly edges?: NumberCondition | undefined
  /** How many other cells it shares them with. */
  readonly neighbors?: NumberCondition | undefined
  /** A circle whose cell it shares an edge with. */
  readonly neighbor?: number | undefined
  readonly area?: NumberCondition | undefined
  readonly bounded?: boolean | undefined
  /** Whether another circle contains this one. */
  readonly hidden?: boolean | undefined
  readonly x?: NumberCondition | undefined
  readonly y?: NumberCondition | undefined
  readonly r?: NumberCondition | undefined
}

/** What has to be so of the diagram: how many there are. */
export interface DiagramCheck {
  readonly circles?: NumberCondition | undefined
  readonly hidden?: NumberCondition | undefined
  readonly vertices?: NumberCondition | undefined
  readonly edges?: NumberCondition | undefined
}

/** What a reader has to reach: data, never code. */
export type Check =
  | CellCheck
  | DiagramCheck
  | { readonly all: readonly Check[] }
  | { readonly any: readonly Check[] }
  | { readonly not: Check }
