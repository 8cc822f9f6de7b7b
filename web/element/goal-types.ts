// SPDX-License-Identifier: GPL-3.0-or-later
import type { NumberCondition } from '../lib/check-types.ts'

/** The numbers of a cell that a check can ask for. @category Element */
export type CellGoalName = 'area' | 'neighbors' | 'edges' | 'bounded' | 'hidden' | 'neighbor' | 'r' | 'x' | 'y'
/** The numbers of a diagram that a check can ask for. @category Element */
export type DiagramGoalName = 'circles' | 'hidden' | 'vertices' | 'edges'

/**
 * One goal of a check.
 *
 * @category Element
 */
export interface Goal {
  /** The name in the check, such as `edges`. */
  readonly name: CellGoalName | DiagramGoalName
  /** The id of the circle; `undefined` for a goal of the diagram. */
  readonly cell: number | undefined
  /** The current value. For `neighbor` it says whether the two cells share an edge. */
  readonly value: number | boolean
  /** The value, or the range, that the check asks for. */
  readonly goal: NumberCondition | boolean
  readonly isMet: boolean
}
