// SPDX-License-Identifier: GPL-3.0-or-later
import type { BoundedCurve } from '../curves/curve.ts'

/**
 * A piece of the outline of a clipped cell, with the cell on its left.
 *
 * @category Cells
 */
export interface OutlinePiece {
  /** The curve of the piece; for an arc of a circle, its chord. */
  readonly curve: BoundedCurve
  /**
   * The side of the cell (see `Cells`), or `NONE` for a piece of the boundary of the region and for an arc of a circle.
   */
  readonly side: number
  /**
   * The circle on the other side of the edge, or `NONE` for a piece of the boundary of the region and for an arc of a
   * circle.
   */
  readonly neighbor: number
  /** The side of the `Region` that the piece lies on, counted through all its rings; `NONE` elsewhere. */
  readonly regionSide?: number
  /**
   * The radius of an arc around the center of the cell, made by a maximum distance; 0 for other pieces. Such an arc is
   * counter-clockwise and at most a quarter turn, so its ends and its radius determine its center.
   */
  readonly r: number
}

/**
 * An outline: closed counter-clockwise loops of pieces, one for each connected component. Each piece ends where the
 * next one starts. Pieces of length zero may occur.
 *
 * @category Cells
 */
export type Outline = readonly (readonly OutlinePiece[])[]
