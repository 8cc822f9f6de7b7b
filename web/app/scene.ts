// SPDX-License-Identifier: GPL-3.0-or-later
import { ConvexPolygon } from '../lib/index.ts'
import { boundingBox, type Size, visibleBox } from './camera.ts'
import {
  type CirclePaths,
  cellsPath,
  circlePaths,
  edgesPath,
  isHidden,
  neighborsOf,
  type Viewport,
  verticesPath,
} from './paths.ts'
import { NOBODY, type State } from './state.ts'
import type { Theme } from './theme.ts'
import { tintClasses } from './tints.ts'

/** What lies so far outside the canvas, in pixels, is not drawn; the outlines of cells run along that border. */
const MARGIN = 4
/** How far a drawn curve may be from the true one, in pixels. */
const TOLERANCE = 0.05
/** Browsers fill paths of many cells in more than linear time. */
const CELLS_PER_FILL = 64
const DISC_OPACITY = 0.85
const HOVER_OPACITY = 0.55

// What depends on the average width of the cells, in pixels.
const SMALLEST_TINTED_CELL = 6
const SMALLEST_CELL_WITH_DOTS = 6
const SMALLEST_CELL_WITH_VERTICES = 60
const CELL_WIDTH_PER_LINE_WIDTH = 16
const THINNEST_LINE = 0.35
const THICKEST_LINE = 1.25

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

    const { diagram, camera, circles } = state
    const viewport: Viewport = {
      diagram,
      camera,
      size,
      region: ConvexPolygon.of(visibleBox(camera, size, MARGIN)),
      tolerance: TOLERANCE / camera.scale,
    }
    const cellWidth = averageCellWidth(circles) * camera.scale
    const lineWidth = Math.min(Math.max(cellWidth / CELL_WIDTH_PER_LINE_WIDTH, THINNEST_LINE), THICKEST_LINE)
    const paths = circlePaths(state, viewport, this.#tintClassesOf(circles), this.#theme.tints.length)

    if (cellWidth >= SMALLEST_TINTED_CELL) this.#fillCells(viewport)
    this.#highlight(state, viewport)
    this.#fillDiscs(paths)
    this.#stroke(edgesPath(viewport), this.#theme.edge, lineWidth)
    if (cellWidth >= SMALLEST_CELL_WITH_VERTICES) this.#fill(verticesPath(viewport), this.#theme.edge)
    for (const disc of paths.discs) this.#stroke(disc, this.#theme.rim, Math.min(lineWidth, 1))
    if (cellWidth >= SMALLEST_CELL_WITH_DOTS) this.#fill(paths.dots, this.#theme.rim)
    this.#stroke(paths.hidden, this.#theme.hidden, THICKEST_LINE, [3, 3])
    this.#outlineSelection(state, paths, viewport)
  }

  #fillCells(viewport: Viewport): void {
    const { diagram } = viewport
    if (diagram === undefined) return
    const cellsByTint: number[][] = this.#theme.tints.map(() => [])
    const fill = (tint: number) => {
      this.#fill(cellsPath(cellsByTint[tint] as number[], viewport), this.#theme.tints[tint] as string)
      cellsByTint[tint] = []
    }
    this.#context.globalAlpha = this.#theme.cellOpacity
    this.#tintClassesOf(diagram.circles).forEach((tint, circle) => {
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
  #highlight({ selected, hovered }: State, viewport: Viewport): void {
    const { selectedCell, neighborCell } = this.#theme
    this.#fill(cellsPath(neighborsOf(selected, viewport), viewport), neighborCell)
    this.#fill(cellsPath([selected], viewport), selectedCell)
    if (hovered === selected) return
    this.#context.globalAlpha = HOVER_OPACITY
    if (selected === NOBODY) this.#fill(cellsPath(neighborsOf(hovered, viewport), viewport), neighborCell)
    this.#fill(cellsPath([hovered], viewport), selectedCell)
    this.#context.globalAlpha = 1
  }

  #fillDiscs({ discs, selected }: CirclePaths): void {
    this.#context.globalAlpha = DISC_OPACITY
    discs.forEach((disc, tint) => {
      this.#fill(disc, this.#theme.tints[tint] as string)
    })
    this.#fill(selected, this.#theme.selectedDisc)
    this.#context.globalAlpha = 1
  }

  #outlineSelection({ selected }: State, paths: CirclePaths, viewport: Viewport): void {
    const { accent } = this.#theme
    this.#stroke(cellsPath([selected], viewport), accent, 2)
    this.#stroke(paths.selected, accent, 2, isHidden(selected, viewport) ? [4, 4] : [])
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

/** About how far apart the circles are, in units of the plane. */
function averageCellWidth(circles: Float64Array): number {
  const { minX, minY, maxX, maxY } = boundingBox(circles)
  const [width, height] = [maxX - minX, maxY - minY]
  const count = Math.max(circles.length / 3, 1)
  // Circles in a row have hardly any area between them.
  return Math.max(Math.sqrt((width * height) / count), Math.max(width, height) / count)
}
