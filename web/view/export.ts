// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a view as SVG, PNG, for print and as video.
import type { Camera, Size } from './camera.ts'
import { drawOverlay } from './overlay.ts'
import { CanvasDrawing } from './painter/drawing.ts'
import { pictureFrame } from './picture-frame.ts'
import { Failure } from './refusal.ts'
import { svgPicture, titlesOf } from './svg-picture.ts'
import type { View } from './view.ts'

/** A part of the plane, and the size in which to export it. */
export interface ExportView {
  readonly camera: Camera
  readonly size: Size
}

const notDrawn = () => new Failure((words) => words.notDrawn)

/** Returns the visible part of a view, or another one, as SVG text without highlights. */
export async function toSVG(view: View, { camera, size }: ExportView = view, style = view.style): Promise<string> {
  const frame = { ...camera, ...size }
  const drawn = await view.scene.ask('svg', [frame, style, titlesOf(view.names, view.overlays)])
  if (drawn === undefined) throw notDrawn()
  return svgPicture(frame, drawn, style, view.drawnLayers, view.names, view.overlays)
}

/** Returns the visible part of a view, or another one, as SVG text in the colors for white paper. */
export function toPrint(view: View, shot: ExportView = view): Promise<string> {
  return toSVG(view, shot, view.printStyle)
}

/**
 * Returns the visible part of a view, or another one, as a PNG of `scale` pixels per CSS pixel, without highlights.
 * @throws CircleVoronoiError `badInput` if the picture is too large for browsers
 */
export async function toPNG(view: View, scale = devicePixelRatio, { camera, size }: ExportView = view): Promise<Blob> {
  const frame = pictureFrame(camera, size, scale)
  const image = await view.scene.ask('image', [frame, scale, view.style])
  if (image === undefined) throw notDrawn()
  const canvas = new OffscreenCanvas(frame.width, frame.height)
  const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D
  context.drawImage(image, 0, 0)
  image.close()
  drawOverlay(new CanvasDrawing(context), frame, scale, view.style, view.overlayContent)
  return canvas.convertToBlob({ type: 'image/png' })
}

/** Returns a video stream of a view. Stopping its track ends it. */
export function streamOf({ canvases }: View): MediaStream {
  const [{ width, height }] = canvases
  const canvas = Object.assign(document.createElement('canvas'), { width, height })
  const context = canvas.getContext('2d') as CanvasRenderingContext2D
  const stream = canvas.captureStream()
  const draw = () => {
    if (stream.getTracks().every(({ readyState }) => readyState === 'ended')) return
    for (const layer of canvases) context.drawImage(layer, 0, 0, width, height)
    requestAnimationFrame(draw)
  }
  draw()
  return stream
}
