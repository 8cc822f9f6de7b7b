// SPDX-License-Identifier: GPL-3.0-or-later
import { NO_PADDING } from './camera.ts'
import type { Names } from './labels.ts'
import type { Layers, OverlayLayer } from './layers.ts'
import { drawOverlay, NOTHING_STANDS_OUT } from './overlay.ts'
import type { Frame } from './painter/frame.ts'
import { SvgDrawing, svgOf } from './painter/svg-drawing.ts'
import type { DrawnSvg } from './protocol.ts'
import type { Style } from './style.ts'

/** The SVG of a frame, for browsers and Node. `above` is the player's overlay. */
export function svgPicture(
  frame: Frame,
  { elements, found }: DrawnSvg,
  style: Style,
  layers: Layers,
  names: Names,
  above: readonly OverlayLayer[],
): string {
  const overlay = new SvgDrawing()
  drawOverlay(overlay, frame, 1, style, { ...NOTHING_STANDS_OUT, found, layers, names, covered: NO_PADDING, above })
  return svgOf(frame.width, frame.height, [elements, String(overlay)])
}
