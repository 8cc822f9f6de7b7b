// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../lib/base/diagram-data.ts'
import type { Box, PathSink, Point } from '../lib/index.ts'
import { axesOf, NUMBER_SIZE } from './axes.ts'
import type { Padding } from './camera.ts'
import type { DrawnSelection } from './drawn-selection.ts'
import { LABEL_SIZE, type Label, type Names, placed } from './labels.ts'
import type { Layers, OverlayLayer } from './layers.ts'
import { replay } from './painter/commands.ts'
import { addArc, addDisc } from './painter/disc-path.ts'
import type { Drawing } from './painter/drawing.ts'
import type { Frame } from './painter/frame.ts'
import { FrameSink } from './painter/frame-sink.ts'
import { addRectangle } from './painter/polygon-path.ts'
import { addSegment } from './painter/segment-path.ts'
import type { Described, GlobalResults, Highlights, Touching, Trial } from './protocol.ts'
import { DOT_RADIUS, isSeen, type Style } from './style.ts'
import { areaText, namedOf } from './taken-text.ts'
import { NO_HIGHLIGHTS } from './view-state.ts'

/** The corners of the rectangle in which circles are about to be selected, in pixels. */
export interface SelectionRectangle {
  readonly from: Point
  readonly to: Point
}

/** Widths of highlight outlines and of the light border beside them, which separates them from any color, in pixels. */
const OUTLINE = 2.5
const NEIGHBOR_OUTLINE = 1.5
const HALO = 2
/** Opacity of a previewed circle. */
const TRIAL_OPACITY = 0.3
const FOUND_OPACITY = 0.18
const FOUND_LINE = 1.75
const PATH_LINE = 2.5
const TOUCHING_POINT = 3
/** Radius of the draggable ends of a path, in pixels. */
export const HANDLE_RADIUS = 8
const HANDLE_SIDE = 8
/** Radius of a polygon's corner, in pixels. */
const CORNER = 4
/** Distance of the resize handle from the corner of the selection's box, in pixels. */
const HANDLE_DISTANCE = 7
/** Long paths take more than linear time in browsers. */
const SELECTED_PER_PATH = 3 * 500

const TEXT_SIZE = 12
/** Width of the lines of a grid and of its axes, in pixels, and their opacity. */
const GRID_LINE = 1
const AXIS_LINE = 1.5
const FINE_GRID = 0.09
const GRID = 0.22
const AXIS = 0.7
/** Space of a written area, in pixels. */
const AREA_ROOM = { width: 60, height: 14 }
const NONE = new Float64Array()

/** The position of the selection's resize handle, in pixels. */
export function handleOf({ maxX, minY }: Box, toPixel: (point: Point) => Point): Point {
  const { x, y } = toPixel({ x: maxX, y: minY })
  return { x: x + HANDLE_DISTANCE, y: y + HANDLE_DISTANCE }
}

/** The highlights of the pointer and the selection. */
export interface OverlayHighlights {
  /** The descriptions of the selected and the hovered circle. */
  readonly highlights: Highlights
  readonly touching: Touching | undefined
  readonly trial: Trial | undefined
  readonly selection: DrawnSelection | undefined
  readonly rectangle: SelectionRectangle | undefined
  /** The corners of the polygon being drawn. */
  readonly sketch: Float64Array | undefined
}

export const NOT_HIGHLIGHTED: OverlayHighlights = {
  highlights: NO_HIGHLIGHTS,
  touching: undefined,
  trial: undefined,
  selection: undefined,
  rectangle: undefined,
  sketch: undefined,
}

/** The contents of the overlay, which is redrawn after each move. */
export interface OverlayContent extends OverlayHighlights {
  /** The layers of clients, bottom first. */
  readonly overlays: readonly OverlayLayer[]
  readonly found: GlobalResults | undefined
  readonly layers: Layers
  readonly names: Names
  /** The borders of the frame that something covers, in CSS pixels. */
  readonly covered: Padding
}

/** Whether the overlay is empty. */
export function isOverlayEmpty({
  highlights,
  found,
  touching,
  trial,
  layers,
  selection,
  rectangle,
  sketch,
  overlays,
  names,
}: OverlayContent): boolean {
  const { hull, largestDisc, path } = found ?? {}
  const drawn = [
    highlights.selected,
    highlights.hovered,
    touching,
    trial,
    selection,
    rectangle,
    sketch,
    hull,
    largestDisc,
    path,
    layers.path,
  ]
  if (layers.grid || (layers.labels && names.list.length > 0)) return false
  return overlays.length === 0 && drawn.every((what) => what === undefined)
}

/** Draws the overlay in a frame's pixels. `pixelRatio` is in device pixels per CSS pixel. */
export function drawOverlay(
  drawing: Drawing,
  frame: Frame,
  pixelRatio: number,
  style: Style,
  {
    highlights,
    found,
    touching,
    trial,
    layers,
    names,
    covered,
    selection,
    rectangle,
    sketch,
    overlays,
  }: OverlayContent,
): void {
  const to = new FrameSink(frame, drawing.path())
  const pathOf = (outline: Float64Array) => {
    const sink = new FrameSink(frame, drawing.path())
    replay(outline, sink)
    return sink.path
  }
  const fill = (path: PathSink, color: string, opacity = 1) => drawing.fill(path, color, opacity)
  const stroke = (path: PathSink, color: string, width: number, dash: readonly number[] = []) =>
    drawing.stroke(
      path,
      color,
      width * pixelRatio,
      dash.map((length) => length * pixelRatio),
    )
  const discOf = (x: number, y: number, r: number, least = 0) => {
    const path = drawing.path()
    addDisc(path, frame, to.x(x), to.y(y), Math.max(Math.abs(r) * frame.scale, least * pixelRatio))
    return path
  }
  const dot = ({ x, y }: Point, radius: number) => discOf(x, y, 0, radius)

  /** Highlights are outlines, so that colors keep their meaning. */
  const outline = (path: PathSink, color: string, width: number, dash: readonly number[] = []) => {
    stroke(path, style.paper, width + 2 * HALO)
    stroke(path, color, width, dash)
  }

  const css = {
    ...frame,
    scale: frame.scale / pixelRatio,
    width: frame.width / pixelRatio,
    height: frame.height / pixelRatio,
  }
  if (layers.grid) drawAxes()
  const { selected, hovered } = highlights
  if (selected !== undefined && isSeen(style.neighborCell))
    stroke(pathOf(selected.neighborhood), style.neighborCell, NEIGHBOR_OUTLINE)
  if (hovered !== undefined && hovered.id !== selected?.id) {
    outline(pathOf(hovered.outline), style.edge, OUTLINE)
    outline(discOf(hovered.circle.x, hovered.circle.y, hovered.circle.r, DOT_RADIUS), style.edge, OUTLINE)
  }
  if (found?.hull !== undefined && layers.hull)
    stroke(hullPath(drawing.path(), frame, to, found.hull), style.hull, FOUND_LINE)
  if (found?.largestDisc !== undefined && layers.largestDisc) drawTouching(found.largestDisc)
  if (found?.path !== undefined && layers.path !== undefined) stroke(pathOf(found.path.outline), style.path, PATH_LINE)
  for (const end of layers.path === undefined ? [] : [layers.path.from, layers.path.to]) {
    fill(dot(end, HANDLE_RADIUS - 1), style.paper)
    stroke(dot(end, HANDLE_RADIUS - 1), style.path, PATH_LINE)
  }
  for (const layer of overlays) drawData(layer)
  if (selected !== undefined) drawSelected(selected)
  if (layers.labels) drawNames()
  if (selection !== undefined) drawSelection(selection)
  if (trial !== undefined) drawTrial(trial)
  if (touching !== undefined && layers.disc) drawTouching(touching)
  if (rectangle !== undefined) drawRectangle(rectangle)
  if (sketch !== undefined) drawSketch(sketch)

  function drawData(layer: OverlayLayer): void {
    const {
      color,
      points = NONE,
      segments = NONE,
      discs = NONE,
      width = 1.25,
      dot: radius = 2.5,
      dash,
      fill: inner,
    } = layer
    const lines = drawing.path()
    for (let k = 0; k < segments.length; k += 4) {
      const [fromX, fromY] = [to.x(at(segments, k)), to.y(at(segments, k + 1))]
      addSegment(lines, frame, fromX, fromY, to.x(at(segments, k + 2)), to.y(at(segments, k + 3)))
    }
    for (let k = 0; k < discs.length; k += 3) {
      const [x, y, r] = [at(discs, k), at(discs, k + 1), at(discs, k + 2)]
      if (inner !== undefined) fill(discOf(x, y, r), color, inner)
      addDisc(lines, frame, to.x(x), to.y(y), Math.abs(r) * frame.scale)
    }
    stroke(lines, color, width, dash)
    const dots = drawing.path()
    for (let k = 0; k < points.length; k += 2) {
      if (layer.numbers !== undefined) {
        const [x, y] = [to.x(at(points, k)), to.y(at(points, k + 1))]
        drawing.write(String(at(layer.numbers, k / 2)), x, y, TEXT_SIZE * pixelRatio, color, style.paper)
        continue
      }
      addDisc(dots, frame, to.x(at(points, k)), to.y(at(points, k + 1)), radius * pixelRatio)
    }
    fill(dots, color)
  }

  function drawNames(): void {
    for (const label of placed(names, css, layers.maxDistance)) write(label, LABEL_SIZE)
  }

  function write({ text, x, y }: Label, size: number): void {
    drawing.write(text, x * pixelRatio, y * pixelRatio, size * pixelRatio, style.edge, style.paper)
  }

  function drawAxes(): void {
    const { vertical, horizontal, numbers } = axesOf(css, covered)
    const linesThrough = (across: readonly number[], down: readonly number[]) => {
      const path = drawing.path()
      for (const x of across) addSegment(path, frame, x * pixelRatio, 0, x * pixelRatio, frame.height)
      for (const y of down) addSegment(path, frame, 0, y * pixelRatio, frame.width, y * pixelRatio)
      return path
    }
    const draw = (path: PathSink, width: number, opacity: number) =>
      drawing.stroke(path, style.edge, width * pixelRatio, [], opacity)
    draw(linesThrough(vertical.fine, horizontal.fine), GRID_LINE, FINE_GRID)
    draw(linesThrough(vertical.numbered, horizontal.numbered), GRID_LINE, GRID)
    draw(linesThrough(vertical.axis, horizontal.axis), AXIS_LINE, AXIS)
    for (const number of numbers) write(number, NUMBER_SIZE)
  }

  /** Draws a disc and its contacts. Between overlapping circles the radius is negative, and the stroke is dashed. */
  function drawTouching({ disc, points }: Touching): void {
    const path = discOf(disc.x, disc.y, disc.r)
    fill(path, style.touching, FOUND_OPACITY)
    stroke(path, style.touching, FOUND_LINE, disc.r < 0 ? [4, 3] : [])
    fill(dot(disc, TOUCHING_POINT - 1), style.touching)
    for (const point of points) fill(dot(point, TOUCHING_POINT), style.touching)
  }

  /** A single selected circle is highlighted already and needs only its handle. */
  function drawSelection({ circles, box }: DrawnSelection): void {
    if (circles.length > 3) {
      let path = drawing.path()
      for (let k = 0; k < circles.length; k += 3) {
        const [x, y, r] = [to.x(at(circles, k)), to.y(at(circles, k + 1)), at(circles, k + 2) * frame.scale]
        if (x + r < 0 || y + r < 0 || x - r > frame.width || y - r > frame.height) continue
        addDisc(path, frame, x, y, Math.max(r, DOT_RADIUS * pixelRatio))
        if (k % SELECTED_PER_PATH !== 0) continue
        drawSelectionPath(path)
        path = drawing.path()
      }
      drawSelectionPath(path)
      stroke(rectanglePath(to.x(box.minX), to.y(box.maxY), to.x(box.maxX), to.y(box.minY)), style.accent, 1, [4, 4])
    }
    const { x, y } = handleOf(box, (corner) => ({ x: to.x(corner.x) / pixelRatio, y: to.y(corner.y) / pixelRatio }))
    const [left, top] = [(x - HANDLE_SIDE / 2) * pixelRatio, (y - HANDLE_SIDE / 2) * pixelRatio]
    const square = rectanglePath(left, top, left + HANDLE_SIDE * pixelRatio, top + HANDLE_SIDE * pixelRatio)
    fill(square, style.paper)
    stroke(square, style.accent, 1.5)
  }

  function drawSelectionPath(path: PathSink): void {
    outline(path, style.selectedDisc, NEIGHBOR_OUTLINE)
  }

  function drawRectangle({ from, to }: SelectionRectangle): void {
    const path = rectanglePath(from.x * pixelRatio, from.y * pixelRatio, to.x * pixelRatio, to.y * pixelRatio)
    fill(path, style.accent, 0.1)
    stroke(path, style.accent, 1)
  }

  function drawSketch(corners: Float64Array): void {
    const pixels = corners.map((value, k) => (k % 2 === 0 ? to.x(value) : to.y(value)))
    const [path, closing, dots] = [drawing.path(), drawing.path(), drawing.path()]
    for (let k = 0; k < pixels.length; k += 2) {
      const [x, y] = [at(pixels, k), at(pixels, k + 1)]
      if (k === 0) path.moveTo(x, y)
      else path.lineTo(x, y)
      addDisc(dots, frame, x, y, CORNER * pixelRatio)
    }
    closing.moveTo(at(pixels, pixels.length - 2), at(pixels, pixels.length - 1))
    closing.lineTo(at(pixels, 0), at(pixels, 1))
    fill(path, style.accent, FOUND_OPACITY)
    outline(path, style.accent, FOUND_LINE)
    stroke(closing, style.accent, FOUND_LINE, [5, 4])
    fill(dots, style.paper)
    stroke(dots, style.accent, FOUND_LINE)
  }

  function rectanglePath(left: number, top: number, right: number, bottom: number): PathSink {
    const path = drawing.path()
    addRectangle(path, left, top, right, bottom)
    return path
  }

  /** Writes the taken area at the circles that lose most. */
  function drawTrial(trial: Trial): void {
    const {
      circle: { x, y, r },
      outline: around,
      hiddenBy,
    } = trial
    const cell = pathOf(around)
    const rim = discOf(x, y, r, DOT_RADIUS)
    fill(cell, style.accent, TRIAL_OPACITY)
    fill(rim, style.accent, TRIAL_OPACITY)
    outline(cell, style.accent, OUTLINE, [6, 4])
    outline(rim, style.accent, OUTLINE, hiddenBy === undefined ? [] : [4, 4])
    // Areas without room are left out; the panel lists them.
    const written: Point[] = []
    for (const taken of namedOf(trial)) {
      const place = { x: to.x(taken.x), y: to.y(taken.y) }
      const isInside = Math.hypot(place.x - to.x(x), place.y - to.y(y)) < r * frame.scale
      const isTaken = written.some(
        (other) =>
          Math.abs(place.x - other.x) < AREA_ROOM.width * pixelRatio &&
          Math.abs(place.y - other.y) < AREA_ROOM.height * pixelRatio,
      )
      if (isInside || isTaken || Number.isNaN(taken.area)) continue
      written.push(place)
      drawing.write(`−${areaText(taken.area)}`, place.x, place.y, TEXT_SIZE * pixelRatio, style.accent, style.paper)
    }
  }

  function drawSelected({ circle: { x, y, r }, outline: cell, hiddenBy }: Described): void {
    outline(pathOf(cell), style.selectedCell, OUTLINE)
    outline(discOf(x, y, r, DOT_RADIUS), style.selectedDisc, OUTLINE, hiddenBy === undefined ? [] : [4, 4])
  }
}

function hullPath(path: PathSink, frame: Frame, to: FrameSink, arcs: Float64Array): PathSink {
  for (let k = 0; k < arcs.length; k += 7) {
    const [x, y, radius] = [at(arcs, k), at(arcs, k + 1), at(arcs, k + 2)]
    const [from, turn] = [at(arcs, k + 3), at(arcs, k + 4)]
    // Canvas coordinates are y-down, so the arc runs backwards from its end to its start.
    if (radius > 0) addArc(path, frame, to.x(x), to.y(y), radius * frame.scale, -(from + turn), turn)
    const endX = x + radius * Math.cos(from + turn)
    const endY = y + radius * Math.sin(from + turn)
    addSegment(path, frame, to.x(endX), to.y(endY), to.x(at(arcs, k + 5)), to.y(at(arcs, k + 6)))
  }
  return path
}
