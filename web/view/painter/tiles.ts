// SPDX-License-Identifier: GPL-3.0-or-later

import type { Box } from '../../lib/index.ts'
import type { PaintRequest, Patch, PixelBox } from '../protocol.ts'
import type { Style } from '../style.ts'
import { CanvasDrawing, type Drawing } from './drawing.ts'
import type { Frame } from './frame.ts'
import { frameOf, intersection, mergeOverlapping, pixelsOf, tilesOf } from './grid.ts'

/** Strokes extend this far beyond an edited box, in CSS pixels. */
const STROKE = 4

/** The viewport and style of a paint request. */
export interface ViewportRequest extends PaintRequest {
  readonly style: Style
}

/** The tiles around one viewport. */
export class Tiles {
  readonly #draw: (drawing: Drawing, frame: Frame, pixelRatio: number, style: Style) => void
  #viewport: ViewportRequest | undefined
  /** The tiles that the view has. */
  readonly #painted = new Set<string>()
  /** The tiles to paint, the next one last. */
  #waiting: PixelBox[] = []
  /**
   * The tiles that wait for the other visible ones, because the view shows another picture; `undefined` if it does not.
   */
  #held: Patch[] | undefined

  constructor(draw: (drawing: Drawing, frame: Frame, pixelRatio: number, style: Style) => void) {
    this.#draw = draw
  }

  get viewport(): ViewportRequest | undefined {
    return this.#viewport
  }

  get isWaiting(): boolean {
    return this.#waiting.length > 0
  }

  /** Sets the viewport. Returns whether it covers another box or has another scale. */
  turnTo(viewport: ViewportRequest): { isElsewhere: boolean; isOtherScale: boolean } {
    const before = this.#viewport
    const isOtherGrid = before?.grid.id !== viewport.grid.id
    this.#viewport = viewport
    if (isOtherGrid) {
      this.#painted.clear()
      this.#drop()
    }
    this.#queue(viewport)
    return {
      isElsewhere: isOtherGrid || !isSameBox(before.wanted, viewport.wanted),
      isOtherScale: before?.grid.scale !== viewport.grid.scale,
    }
  }

  /** Paints the next missing tile, if any. Returns the tiles that the view may show now. */
  paintNext(): Patch[] {
    const tile = this.#waiting.pop()
    if (tile === undefined || this.#viewport === undefined) return []
    const patch = this.#paint(tile, this.#viewport)
    this.#painted.add(keyOf(tile))
    if (this.#held === undefined) return [patch]
    this.#held.push(patch)
    return this.#isSeenMissing ? [] : this.release()
  }

  /** The painted tiles that were waiting for other ones. */
  release(): Patch[] {
    const held = this.#held ?? []
    this.#held = undefined
    return held
  }

  #drop(): void {
    for (const { image } of this.release()) image.close()
  }

  /** Whether a visible tile is missing. */
  get #isSeenMissing(): boolean {
    const { seen } = this.#viewport as ViewportRequest
    return this.#waiting.some((tile) => intersection(tile, seen) !== undefined)
  }

  /** Paints the visible tiles that are missing, so that a view shows a moment as a whole or not at all. */
  paintSeen(): Patch[] {
    const viewport = this.#viewport
    if (viewport === undefined) return []
    const isSeen = (tile: PixelBox) => intersection(tile, viewport.seen) !== undefined
    const tiles = this.#waiting.filter(isSeen)
    this.#waiting = this.#waiting.filter((tile) => !isSeen(tile))
    const patches = tiles.map((tile) => this.#paint(tile, viewport))
    for (const tile of tiles) this.#painted.add(keyOf(tile))
    return patches
  }

  /** Repaints boxes of the plane where the view has tiles; `undefined` repaints all tiles. */
  repaint(boxes: readonly Box[] | undefined): Patch[] {
    const viewport = this.#viewport
    if (viewport === undefined) return []
    const margin = STROKE * viewport.grid.pixelRatio
    const tiles = tilesOf(viewport.wanted).filter((tile) => this.#painted.has(keyOf(tile)))
    return tiles.flatMap((tile) => {
      if (boxes === undefined) return [this.#paint(tile, viewport)]
      const parts = boxes.flatMap((box) => intersection(tile, pixelsOf(viewport.grid, box, margin)) ?? [])
      return mergeOverlapping(parts).map((part) => this.#paint(part, viewport))
    })
  }

  /** Queues all tiles again. A view that shows all of them keeps these until it has all visible ones again. */
  restart(): void {
    if (this.#viewport === undefined) return
    const isShown = this.#held === undefined && this.#painted.size > 0 && !this.#isSeenMissing
    this.#drop()
    if (isShown) this.#held = []
    this.#painted.clear()
    this.#queue(this.#viewport)
  }

  /** Paints no more tiles until the next request. */
  stop(): void {
    this.#waiting = []
    this.#drop()
  }

  #queue({ seen, wanted }: ViewportRequest): void {
    const middleX = seen.left + seen.width / 2
    const middleY = seen.top + seen.height / 2
    const distanceOf = ({ left, top, width, height }: PixelBox) =>
      Math.max(Math.abs(left + width / 2 - middleX), Math.abs(top + height / 2 - middleY))
    this.#waiting = tilesOf(wanted)
      .filter((tile) => !this.#painted.has(keyOf(tile)))
      .sort((a, b) => distanceOf(b) - distanceOf(a))
    const kept = new Set(tilesOf(wanted).map(keyOf))
    for (const key of this.#painted) if (!kept.has(key)) this.#painted.delete(key)
  }

  #paint(box: PixelBox, { grid, style }: ViewportRequest): Patch {
    const canvas = new OffscreenCanvas(box.width, box.height)
    const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D
    this.#draw(new CanvasDrawing(context), frameOf(grid, box), grid.pixelRatio, style)
    return { box, image: canvas.transferToImageBitmap() }
  }
}

function isSameBox(one: PixelBox, other: PixelBox): boolean {
  return keyOf(one) === keyOf(other) && one.width === other.width && one.height === other.height
}

function keyOf({ left, top }: PixelBox): string {
  return `${left},${top}`
}
