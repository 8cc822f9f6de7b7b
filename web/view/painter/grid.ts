// SPDX-License-Identifier: GPL-3.0-or-later
import type { Box } from '../../lib/index.ts'
import { type Grid, type PixelBox, TILE } from '../protocol.ts'
import type { Frame } from './frame.ts'

/** The frame of a box of pixels of a grid. */
export function frameOf({ x, y, scale }: Grid, { left, top, width, height }: PixelBox): Frame {
  return { x: x + (left + width / 2) / scale, y: y - (top + height / 2) / scale, scale, width, height }
}

/** The pixels that cover a box of the plane, with a margin on each side. */
export function pixelsOf({ x, y, scale }: Grid, { minX, minY, maxX, maxY }: Box, margin: number): PixelBox {
  const left = Math.floor((minX - x) * scale - margin)
  const top = Math.floor((y - maxY) * scale - margin)
  return {
    left,
    top,
    width: Math.ceil((maxX - x) * scale + margin) - left,
    height: Math.ceil((y - minY) * scale + margin) - top,
  }
}

/** The intersection of two boxes, if they meet. */
export function intersection(a: PixelBox, b: PixelBox): PixelBox | undefined {
  const left = Math.max(a.left, b.left)
  const top = Math.max(a.top, b.top)
  const width = Math.min(a.left + a.width, b.left + b.width) - left
  const height = Math.min(a.top + a.height, b.top + b.height) - top
  return width > 0 && height > 0 ? { left, top, width, height } : undefined
}

/** Merges overlapping boxes until no two overlap. */
export function mergeOverlapping(boxes: readonly PixelBox[]): PixelBox[] {
  const covered: PixelBox[] = []
  for (let box of boxes) {
    for (let k = 0; k < covered.length; k++) {
      const other = covered[k] as PixelBox
      if (intersection(box, other) === undefined) continue
      covered.splice(k, 1)
      box = around(box, other)
      // The enlarged box may now overlap earlier ones.
      k = -1
    }
    covered.push(box)
  }
  return covered
}

function around(a: PixelBox, b: PixelBox): PixelBox {
  const [left, top] = [Math.min(a.left, b.left), Math.min(a.top, b.top)]
  const width = Math.max(a.left + a.width, b.left + b.width) - left
  const height = Math.max(a.top + a.height, b.top + b.height) - top
  return { left, top, width, height }
}

/** The tiles of the grid that a box meets. */
export function tilesOf({ left, top, width, height }: PixelBox): PixelBox[] {
  const tiles: PixelBox[] = []
  for (let y = Math.floor(top / TILE); y * TILE < top + height; y++) {
    for (let x = Math.floor(left / TILE); x * TILE < left + width; x++) {
      tiles.push({ left: x * TILE, top: y * TILE, width: TILE, height: TILE })
    }
  }
  return tiles
}
