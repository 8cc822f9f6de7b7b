// SPDX-License-Identifier: GPL-3.0-or-later

import type { PathSink } from '../../lib/index.ts'
import type { Limits } from '../../lib/regions/cell-limits.ts'
import { isMeasure, type Layers } from '../layers.ts'
import type { Style } from '../style.ts'
import type { Drawing } from './drawing.ts'
import { type Frame, regionOf, toleranceOf } from './frame.ts'
import { FrameSink } from './frame-sink.ts'
import type { Picture } from './picture.ts'

const CELL_WIDTH_PER_LINE_WIDTH = 16
/** As `--edge-width` of the page. */
const THICKEST_LINE = 1.5

/** A frame of a picture that is being painted, on a drawing whose pixels are those of the frame. */
export class Painting {
  readonly drawing: Drawing
  readonly frame: Frame
  /** Device pixels per CSS pixel. */
  readonly pixelRatio: number
  readonly picture: Picture
  readonly layers: Layers
  readonly style: Style
  /** What is seen, with a margin, and how far cells and edges go. */
  readonly limits: Limits
  /** How far curves may be from the true ones. */
  readonly tolerance: number
  /** The indices of the circles of which something may be seen: in the same order whichever frame it is, for what overlaps. */
  readonly circles: readonly number[]
  /** About how wide cells are, in CSS pixels. */
  readonly width: number
  /** Of edges, in device pixels: thinner than a pixel, they fade, so that as much is ink wherever cells are small. */
  readonly lineWidth: number

  constructor(drawing: Drawing, frame: Frame, pixelRatio: number, picture: Picture, style: Style) {
    this.drawing = drawing
    this.frame = frame
    this.pixelRatio = pixelRatio
    this.picture = picture
    this.layers = picture.layers
    this.style = style
    this.limits = { region: regionOf(frame), maxDistance: this.layers.maxDistance }
    this.tolerance = toleranceOf(frame)
    this.circles = picture.circlesIn(this.limits.region.box)
    this.width = (picture.cellWidth * frame.scale) / pixelRatio
    this.lineWidth = pixelRatio * Math.min(this.width / CELL_WIDTH_PER_LINE_WIDTH, THICKEST_LINE)
  }

  /** Those of circles and their cells (`colorOf`). */
  get palette(): readonly string[] {
    const { colors } = this.picture
    const hasRamp = colors === 'column' ? this.picture.layers.column?.categories === undefined : isMeasure(colors)
    return hasRamp ? this.style.ramp : this.style.map
  }

  /** What is drawn in the plane goes there. */
  sink(): FrameSink {
    return new FrameSink(this.frame, this.drawing.path())
  }

  fill(path: PathSink, color: string, opacity = 1): void {
    this.drawing.fill(path, color, opacity)
  }

  /** `thickness` in device pixels, `dash` in CSS pixels. */
  stroke(path: PathSink, color: string, thickness: number, dash: readonly number[] = [], opacity = 1): void {
    const dashes = dash.map((length) => length * this.pixelRatio)
    this.drawing.stroke(path, color, thickness, dashes, opacity)
  }
}

/** One kind of thing that is drawn. */
export interface Layer {
  readonly id: string
  isOn(layers: Layers): boolean
  draw(painting: Painting): void
  /** Whether a region cuts it. */
  readonly isClipped?: boolean
}

/** How much of the way from `least` to `most` a width has gone, from 0 to 1: what is drawn of large cells alone fades in. */
export function shareOf(width: number, [least, most]: readonly [number, number]): number {
  return Math.min(Math.max((width - least) / (most - least), 0), 1)
}
