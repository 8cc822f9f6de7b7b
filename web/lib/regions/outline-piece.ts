// SPDX-License-Identifier: GPL-3.0-or-later
import type { BoundedCurve } from '../curves/curve.ts'

/**
 * A piece of the outline of a clipped cell, with the cell on its left.
 *
 * @category Cells
 */
export interface OutlinePiece {
  /** Of an arc of a circle its chord. */
  readonly curve: BoundedCurve
  /** The side of the cell (see `Cells`); `NONE`: a piece of the boundary of the region, or an arc of a circle. */
  readonly side: number
  /** The circle on the other side; `NONE` likewise. */
  readonly neighbor: number
  /**
   * Of an arc of the circle around the cell's centre that a maximum distance makes: its radius, else 0. The arc is
   * counter-clockwise and of a quarter turn at most, so that its ends and radius say where the centre is.
   */
  readonly r: number
}

/**
 * Closed loops of pieces, counter-clockwise, one for each component: the end of a piece is the start of the next. Pieces
 * of length zero occur.
 *
 * @category Cells
 */
export type Outline = readonly (readonly OutlinePiece[])[]
