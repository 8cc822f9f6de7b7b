// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../lib/diagram.ts'
import { type Box, type Cells, type Point, traceCell, traceEdge } from '../lib/index.ts'
import { boundingBox, type Camera, type Size, toScreen, visibleBox } from './camera.ts'
import { ScreenSink } from './screen-sink.ts'
import { circleCount, NOBODY, type State } from './state.ts'
import type { Theme } from './theme.ts'
import { tintClasses } from './tints.ts'

/** How far a drawn curve may be from the true one, in pixels. */
const TOLERANCE = 0.05
/** Browsers fill paths of many cells in more than linear time. */
const CELLS_PER_FILL = 64
/** Smaller circles are drawn as dots of this radius, in pixels. */
const DOT_RADIUS = 1.5
const VERTEX_RADIUS = 2
const DISC_OPACITY = 0.85
const HOVER_OPACITY = 0.55

// From which average width of cells on they are tinted, small circles are drawn at all, and vertices are marked, in pixels.
const SMALLEST_TINTED_CELL = 6
const SMALLEST_CELL_WITH_DOTS = 6
const SMALLEST_CELL_WITH_VERTICES = 60
const THINNEST_LINE = 0.35
const THICKEST_LINE = 1.25
const CELL_WIDTH_PER_LINE_WIDTH = 16

/** Draws the state on a canvas. It reads the state and never changes it. */
export class Scene {
  readonly #context: CanvasRenderingContext2D
  readonly #theme: Theme
  /** The tint of each circle, kept while the circles stay the same. */
  readonly #tintClasses = new WeakMap<Float64Array, Uint8Array>()

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
    const tolerance = TOLERANCE / camera.scale
    const cellWidth = averageCellWidth(state.circles) * camera.scale
    const lineWidth = Math.min(Math.max(cellWidth / CELL_WIDTH_PER_LINE_WIDTH, THINNEST_LINE), THICKEST_LINE)
    const pen: Pen = { cells, camera, size, box, tolerance, cellWidth, lineWidth }

    if (cellWidth >= SMALLEST_TINTED_CELL) this.#drawTints(pen)
    this.#drawHighlights(state, pen)
    const circles = circlePaths(state, pen, this.#tintClassesOf(state.circles), this.#theme.tints.length)
    this.#fillDiscs(circles)
    this.#drawEdges(pen)
    if (cellWidth >= SMALLEST_CELL_WITH_VERTICES) this.#drawVertices(pen)
    this.#strokeRims(circles, pen)
    this.#drawSelection(state, circles, pen)
  }

  #drawTints(pen: Pen): void {
    const { cells } = pen
    if (cells === undefined) return
    const cellsByTint: number[][] = this.#theme.tints.map(() => [])
    const fill = (tint: number) => {
      this.#fill(cellsPath(cellsByTint[tint] as number[], pen), this.#theme.tints[tint] as string)
      cellsByTint[tint] = []
    }
    this.#context.globalAlpha = this.#theme.cellOpacity
    this.#tintClassesOf(cells.diagram.circles).forEach((tint, circle) => {
      const count = cellsByTint[tint]?.push(circle)
      if (count === CELLS_PER_FILL) fill(tint)
    })
    for (const tint of cellsByTint.keys()) fill(tint)
    this.#context.globalAlpha = 1
  }

  #tintClassesOf(circles: Float64Array): Uint8Array {
    const known = this.#tintClasses.get(circles)
    if (known !== undefined) return known
    const classes = tintClasses(circles, this.#theme.tints.length)
    this.#tintClasses.set(circles, classes)
    return classes
  }

  /** The cell of the selected circle and its neighbours; fainter, those of the circle under the pointer. */
  #drawHighlights({ selected, hovered }: State, pen: Pen): void {
    if (selected !== NOBODY) this.#highlight(selected, pen)
    if (hovered === NOBODY || hovered === selected) return
    this.#context.globalAlpha = HOVER_OPACITY
    if (selected === NOBODY) this.#highlight(hovered, pen)
    else this.#fill(cellsPath([hovered], pen), this.#theme.selectedCell)
    this.#context.globalAlpha = 1
  }

  #highlight(circle: number, pen: Pen): void {
    const { cells } = pen
    if (cells === undefined || !hasCell(cells, circle)) return
    this.#fill(cellsPath(cells.neighbors(circle), pen), this.#theme.neighborCell)
    this.#fill(cellsPath([circle], pen), this.#theme.selectedCell)
  }

  #fillDiscs({ discs, selected }: CirclePaths): void {
    this.#context.globalAlpha = DISC_OPACITY
    discs.forEach((disc, tint) => {
      this.#fill(disc, this.#theme.tints[tint] as string)
    })
    this.#fill(selected, this.#theme.selectedDisc)
    this.#context.globalAlpha = 1
  }

  #drawEdges({ cells, camera, size, box, tolerance, lineWidth }: Pen): void {
    if (cells === undefined) return
    const sink = new ScreenSink(camera, size)
    for (let e = 0; e < cells.diagram.edges.length / 4; e++) traceEdge(sink, cells.diagram, e, box, tolerance)
    this.#stroke(sink.path, this.#theme.edge, lineWidth)
  }

  #drawVertices({ cells, camera, size, box }: Pen): void {
    const vertices = cells?.diagram.vertices ?? new Float64Array(0)
    const path = new Path2D()
    for (let v = 0; v < vertices.length; v += 3) {
      const point = { x: at(vertices, v), y: at(vertices, v + 1) }
      if (meets(box, point.x, point.y, 0)) addCircle(path, toScreen(camera, size, point), VERTEX_RADIUS)
    }
    this.#fill(path, this.#theme.edge)
  }

  #strokeRims({ discs, dots, hidden }: CirclePaths, { lineWidth }: Pen): void {
    for (const disc of discs) this.#stroke(disc, this.#theme.rim, Math.min(lineWidth, 1))
    this.#fill(dots, this.#theme.rim)
    this.#stroke(hidden, this.#theme.hidden, 1.25, [3, 3])
  }

  #drawSelection({ selected }: State, circles: CirclePaths, pen: Pen): void {
    if (selected === NOBODY) return
    this.#stroke(cellsPath([selected], pen), this.#theme.accent, 2)
    this.#stroke(circles.selected, this.#theme.accent, 2, isHidden(pen.cells, selected) ? [4, 4] : [])
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

/** What it takes to draw. `box` and `tolerance` are in units of the plane, the widths are in pixels. */
interface Pen {
  readonly cells: Cells | undefined
  readonly camera: Camera
  readonly size: Size
  readonly box: Box
  readonly tolerance: number
  readonly cellWidth: number
  readonly lineWidth: number
}

/** The circles in view: discs by tint, those too small to be seen as dots, hidden ones, and the selected one. */
interface CirclePaths {
  readonly selected: Path2D
  readonly discs: readonly Path2D[]
  readonly dots: Path2D
  readonly hidden: Path2D
}

function circlePaths(
  state: State,
  { box, camera, size, cellWidth }: Pen,
  classes: Uint8Array,
  tints: number,
): CirclePaths {
  const { circles, cells, selected } = state
  const discs = Array.from({ length: tints }, () => new Path2D())
  const hidden = new Path2D()
  const dots = new Path2D()
  const chosen = new Path2D()
  for (let i = 0; i < circleCount(state); i++) {
    const x = at(circles, 3 * i)
    const y = at(circles, 3 * i + 1)
    const r = at(circles, 3 * i + 2)
    if (!meets(box, x, y, r)) continue
    const radius = r * camera.scale
    const isDot = radius < DOT_RADIUS
    if (isDot && i !== selected && cellWidth < SMALLEST_CELL_WITH_DOTS) continue
    const path =
      i === selected ? chosen : isDot ? dots : isHidden(cells, i) ? hidden : (discs[classes[i] as number] as Path2D)
    addCircle(path, toScreen(camera, size, { x, y }), Math.max(radius, DOT_RADIUS))
  }
  return { discs, dots, hidden, selected: chosen }
}

/** The outlines of the cells of these circles. */
function cellsPath(indices: readonly number[], { cells, camera, size, box, tolerance }: Pen): Path2D {
  const sink = new ScreenSink(camera, size)
  for (const circle of indices) {
    if (cells !== undefined && hasCell(cells, circle)) traceCell(sink, cells, circle, box, tolerance)
  }
  return sink.path
}

function addCircle(path: Path2D, center: Point, radius: number): void {
  path.moveTo(center.x + radius, center.y)
  path.arc(center.x, center.y, radius, 0, 2 * Math.PI)
}

/** The box around a circle meets the window. */
function meets(box: Box, x: number, y: number, r: number): boolean {
  return x + r >= box.minX && x - r <= box.maxX && y + r >= box.minY && y - r <= box.maxY
}

/** The diagram may be of circles before the last edit, and then have fewer of them. */
function hasCell(cells: Cells, circle: number): boolean {
  return circle >= 0 && circle < cells.diagram.circles.length / 3 && cells.exists(circle)
}

function isHidden(cells: Cells | undefined, circle: number): boolean {
  return cells !== undefined && circle < cells.diagram.circles.length / 3 && !cells.exists(circle)
}

/** The width of a square that has the room of one circle, in units of the plane. */
function averageCellWidth(circles: Float64Array): number {
  const { minX, minY, maxX, maxY } = boundingBox(circles)
  return Math.sqrt(((maxX - minX) * (maxY - minY)) / Math.max(circles.length / 3, 1))
}
