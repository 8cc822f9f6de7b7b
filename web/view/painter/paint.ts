// SPDX-License-Identifier: GPL-3.0-or-later
import { cells } from './layers/cells.ts'
import { discs, rims } from './layers/circles.ts'
import { data, method } from './layers/data.ts'
import { edges, missedEdges, ordinary, power } from './layers/edges.ts'
import { delaunay, dual } from './layers/graphs.ts'
import { hiders } from './layers/hiders.ts'
import { vertices } from './layers/vertices.ts'
import type { Layer, Painting } from './painting.ts'

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
  painting.drawing.cover(painting.style.paper)
  for (const layer of LAYERS) if (layer.isOn(painting.layers)) layer.draw(painting)
}
