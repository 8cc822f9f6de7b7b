// SPDX-License-Identifier: GPL-3.0-or-later
import type { Box } from '../lib/index.ts'
import { type Camera, type Size, toPlane } from './camera.ts'
import { type Grid, type Painted, type PaintRequest, type PixelBox, TILE } from './protocol.ts'

/** Margin painted around the viewport, in device pixels, so that panning has pixels ready. */
const MARGIN = TILE
/** Largest zoom factor at which old pixels are shown until sharp ones are painted, in either direction. */
export const MOST_ENLARGED = 256

/** A buffer of a part of a grid, with the area that has been painted. */
interface PaintedBuffer {
  readonly canvas: OffscreenCanvas
  readonly context: OffscreenCanvasRenderingContext2D
  readonly grid: Grid
  readonly box: PixelBox
  /** The number of the request that fills the buffer. */
  readonly paintId: number
  isWhole: boolean
}

/**
 * The picture without hover and selection. A thread paints it; it is shown moved and scaled until the next one arrives.
 */
export class TileBuffer {
  #buffer: PaintedBuffer | undefined
  /** The previous buffer, shown where the current one is still empty. */
  #before: PaintedBuffer | undefined
  #painted: Box | undefined
  #lastGrid = 0
  #lastPaintId = 0

  /** The part of the plane whose picture is there; `undefined` until the circles have been painted once. */
  get painted(): Box | undefined {
    return this.#painted
  }

  /** Whether everything requested has been painted. */
  get isWhole(): boolean {
    return this.#buffer?.isWhole === true
  }

  /** Whether the painted pixels fit a camera exactly. */
  isSharp({ scale }: Camera, pixelRatio: number): boolean {
    const grid = this.#buffer?.grid
    return grid !== undefined && grid.scale === scale * pixelRatio && grid.pixelRatio === pixelRatio
  }

  /** Makes the buffer cover a camera's viewport. Returns the request for missing pixels, if any. */
  request(camera: Camera, size: Size, pixelRatio: number): PaintRequest | undefined {
    if (!this.isSharp(camera, pixelRatio)) {
      if (this.#buffer?.isWhole === true) this.#before = this.#buffer
      this.#lastGrid += 1
      const { x, y } = toPlane(camera, size, { x: 0, y: 0 })
      const grid = { id: this.#lastGrid, x, y, scale: camera.scale * pixelRatio, pixelRatio }
      return this.#requestOn(grid, visibleIn(grid, camera, size))
    }
    const { grid, box } = this.#buffer as PaintedBuffer
    const seen = visibleIn(grid, camera, size)
    return contains(box, seen) ? undefined : this.#requestOn(grid, seen)
  }

  /** Requests all pixels again, for example after an edit. The old pixels stay visible until then. */
  requestAll(camera: Camera, size: Size): PaintRequest | undefined {
    const buffer = this.#buffer
    if (buffer === undefined) return undefined
    this.#lastPaintId += 1
    this.#buffer = { ...buffer, paintId: this.#lastPaintId, isWhole: false }
    return {
      paintId: this.#lastPaintId,
      grid: buffer.grid,
      seen: visibleIn(buffer.grid, camera, size),
      wanted: buffer.box,
    }
  }

  put({ grid, patches, ...rest }: Painted): void {
    const buffer = this.#buffer
    // A thread may answer an edit before it knows of another scale.
    const target = [buffer, this.#before].find((other) => other?.grid.id === grid)
    if (target !== undefined) {
      for (const { box, image } of patches) {
        target.context.drawImage(image, box.left - target.box.left, box.top - target.box.top)
      }
    }
    for (const { image } of patches) image.close()
    if (rest.kind === 'painted' && rest.isWhole && buffer?.paintId === rest.paintId) {
      buffer.isWhole = true
      this.#before = undefined
      this.#painted = boxOf(buffer)
    }
    // The previous buffer shows the circles before the edit.
    if (rest.kind === 'edited' && this.#before !== undefined && this.#before !== target) {
      const { context, grid: old, box } = this.#before
      for (const { minX, minY, maxX, maxY } of rest.boxes) {
        const left = (minX - old.x) * old.scale - box.left
        const top = (old.y - maxY) * old.scale - box.top
        context.clearRect(left, top, (maxX - minX) * old.scale, (maxY - minY) * old.scale)
      }
    }
  }

  /** Drops all pixels, because of other circles or another style. */
  clear(): void {
    this.#buffer = undefined
    this.#before = undefined
    this.#painted = undefined
  }

  /** Draws the painted pixels on a context in device pixels. */
  draw(context: CanvasRenderingContext2D, camera: Camera, size: Size, pixelRatio: number): void {
    const { width, height } = context.canvas
    context.clearRect(0, 0, width, height)
    for (const buffer of [this.#before, this.#buffer]) {
      if (buffer === undefined || (buffer === this.#before && this.#buffer?.isWhole === true)) continue
      const { grid, box, canvas } = buffer
      const zoom = (camera.scale * pixelRatio) / grid.scale
      // Browsers take minutes for extreme scales, at which nothing could be recognized anyway.
      if (zoom > MOST_ENLARGED || zoom < 1 / MOST_ENLARGED) continue
      const corner = toPlane(camera, size, { x: 0, y: 0 })
      let left = (grid.x - corner.x) * camera.scale * pixelRatio + box.left * zoom
      let top = (corner.y - grid.y) * camera.scale * pixelRatio + box.top * zoom
      if (zoom === 1) {
        left = Math.round(left)
        top = Math.round(top)
      }
      context.drawImage(canvas, left, top, box.width * zoom, box.height * zoom)
    }
  }

  #requestOn(grid: Grid, seen: PixelBox): PaintRequest {
    const left = Math.floor((seen.left - MARGIN) / MARGIN) * MARGIN
    const top = Math.floor((seen.top - MARGIN) / MARGIN) * MARGIN
    const wanted = {
      left,
      top,
      width: Math.ceil((seen.left + seen.width + MARGIN) / MARGIN) * MARGIN - left,
      height: Math.ceil((seen.top + seen.height + MARGIN) / MARGIN) * MARGIN - top,
    }
    const canvas = new OffscreenCanvas(wanted.width, wanted.height)
    const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D
    const old = this.#buffer
    if (old?.grid.id === grid.id) context.drawImage(old.canvas, old.box.left - left, old.box.top - top)
    this.#lastPaintId += 1
    this.#buffer = { canvas, context, grid, box: wanted, paintId: this.#lastPaintId, isWhole: false }
    return { paintId: this.#lastPaintId, grid, seen, wanted }
  }
}

function boxOf({ grid, box: { left, top, width, height } }: PaintedBuffer): Box {
  const [minX, maxX] = [left, left + width].map((pixel) => grid.x + pixel / grid.scale) as [number, number]
  const [minY, maxY] = [top + height, top].map((pixel) => grid.y - pixel / grid.scale) as [number, number]
  return { minX, minY, maxX, maxY }
}

function visibleIn(grid: Grid, camera: Camera, size: Size): PixelBox {
  const corner = toPlane(camera, size, { x: 0, y: 0 })
  return {
    left: Math.floor((corner.x - grid.x) * grid.scale),
    top: Math.floor((grid.y - corner.y) * grid.scale),
    width: Math.ceil(size.width * grid.pixelRatio) + 1,
    height: Math.ceil(size.height * grid.pixelRatio) + 1,
  }
}

function contains(box: PixelBox, part: PixelBox): boolean {
  return (
    box.left <= part.left &&
    box.top <= part.top &&
    box.left + box.width >= part.left + part.width &&
    box.top + box.height >= part.top + part.height
  )
}
