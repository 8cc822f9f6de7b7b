// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../lib/diagram.ts'
import { type Box, type Cells, traceCell, traceEdge } from '../lib/index.ts'
import { type Camera, type Size, toScreen, visibleBox } from './camera.ts'
import { ScreenSink } from './screen-sink.ts'
import { circleCount, NOBODY, type State } from './state.ts'
import type { Theme } from './theme.ts'
import { tintClasses } from './tints.ts'

/** How far a drawn curve may be from the true one, in pixels. */
const TOLERANCE = 0.05
/** Smaller circles are drawn as dots of this radius, in pixels. */
const DOT_RADIUS = 1.5
/** Cells that have fewer square pixels on average are too small to be tinted, and their lines are drawn thinner. */
const TINY_CELL_AREA = 60

/** Draws the state on a canvas. It reads the state and never changes it. */
export class Scene {
  readonly #context: CanvasRenderingContext2D
  readonly #theme: Theme
  #tinted: { readonly cells: Cells; readonly classes: Uint8Array } | undefined

  constructor(context: CanvasRenderingContext2D, theme: Theme) {
    this.#context = context
    this.#theme = theme
  }

  /** `pixelRatio`: device pixels per CSS pixel. */
  draw(state: State, size: Size, pixelRatio: number): void {
    const context = this.#context
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0)
    context.clearRect(0, 0, size.width, size.height)
    context.lineJoin = 'round'
    context.lineCap = 'round'

    const { cells, camera } = state
    const box = visibleBox(camera, size, 4)
    if (cells !== undefined) {
      const pen: Pen = { cells, camera, size, box, tolerance: TOLERANCE / camera.scale }
      const areTiny = averageCellArea(cells, camera) < TINY_CELL_AREA
      if (!areTiny) this.#drawTints(pen)
      this.#drawHighlights(state, pen)
      this.#drawEdges(pen, areTiny)
      this.#drawSelectedOutline(state, pen)
    }
    this.#drawCircles(state, size, box)
    this.#drawSelectedCircle(state, size)
  }

  #drawTints(pen: Pen): void {
    const { tints } = this.#theme
    const sinks = tints.map(() => new ScreenSink(pen.camera, pen.size))
    const classes = this.#tintClassesOf(pen.cells)
    classes.forEach((tint, circle) => {
      traceCell(sinks[tint] as ScreenSink, pen.cells, circle, pen.box, pen.tolerance)
    })
    sinks.forEach((sink, tint) => {
      this.#fill(sink.path, tints[tint] as string)
    })
  }

  #tintClassesOf(cells: Cells): Uint8Array {
    if (this.#tinted?.cells !== cells) {
      this.#tinted = { cells, classes: tintClasses(cells.diagram.circles, this.#theme.tints.length) }
    }
    return this.#tinted.classes
  }

  /** The cells of the circle that the pointer is over, or else of the selected one, and of its neighbours. */
  #drawHighlights({ selected, hovered }: State, pen: Pen): void {
    const circle = hovered === NOBODY ? selected : hovered
    if (!hasCell(pen.cells, circle)) return
    const neighbors = new ScreenSink(pen.camera, pen.size)
    for (const neighbor of pen.cells.neighbors(circle)) {
      traceCell(neighbors, pen.cells, neighbor, pen.box, pen.tolerance)
    }
    this.#fill(neighbors.path, this.#theme.neighborCell)
    this.#fill(outlineOf(circle, pen), this.#theme.selectedCell)
  }

  #drawEdges(pen: Pen, areTiny: boolean): void {
    const { diagram } = pen.cells
    const sink = new ScreenSink(pen.camera, pen.size)
    for (let e = 0; e < diagram.edges.length / 4; e++) traceEdge(sink, diagram, e, pen.box, pen.tolerance)
    this.#stroke(sink.path, this.#theme.edge, areTiny ? 0.5 : 1.25)
  }

  #drawSelectedOutline({ selected }: State, pen: Pen): void {
    if (!hasCell(pen.cells, selected)) return
    this.#stroke(outlineOf(selected, pen), this.#theme.accent, 2)
  }

  #drawCircles(state: State, size: Size, box: Box): void {
    const { circles, camera, cells, selected } = state
    const discs = new Path2D()
    const hidden = new Path2D()
    const dots = new Path2D()
    for (let i = 0; i < circleCount(state); i++) {
      const x = at(circles, 3 * i)
      const y = at(circles, 3 * i + 1)
      const r = at(circles, 3 * i + 2)
      if (i === selected || x + r < box.minX || x - r > box.maxX || y + r < box.minY || y - r > box.maxY) continue
      const center = toScreen(camera, size, { x, y })
      const radius = r * camera.scale
      const path = radius < DOT_RADIUS ? dots : isHidden(cells, i) ? hidden : discs
      const drawnRadius = Math.max(radius, DOT_RADIUS)
      path.moveTo(center.x + drawnRadius, center.y)
      path.arc(center.x, center.y, drawnRadius, 0, 2 * Math.PI)
    }
    this.#fill(discs, this.#theme.disc)
    this.#stroke(discs, this.#theme.rim, 1)
    this.#fill(dots, this.#theme.rim)
    this.#stroke(hidden, this.#theme.hidden, 1.25, [3, 3])
  }

  #drawSelectedCircle({ circles, selected, camera, cells }: State, size: Size): void {
    if (selected === NOBODY) return
    const center = toScreen(camera, size, { x: at(circles, 3 * selected), y: at(circles, 3 * selected + 1) })
    const radius = Math.max(at(circles, 3 * selected + 2) * camera.scale, DOT_RADIUS)
    const path = new Path2D()
    path.arc(center.x, center.y, radius, 0, 2 * Math.PI)
    this.#fill(path, this.#theme.disc)
    this.#stroke(path, this.#theme.accent, 2, isHidden(cells, selected) ? [4, 4] : [])
    const middle = new Path2D()
    middle.arc(center.x, center.y, 2.5, 0, 2 * Math.PI)
    this.#fill(middle, this.#theme.accent)
  }

  #fill(path: Path2D, color: string): void {
    this.#context.fillStyle = color
    this.#context.fill(path)
  }

  #stroke(path: Path2D, color: string, width: number, dash: readonly number[] = []): void {
    this.#context.strokeStyle = color
    this.#context.lineWidth = width
    this.#context.setLineDash(dash)
    this.#context.stroke(path)
  }
}

/** What it takes to draw cells and edges. `box` and `tolerance` are in units of the plane. */
interface Pen {
  readonly cells: Cells
  readonly camera: Camera
  readonly size: Size
  readonly box: Box
  readonly tolerance: number
}

function outlineOf(circle: number, { cells, camera, size, box, tolerance }: Pen): Path2D {
  const sink = new ScreenSink(camera, size)
  traceCell(sink, cells, circle, box, tolerance)
  return sink.path
}

/** The diagram may be of circles before the last edit, and then have fewer of them. */
function hasCell(cells: Cells, circle: number): boolean {
  return circle >= 0 && circle < cells.diagram.circles.length / 3 && cells.exists(circle)
}

function isHidden(cells: Cells | undefined, circle: number): boolean {
  return cells !== undefined && circle < cells.diagram.circles.length / 3 && !cells.exists(circle)
}

/** Square pixels per circle, over the box around all vertices' circles. */
function averageCellArea({ diagram }: Cells, { scale }: Camera): number {
  const { circles } = diagram
  const count = circles.length / 3
  if (count < 1000) return Number.POSITIVE_INFINITY
  // The spread of every hundredth circle is enough to tell.
  let minX = Number.POSITIVE_INFINITY
  let minY = Number.POSITIVE_INFINITY
  let maxX = Number.NEGATIVE_INFINITY
  let maxY = Number.NEGATIVE_INFINITY
  for (let i = 0; i < count; i += 100) {
    minX = Math.min(minX, at(circles, 3 * i))
    maxX = Math.max(maxX, at(circles, 3 * i))
    minY = Math.min(minY, at(circles, 3 * i + 1))
    maxY = Math.max(maxY, at(circles, 3 * i + 1))
  }
  return ((maxX - minX) * (maxY - minY) * scale * scale) / count
}
