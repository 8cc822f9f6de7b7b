// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../lib/diagram-data.ts'
import { drawCell, drawEdge } from '../../lib/draw.ts'
import { DISC_OPACITY, DOT_RADIUS, type Style } from '../style.ts'
import { addDisc } from './disc-path.ts'
import { type Frame, regionOf, toleranceOf } from './frame.ts'
import { FrameSink } from './frame-sink.ts'
import type { Picture } from './picture.ts'

/** Browsers fill and stroke long paths in more than linear time. */
const CELLS_PER_PATH = 64
const EDGES_PER_PATH = 1000
const VERTEX_RADIUS = 2

// What depends on the average width of the cells, in pixels. What is drawn of large cells alone fades in: [from, to].
const TINTED_CELL = [6, 12] as const
const CELL_WITH_DOTS = [4, 8] as const
const CELL_WITH_VERTICES = [50, 80] as const
const CELL_WIDTH_PER_LINE_WIDTH = 16
const THINNEST_LINE = 0.35
const THICKEST_LINE = 1.25

/**
 * Draws what a frame shows of a picture, on a context whose pixels are those of the frame: all of them, paper and all.
 *
 * `pixelRatio`: device pixels per CSS pixel.
 */
export function paint(
  context: OffscreenCanvasRenderingContext2D,
  frame: Frame,
  pixelRatio: number,
  { diagram, index, tintOf, cellWidth }: Picture,
  style: Style,
): void {
  const region = regionOf(frame)
  const limits = { region, maxDistance: undefined }
  const tolerance = toleranceOf(frame)
  const width = (cellWidth * frame.scale) / pixelRatio
  const lineWidth = pixelRatio * Math.min(Math.max(width / CELL_WIDTH_PER_LINE_WIDTH, THINNEST_LINE), THICKEST_LINE)
  const circles = index.search(region.box).map((id) => diagram.indexOf(id))
  // The same order whichever tile it is, for what overlaps.
  circles.sort((i, j) => i - j)

  const fill = (path: Path2D, color: string, opacity = 1) => {
    context.globalAlpha = opacity
    context.fillStyle = color
    context.fill(path)
  }
  const stroke = (path: Path2D, color: string, thickness: number, dash: readonly number[] = [], opacity = 1) => {
    context.globalAlpha = opacity
    context.strokeStyle = color
    context.lineWidth = thickness
    context.setLineDash(dash.map((length) => length * pixelRatio))
    context.stroke(path)
  }
  context.fillStyle = style.paper
  context.fillRect(0, 0, frame.width, frame.height)
  context.lineJoin = 'round'
  context.lineCap = 'round'

  fillCells()
  const rims = drawDiscs()
  strokeEdges()
  fillVertices()
  rims()
  context.globalAlpha = 1

  function fillCells(): void {
    const opacity = style.cellOpacity * shareOf(width, TINTED_CELL)
    if (opacity === 0) return
    const sinks = style.tints.map(() => ({ sink: new FrameSink(frame), count: 0 }))
    const flush = (tint: number) => {
      fill((sinks[tint] as { sink: FrameSink }).sink.path, style.tints[tint] as string, opacity)
      sinks[tint] = { sink: new FrameSink(frame), count: 0 }
    }
    for (const i of circles) {
      const tint = tintOf(at(diagram.circles, 3 * i + 2))
      const own = sinks[tint] as { sink: FrameSink; count: number }
      drawCell(own.sink, diagram.cells, i, limits, tolerance)
      own.count += 1
      if (own.count === CELLS_PER_PATH) flush(tint)
    }
    for (const tint of sinks.keys()) flush(tint)
  }

  /** Fills the discs, and returns what strokes their rims. */
  function drawDiscs(): () => void {
    const discs = style.tints.map(() => new Path2D())
    const dots = new Path2D()
    const hidden = new Path2D()
    const sink = new FrameSink(frame)
    const smallest = DOT_RADIUS * pixelRatio
    for (const i of circles) {
      const r = at(diagram.circles, 3 * i + 2)
      const radius = r * frame.scale
      const path = radius < smallest ? dots : diagram.cells.exists(i) ? (discs[tintOf(r)] as Path2D) : hidden
      const x = sink.x(at(diagram.circles, 3 * i))
      const y = sink.y(at(diagram.circles, 3 * i + 1))
      addDisc(path, frame, x, y, Math.max(radius, smallest))
    }
    discs.forEach((disc, tint) => {
      fill(disc, style.tints[tint] as string, DISC_OPACITY)
    })
    return () => {
      for (const disc of discs) stroke(disc, style.rim, Math.min(lineWidth, pixelRatio))
      fill(dots, style.rim, shareOf(width, CELL_WITH_DOTS))
      stroke(hidden, style.hidden, THICKEST_LINE * pixelRatio, [3, 3])
    }
  }

  function strokeEdges(): void {
    let sink = new FrameSink(frame)
    let count = 0
    for (const i of circles) {
      for (const side of diagram.cells.sides(i)) {
        // Each edge once: with its left circle.
        if (side & 1) continue
        drawEdge(sink, diagram, side >> 1, limits, tolerance)
        count += 1
        if (count % EDGES_PER_PATH !== 0) continue
        stroke(sink.path, style.edge, lineWidth)
        sink = new FrameSink(frame)
      }
    }
    stroke(sink.path, style.edge, lineWidth)
  }

  function fillVertices(): void {
    const opacity = shareOf(width, CELL_WITH_VERTICES)
    if (opacity === 0) return
    const path = new Path2D()
    const sink = new FrameSink(frame)
    const { cells, vertices } = diagram
    for (const i of circles) {
      for (const side of cells.sides(i)) {
        const v = cells.originOf(side)
        if (v < 0) continue
        addDisc(path, frame, sink.x(at(vertices, 3 * v)), sink.y(at(vertices, 3 * v + 1)), VERTEX_RADIUS * pixelRatio)
      }
    }
    fill(path, style.edge, opacity)
  }
}

/** How much of the way from `least` to `most` a width has gone, from 0 to 1. */
function shareOf(width: number, [least, most]: readonly [number, number]): number {
  return Math.min(Math.max((width - least) / (most - least), 0), 1)
}
