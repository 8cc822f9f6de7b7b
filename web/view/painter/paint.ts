// SPDX-License-Identifier: GPL-3.0-or-later
import type { PathSink } from '../../lib/index.ts'
import type { Drawing } from './drawing.ts'
import { cells } from './layers/cells.ts'
import { discs, rims } from './layers/circles.ts'
import { data, method } from './layers/data.ts'
import { edges, missedEdges, ordinary, power } from './layers/edges.ts'
import { delaunay, dual } from './layers/graphs.ts'
import { hiders } from './layers/hiders.ts'
import { vertices } from './layers/vertices.ts'
import { type Layer, PaintContext } from './paint-context.ts'
import { addBorder, addInside, addOutside, partShown } from './region-path.ts'
import type { Border } from './torus.ts'

/** Opacity of the paper color that covers the outside of a region. */
const VEIL = 0.6
/** Width of the region's border, in pixels. */
const BORDER = 1.75

/** The layers, bottom first. */
const LAYERS: readonly Layer[] = [
  cells,
  discs,
  ordinary,
  power,
  edges,
  missedEdges,
  dual,
  delaunay,
  vertices,
  rims,
  hiders,
  method,
  data,
]

/** Paints a whole frame, including the paper. */
export function paint(painting: PaintContext): void {
  const { drawing, frame, style, picture, pixelRatio } = painting
  drawing.cover(style.paper)
  const border: Border | undefined = picture.clip?.region ?? picture.torus?.border
  const part = border && partShown(frame, border)
  // Images are drawn across the border of their box.
  const region = picture.clip?.region
  // Clipping to long paths is slow, and most tiles contain no border.
  const inside = region && part === 'border' ? pathOf(drawing, (path) => addInside(path, frame, region)) : undefined
  const copies = copiesOf(painting)
  for (const layer of LAYERS) {
    if (!layer.isOn(painting.layers) || (layer.isClipped === true && region && part === 'outside')) continue
    drawing.clip(layer.isClipped === true ? inside : undefined)
    // Layers of clients do not repeat.
    for (const copy of layer === data ? [painting] : copies) layer.draw(copy)
  }
  drawing.clip(undefined)
  if (border === undefined || part === 'inside') return
  drawing.fill(
    pathOf(drawing, (path) => addOutside(path, frame, border)),
    style.paper,
    VEIL,
  )
  // A mosaic has no lines.
  if (painting.layers.fullColor && !painting.layers.edges) return
  const line = pathOf(drawing, (path) => addBorder(path, frame, border))
  drawing.stroke(line, style.region, BORDER * pixelRatio)
}

/** The painting itself, or one for each copy of repeating circles. */
function copiesOf(painting: PaintContext): readonly PaintContext[] {
  const { drawing, frame, pixelRatio, picture, style, limits } = painting
  if (picture.torus === undefined) return [painting]
  return picture.copiesIn(limits.bounds.box).map(({ x, y }) => {
    const moved = { ...frame, x: frame.x - x, y: frame.y - y }
    return new PaintContext(drawing, moved, pixelRatio, picture, style)
  })
}

function pathOf(drawing: Drawing, add: (path: PathSink) => void): PathSink {
  const path = drawing.path()
  add(path)
  return path
}
