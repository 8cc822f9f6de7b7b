// SPDX-License-Identifier: GPL-3.0-or-later

import { at, NONE } from '../../../lib/base/diagram-data.ts'
import type { PathSink } from '../../../lib/index.ts'
import { DOT_RADIUS, isSeen } from '../../style.ts'
import { addDisc } from '../disc-path.ts'
import { type Layer, type PaintContext, shareOf } from '../paint-context.ts'
import { addRectangle } from '../polygon-path.ts'

/** Cell widths in pixels from which circles too small to see are drawn as dots; in narrower cells they are specks. */
const CELL_WITH_DOTS = [4, 8] as const
/** Smallest side of a speck, in pixels. */
const SPECK = 0.7
/** Long paths take more than linear time in browsers. */
const SPECKS_PER_PATH = 256
const HIDDEN_LINE = 1.25
/** Radius of sites whose radii are weights, in pixels, and its limit relative to the width of a cell. */
const SITE_RADIUS = 3.5
const SITE_SHARE = 0.12
const RIM_LINE = 1
/** Opacity of discs when the colors of cells show a chosen quantity. */
const SHADE = 0.28

/** The discs of visible circles. Small ones become dots or specks. */
export const discs: Layer = {
  id: 'circles',
  isOn: (layers) => layers.circles,
  draw(painting) {
    const { style, palette, width, picture } = painting
    const { discs, dots, specks } = pathsOf(painting)
    const fill = (path: PathSink, color: number, opacity: number) => {
      if (picture.areDiscsColored && color !== NONE) painting.fill(path, palette[color] as string, opacity)
      else painting.fill(path, style.edge, SHADE * opacity)
    }
    const share = shareOf(width, CELL_WITH_DOTS)
    for (const [color, path] of specks) fill(path, color, 1 - share)
    for (const [color, path] of discs) fill(path, color, 1)
    for (const [color, path] of dots) fill(path, color, share)
  },
}

/** Rims, if the style has them, and hidden circles. */
export const rims: Layer = {
  id: 'circles',
  isOn: (layers) => layers.circles,
  draw(painting) {
    const { style, lineWidth, pixelRatio } = painting
    const { discs, hidden } = pathsOf(painting)
    if (isSeen(style.rim)) {
      for (const [, disc] of discs) painting.stroke(disc, style.rim, Math.min(lineWidth, RIM_LINE * pixelRatio))
    }
    painting.stroke(hidden, style.hidden, HIDDEN_LINE * pixelRatio, [3, 3])
  },
}

/** Paths by the numbers of their colors. */
type Colored = readonly (readonly [color: number, path: PathSink])[]

interface Paths {
  readonly discs: Colored
  readonly dots: Colored
  readonly specks: Colored
  readonly hidden: PathSink
}

/** Caches the paths of a painting, because they are drawn both below and above the edges. */
const known = new WeakMap<PaintContext, Paths>()

function pathsOf(painting: PaintContext): Paths {
  const paths = known.get(painting) ?? madePaths(painting)
  known.set(painting, paths)
  return paths
}

function madePaths(painting: PaintContext): Paths {
  const { picture, frame, circles, pixelRatio, width } = painting
  const { diagram } = picture
  const discs = new Map<number, PathSink>()
  const dots = new Map<number, PathSink>()
  const specks: [number, PathSink][] = []
  const speckPaths = new Map<number, { readonly path: PathSink; count: number }>()
  const hidden = painting.drawing.path()
  const sink = painting.sink()
  const smallest = DOT_RADIUS * pixelRatio
  const site = Math.min(SITE_RADIUS, SITE_SHARE * width) * pixelRatio
  const share = shareOf(width, CELL_WITH_DOTS)
  const pathOf = (paths: Map<number, PathSink>, color: number) => {
    const path = paths.get(color) ?? painting.drawing.path()
    paths.set(color, path)
    return path
  }
  const addSpeck = (color: number, x: number, y: number, half: number) => {
    const own = speckPaths.get(color) ?? { path: painting.drawing.path(), count: 0 }
    if (own.count === 0) specks.push([color, own.path])
    addRectangle(own.path, x - half, y - half, x + half, y + half)
    own.count += 1
    if (own.count < SPECKS_PER_PATH) speckPaths.set(color, own)
    else speckPaths.delete(color)
  }
  for (const i of circles) {
    const radius = picture.areSites ? site : at(diagram.circles, 3 * i + 2) * frame.scale
    const isHidden = !diagram.cells.exists(i)
    // A hidden circle too small to see is not drawn.
    if (isHidden && radius < smallest) continue
    const x = sink.x(at(diagram.circles, 3 * i))
    const y = sink.y(at(diagram.circles, 3 * i + 1))
    if (isHidden) {
      addDisc(hidden, frame, x, y, radius)
      continue
    }
    const color = picture.colorOf(i)
    if (radius >= smallest) addDisc(pathOf(discs, color), frame, x, y, radius)
    else {
      if (share > 0) addDisc(pathOf(dots, color), frame, x, y, smallest)
      if (share < 1) addSpeck(color, x, y, Math.max(radius, (SPECK / 2) * pixelRatio))
    }
  }
  // A fixed order makes overlaps look the same in every tile.
  const byColor = <Path>(paths: Iterable<readonly [number, Path]>) => [...paths].sort(([one], [other]) => one - other)
  return { discs: byColor(discs), dots: byColor(dots), specks: byColor(specks), hidden }
}
