// SPDX-License-Identifier: GPL-3.0-or-later

import type { PathSink } from '../../lib/index.ts'
import type { Limits } from '../../lib/regions/cell-limits.ts'
import type { Layers } from '../layers.ts'
import type { Style } from '../style.ts'
import type { Drawing } from './drawing.ts'
import { boundsOf, type Frame, toleranceOf } from './frame.ts'
import { FrameSink } from './frame-sink.ts'
import type { Picture } from './picture.ts'

const CELL_WIDTH_PER_LINE_WIDTH = 16
/** Equals `--edge-width` of the page. */
const THICKEST_LINE = 1.5

/** A frame being painted on a drawing with the same pixels. */
export class PaintContext {
  readonly drawing: Drawing
  readonly frame: Frame
  /** Device pixels per CSS pixel. */
  readonly pixelRatio: number
  readonly picture: Picture
  readonly layers: Layers
  readonly style: Style
  /** The visible part with a margin, and the distance limit of cells and edges. */
  readonly limits: Limits
  /** Tolerance of curves. */
  readonly tolerance: number
  /** The indices of the circles that may be visible. The order is the same in all frames, so that overlaps agree. */
  readonly circles: readonly number[]
  /** The approximate width of cells, in CSS pixels. */
  readonly width: number
  /** Width of edges in device pixels. Below one pixel edges fade, so that small cells do not darken. */
  readonly lineWidth: number
  #palette: readonly string[] | undefined

  constructor(drawing: Drawing, frame: Frame, pixelRatio: number, picture: Picture, style: Style) {
    this.drawing = drawing
    this.frame = frame
    this.pixelRatio = pixelRatio
    this.picture = picture
    this.layers = picture.layers
    this.style = style
    this.limits = { bounds: boundsOf(frame), maxDistance: this.layers.maxDistance }
    this.tolerance = toleranceOf(frame)
    this.circles = picture.circlesIn(this.limits.bounds.box)
    this.width = (picture.lasting.cellWidth * frame.scale) / pixelRatio
    this.lineWidth = pixelRatio * Math.min(this.width / CELL_WIDTH_PER_LINE_WIDTH, THICKEST_LINE)
  }

  /** The colors of circles and cells (`colorOf`). */
  get palette(): readonly string[] {
    this.#palette ??= this.picture.palette(this.style)
    return this.#palette
  }

  /** A sink that takes coordinates of the plane. */
  sink(): FrameSink {
    return new FrameSink(this.frame, this.drawing.path())
  }

  fill(path: PathSink, color: string, opacity = 1): void {
    this.drawing.fill(path, color, opacity)
  }

  /** `thickness` is in device pixels, `dash` in CSS pixels. */
  stroke(path: PathSink, color: string, thickness: number, dash: readonly number[] = [], opacity = 1): void {
    const dashes = dash.map((length) => length * this.pixelRatio)
    this.drawing.stroke(path, color, thickness, dashes, opacity)
  }
}

/** One layer of a picture. */
export interface Layer {
  readonly id: string
  isOn(layers: Layers): boolean
  draw(painting: PaintContext): void
  /** Whether the layer is clipped to the region. */
  readonly isClipped?: boolean
}

/**
 * The position of a width between `least` and `most`, clamped to 0 to 1. Details of large cells fade in by this factor.
 */
export function shareOf(width: number, [least, most]: readonly [number, number]): number {
  return Math.min(Math.max((width - least) / (most - least), 0), 1)
}
