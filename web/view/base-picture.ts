// SPDX-License-Identifier: GPL-3.0-or-later
import { type Camera, type Size, toPlane } from './camera.ts'
import type { Painted } from './painter.ts'
import { type Grid, type PixelBox, TILE, type Wish } from './protocol.ts'

/** Around what is seen, so many device pixels are painted, too: room to pan before there is more. */
const ROOM = TILE
/** What was painted is shown up to so many times as large or small until it is painted sharp. */
const MOST_ENLARGED = 256

/** A part of a grid, as far as it is painted. */
interface Sheet {
  readonly canvas: OffscreenCanvas
  readonly context: OffscreenCanvasRenderingContext2D
  readonly grid: Grid
  readonly box: PixelBox
  /** The wish for it. */
  readonly wish: number
  isWhole: boolean
}

/** The picture without what is hovered or selected: painted elsewhere, shown moved and scaled until the next one is there. */
export class BasePicture {
  #sheet: Sheet | undefined
  /** Shown where the sheet has nothing yet. */
  #before: Sheet | undefined
  #lastGrid = 0
  #lastWish = 0

  /** Whether there is nothing left to be painted. */
  get isWhole(): boolean {
    return this.#sheet?.isWhole === true
  }

  /** Whether a camera needs no pixels of another grid. */
  isSharp({ scale }: Camera, pixelRatio: number): boolean {
    const grid = this.#sheet?.grid
    return grid !== undefined && grid.scale === scale * pixelRatio && grid.pixelRatio === pixelRatio
  }

  /** Has the sheet hold what a camera sees, and returns what has to be painted for it, if anything. */
  see(camera: Camera, size: Size, pixelRatio: number): Wish | undefined {
    if (!this.isSharp(camera, pixelRatio)) {
      if (this.#sheet?.isWhole === true) this.#before = this.#sheet
      this.#lastGrid += 1
      const { x, y } = toPlane(camera, size, { x: 0, y: 0 })
      const grid = { id: this.#lastGrid, x, y, scale: camera.scale * pixelRatio, pixelRatio }
      return this.#turnTo(grid, seenOf(grid, camera, size))
    }
    const { grid, box } = this.#sheet as Sheet
    const seen = seenOf(grid, camera, size)
    return holds(box, seen) ? undefined : this.#turnTo(grid, seen)
  }

  /** The wish for what there is to be painted once more; shown until then is what there is. */
  again(camera: Camera, size: Size): Wish | undefined {
    const sheet = this.#sheet
    if (sheet === undefined) return undefined
    this.#lastWish += 1
    this.#sheet = { ...sheet, wish: this.#lastWish, isWhole: false }
    return { wish: this.#lastWish, grid: sheet.grid, seen: seenOf(sheet.grid, camera, size), wanted: sheet.box }
  }

  put({ grid, patches, ...rest }: Painted): void {
    const sheet = this.#sheet
    if (sheet !== undefined && sheet.grid.id === grid) {
      for (const { box, image } of patches) {
        sheet.context.drawImage(image, box.left - sheet.box.left, box.top - sheet.box.top)
      }
    }
    for (const { image } of patches) image.close()
    if (rest.kind === 'painted' && rest.isWhole && sheet?.wish === rest.wish) {
      sheet.isWhole = true
      this.#before = undefined
    }
    // It shows circles as they were.
    if (rest.kind === 'edited' && this.#before !== undefined) {
      const { context, grid: old, box } = this.#before
      for (const { minX, minY, maxX, maxY } of rest.boxes) {
        const left = (minX - old.x) * old.scale - box.left
        const top = (old.y - maxY) * old.scale - box.top
        context.clearRect(left, top, (maxX - minX) * old.scale, (maxY - minY) * old.scale)
      }
    }
  }

  /** Forgets everything: other circles, or another style. */
  clear(): void {
    this.#sheet = undefined
    this.#before = undefined
  }

  /** Draws what there is on a context whose pixels are device pixels. */
  draw(context: CanvasRenderingContext2D, camera: Camera, size: Size, pixelRatio: number): void {
    const { width, height } = context.canvas
    context.clearRect(0, 0, width, height)
    for (const sheet of [this.#before, this.#sheet]) {
      if (sheet === undefined || (sheet === this.#before && this.#sheet?.isWhole === true)) continue
      const { grid, box, canvas } = sheet
      const zoom = (camera.scale * pixelRatio) / grid.scale
      // Browsers take minutes for what is far larger or smaller, and nothing could be told in it.
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

  #turnTo(grid: Grid, seen: PixelBox): Wish {
    const left = Math.floor((seen.left - ROOM) / ROOM) * ROOM
    const top = Math.floor((seen.top - ROOM) / ROOM) * ROOM
    const wanted = {
      left,
      top,
      width: Math.ceil((seen.left + seen.width + ROOM) / ROOM) * ROOM - left,
      height: Math.ceil((seen.top + seen.height + ROOM) / ROOM) * ROOM - top,
    }
    const canvas = new OffscreenCanvas(wanted.width, wanted.height)
    const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D
    const old = this.#sheet
    if (old?.grid.id === grid.id) context.drawImage(old.canvas, old.box.left - left, old.box.top - top)
    this.#lastWish += 1
    this.#sheet = { canvas, context, grid, box: wanted, wish: this.#lastWish, isWhole: false }
    return { wish: this.#lastWish, grid, seen, wanted }
  }
}

function seenOf(grid: Grid, camera: Camera, size: Size): PixelBox {
  const corner = toPlane(camera, size, { x: 0, y: 0 })
  return {
    left: Math.floor((corner.x - grid.x) * grid.scale),
    top: Math.floor((grid.y - corner.y) * grid.scale),
    width: Math.ceil(size.width * grid.pixelRatio) + 1,
    height: Math.ceil(size.height * grid.pixelRatio) + 1,
  }
}

function holds(box: PixelBox, part: PixelBox): boolean {
  return (
    box.left <= part.left &&
    box.top <= part.top &&
    box.left + box.width >= part.left + part.width &&
    box.top + box.height >= part.top + part.height
  )
}
