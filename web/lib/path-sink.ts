// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * What curves are drawn on: the part of `CanvasRenderingContext2D` and `Path2D` that is used.
 *
 * @category Drawing
 */
export interface PathSink {
  /** Begins a part of the path at (x, y). */
  moveTo(x: number, y: number): void
  /** A segment to (x, y). */
  lineTo(x: number, y: number): void
  /** A cubic Bezier curve to (x, y), with two control points. */
  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void
  /** An arc of a circle, by growing angles in radians, or by falling ones if `counterclockwise`. */
  arc(x: number, y: number, radius: number, startAngle: number, endAngle: number, counterclockwise?: boolean): void
  /** A segment back to where the part began. */
  closePath(): void
}
