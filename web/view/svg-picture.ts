// SPDX-License-Identifier: GPL-3.0-or-later
import { NO_PADDING } from './camera.ts'
import type { Name, Names } from './labels.ts'
import type { Layers, OverlayLayer } from './layers.ts'
import { drawOverlay, NOT_HIGHLIGHTED } from './overlay.ts'
import type { Frame } from './painter/frame.ts'
import { SvgDrawing, svgOf } from './painter/svg-drawing.ts'
import type { DrawnSvg } from './protocol.ts'
import type { Style } from './style.ts'

/** The largest number of names that are tooltips of cells. */
const MOST_TITLES = 1000

/** The names that are tooltips of cells, for `PaintedScene.svg`. While the method is played there are no cells. */
export function titlesOf({ list }: Names, overlays: readonly OverlayLayer[]): readonly Name[] {
  return overlays.length > 0 ? [] : list.slice(0, MOST_TITLES)
}

/** The SVG of a frame, for browsers and Node. `overlays` are those of the player. */
export function svgPicture(
  frame: Frame,
  { elements, found }: DrawnSvg,
  style: Style,
  layers: Layers,
  names: Names,
  overlays: readonly OverlayLayer[],
): string {
  const overlay = new SvgDrawing()
  drawOverlay(overlay, frame, 1, style, { ...NOT_HIGHLIGHTED, found, layers, names, covered: NO_PADDING, overlays })
  const { count } = names.circles
  const title = `Voronoi diagram of ${count} ${count === 1 ? 'circle' : 'circles'}`
  return svgOf(frame.width, frame.height, [elements, String(overlay)], title)
}
