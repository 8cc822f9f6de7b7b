// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../lib/diagram-data.ts'
import type { Box, ConvexPolygon, Diagram, Point } from '../lib/index.ts'
import { type Camera, type Size, toScreen } from './camera.ts'
import { ScreenSink } from './screen-sink.ts'
import { circleCount, NOBODY, type State } from './state.ts'

/** Smaller circles are drawn as dots of this radius, in pixels. */
const DOT_RADIUS = 1.5
const VERTEX_RADIUS = 2

/** What is looked at, and through what. `region` and `tolerance` are in units of the plane. */
export interface Viewport {
  readonly diagram: Diagram | undefined
  readonly camera: Camera
  readonly size: Size
  readonly region: ConvexPolygon
  readonly tolerance: number
}

/** The circles in view: discs by tint, those too small to be seen, hidden ones, and the selected one. */
export interface CirclePaths {
  readonly discs: readonly Path2D[]
  readonly dots: Path2D
  readonly hidden: Path2D
  readonly selected: Path2D
}

/** `tints`: for each circle which of the `tintCount` discs it belongs to. */
export function circlePaths(state: State, viewport: Viewport, tints: Uint8Array, tintCount: number): CirclePaths {
  const { circles, selected } = state
  const { region, camera, size } = viewport
  const paths: CirclePaths = {
    discs: Array.from({ length: tintCount }, () => new Path2D()),
    dots: new Path2D(),
    hidden: new Path2D(),
    selected: new Path2D(),
  }
  const pathOf = (i: number, radius: number) => {
    if (i === selected) return paths.selected
    if (radius < DOT_RADIUS) return paths.dots
    return isHidden(i, viewport) ? paths.hidden : (paths.discs[at(tints, i)] as Path2D)
  }
  for (let i = 0; i < circleCount(state); i++) {
    const x = at(circles, 3 * i)
    const y = at(circles, 3 * i + 1)
    const r = at(circles, 3 * i + 2)
    if (!meets(region.box, x, y, r)) continue
    const radius = r * camera.scale
    addCircle(pathOf(i, radius), toScreen(camera, size, { x, y }), Math.max(radius, DOT_RADIUS))
  }
  return paths
}

export function edgesPath({ diagram, camera, size, region, tolerance }: Viewport): Path2D {
  const sink = new ScreenSink(camera, size)
  diagram?.render({ context: sink, bounds: region, tolerance })
  return sink.path
}

export function verticesPath({ diagram, camera, size, region }: Viewport): Path2D {
  const path = new Path2D()
  const vertices = diagram?.vertices ?? new Float64Array(0)
  for (let v = 0; v < vertices.length; v += 3) {
    const point = { x: at(vertices, v), y: at(vertices, v + 1) }
    if (meets(region.box, point.x, point.y, 0)) addCircle(path, toScreen(camera, size, point), VERTEX_RADIUS)
  }
  return path
}

/** The outlines of the cells of these circles, as far as they have one. */
export function cellsPath(indices: readonly number[], { diagram, camera, size, region, tolerance }: Viewport): Path2D {
  const sink = new ScreenSink(camera, size)
  for (const circle of indices) {
    if (isInDiagram(circle, diagram)) diagram.cellPath(circle, { context: sink, bounds: region, tolerance })
  }
  return sink.path
}

export function neighborsOf(circle: number, { diagram }: Viewport): readonly number[] {
  return isInDiagram(circle, diagram) ? [...new Set(diagram.neighbors(circle))] : []
}

export function isHidden(circle: number, { diagram }: Viewport): boolean {
  return isInDiagram(circle, diagram) && !diagram.cells.exists(circle)
}

/** The diagram may be of circles before the last edit, and then have fewer of them. */
function isInDiagram(circle: number, diagram: Diagram | undefined): diagram is Diagram {
  return circle !== NOBODY && diagram !== undefined && circle < diagram.circles.length / 3
}

function addCircle(path: Path2D, center: Point, radius: number): void {
  path.moveTo(center.x + radius, center.y)
  path.arc(center.x, center.y, radius, 0, 2 * Math.PI)
}

/** The box around a circle meets the box of the viewport. */
function meets(box: Box, x: number, y: number, r: number): boolean {
  return x + r >= box.minX && x - r <= box.maxX && y + r >= box.minY && y - r <= box.maxY
}
