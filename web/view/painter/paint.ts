// SPDX-License-Identifier: GPL-3.0-or-later
import type { PathSink } from '../../lib/index.ts'
import type { Region } from '../../lib/regions/region.ts'
import type { Drawing } from './drawing.ts'
import { cells } from './layers/cells.ts'
import { discs, rims } from './layers/circles.ts'
import { data, method } from './layers/data.ts'
import { edges, missedEdges, ordinary, power } from './layers/edges.ts'
import { delaunay, dual } from './layers/graphs.ts'
import { hiders } from './layers/hiders.ts'
import { vertices } from './layers/vertices.ts'
import type { Layer, Painting } from './painting.ts'
import { addBorder, addInside, addOutside, partShown } from './region-path.ts'

/** How much of the paper lies on what is outside of a region. */
const VEIL = 0.6
/** The width of its border, in pixels. */
const BORDER = 1.75

/** From below to above. */
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

/** Draws all that a frame shows: every pixel of it, paper and all. */
export function paint(painting: Painting): void {
  const { drawing, frame, style, picture, pixelRatio } = painting
  drawing.cover(style.paper)
  const region = picture.clip?.region
  const part = region && partShown(frame, region)
  // Clips to long paths take long, and most squares of a picture have no border.
  const inside = part === 'border' ? pathOf(drawing, (path) => addInside(path, frame, region as Region)) : undefined
  for (const layer of LAYERS) {
    if (!layer.isOn(painting.layers) || (layer.isClipped === true && part === 'outside')) continue
    drawing.clip(layer.isClipped === true ? inside : undefined)
    layer.draw(painting)
  }
  drawing.clip(undefined)
  if (region === undefined || part === 'inside') return
  drawing.fill(
    pathOf(drawing, (path) => addOutside(path, frame, region)),
    style.paper,
    VEIL,
  )
  const border = pathOf(drawing, (path) => addBorder(path, frame, region))
  drawing.stroke(border, style.region, BORDER * pixelRatio)
}

function pathOf(drawing: Drawing, add: (path: PathSink) => void): PathSink {
  const path = drawing.path()
  add(path)
  return path
}
