// SPDX-License-Identifier: GPL-3.0-or-later

/** What curves are drawn on: the part of `CanvasRenderingContext2D` and `Path2D` that is used. */
export interface PathSink {
  moveTo(x: number, y: number): void
  lineTo(x: number, y: number): void
  bezierCurveTo(x1: number, y1: number, x2: number, y2: number, x: number, y: number): void
  arc(x: number, y: number, radius: number, startAngle: number, endAngle: number, counterclockwise?: boolean): void
  closePath(): void
}
