// SPDX-License-Identifier: GPL-3.0-or-later

import { at } from '../../../lib/base/diagram-data.ts'
import type { PathSink } from '../../../lib/index.ts'
import { DISC_OPACITY, DOT_RADIUS } from '../../style.ts'
import { addDisc } from '../disc-path.ts'
import { type Layer, type Painting, shareOf } from '../painting.ts'

/** Dots fade in where cells are so wide, in pixels. */
const CELL_WITH_DOTS = [4, 8] as const
const HIDDEN_LINE = 1.25
/** Discs let the color of their cells through that was asked for. */
const PLAIN_OPACITY = 0.45

/** The discs of visible circles; their rims are drawn later. */
export const discs: Layer = {
  id: 'circles',
  isOn: (layers) => layers.circles,
  draw(painting) {
    const { style, layers } = painting
    const isTinted = layers.cells === 'radius' || layers.cells === 'none'
    pathsOf(painting).discs.forEach((disc, tint) => {
      if (isTinted) painting.fill(disc, style.tints[tint] as string, DISC_OPACITY)
      else painting.fill(disc, style.paper, PLAIN_OPACITY)
    })
  },
}

/** Rims, the dots that small circles are, and hidden circles. */
export const rims: Layer = {
  id: 'circles',
  isOn: (layers) => layers.circles,
  draw(painting) {
    const { style, lineWidth, pixelRatio, width } = painting
    const { discs, dots, hidden } = pathsOf(painting)
    for (const disc of discs) painting.stroke(disc, style.rim, Math.min(lineWidth, pixelRatio))
    painting.fill(dots, style.rim, shareOf(width, CELL_WITH_DOTS))
    painting.stroke(hidden, style.hidden, HIDDEN_LINE * pixelRatio, [3, 3])
  },
}

function pathsOf(painting: Painting): {
  readonly discs: readonly PathSink[]
  readonly dots: PathSink
  readonly hidden: PathSink
} {
  const { picture, frame, circles, pixelRatio, style } = painting
  const { diagram } = picture
  const discs = style.tints.map(() => painting.drawing.path())
  const dots = painting.drawing.path()
  const hidden = painting.drawing.path()
  const sink = painting.sink()
  const smallest = DOT_RADIUS * pixelRatio
  for (const i of circles) {
    const r = at(diagram.circles, 3 * i + 2)
    const radius = r * frame.scale
    const path = !diagram.cells.exists(i) ? hidden : radius < smallest ? dots : (discs[picture.tintOf(r)] as PathSink)
    // A hidden circle too small to be seen is not there.
    if (path === hidden && radius < smallest) continue
    const x = sink.x(at(diagram.circles, 3 * i))
    const y = sink.y(at(diagram.circles, 3 * i + 1))
    addDisc(path, frame, x, y, Math.max(radius, smallest))
  }
  return { discs, dots, hidden }
}
