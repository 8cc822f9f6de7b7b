// SPDX-License-Identifier: GPL-3.0-or-later
// Converts a picture to disjoint circles: many large ones in dark parts.
import type { Float64s } from '../../lib/index.ts'

/** The usual number of circles, and the largest number of pixels that are analyzed. */
export const USUAL_CIRCLES = 1800
const PIXELS = 60_000
/** Number of iterations in which all circles move to the centroids of their cells. */
const ROUNDS = 14
/** Weight of light parts relative to black ones. */
const LEAST = 0.03
/** Radius relative to the room up to the nearest other circle. */
const FILLED = 0.94

/** The pixels of a picture, rows from the top. */
export interface Pixels {
  readonly width: number
  readonly height: number
  /** Red, green, blue and opacity of each pixel, from 0 to 255. */
  readonly data: ArrayLike<number>
}

/** Circles, and the color of the picture in the cell of each. */
export interface Stippled {
  readonly circles: Float64s
  /** CSS colors. */
  readonly colors: readonly string[]
}

/** @throws Error if the browser cannot read the picture */
export async function pixelsOf(picture: Blob): Promise<Pixels> {
  const bitmap = await createImageBitmap(picture)
  const scale = Math.min(Math.sqrt(PIXELS / (bitmap.width * bitmap.height)), 1)
  const [width, height] = [
    Math.max(Math.round(bitmap.width * scale), 1),
    Math.max(Math.round(bitmap.height * scale), 1),
  ]
  const context = new OffscreenCanvas(width, height).getContext('2d') as OffscreenCanvasRenderingContext2D
  // Transparent parts count as white paper.
  context.fillStyle = 'white'
  context.fillRect(0, 0, width, height)
  context.drawImage(bitmap, 0, 0, width, height)
  bitmap.close()
  return { width, height, data: context.getImageData(0, 0, width, height).data }
}

/** Gray values from 0 (white) to 1 (black). */
function tonesOf({ width, height, data }: Pixels): Float32Array {
  return Float32Array.from({ length: width * height }, (_, k) => {
    const [red, green, blue] = [0, 1, 2].map((channel) => data[4 * k + channel] as number) as [number, number, number]
    return 1 - (0.2126 * red + 0.7152 * green + 0.0722 * blue) / 255
  })
}

/**
 * Converts a picture to circles by weighted Voronoi stippling (Secord, 2002), in pixels with y upward. `random` returns
 * numbers from 0 to 1.
 */
export function stippled(pixels: Pixels, random: () => number, count = USUAL_CIRCLES): Stippled {
  const { width, height } = pixels
  const tones = tonesOf(pixels)
  const weights = tones.map((tone) => LEAST + (1 - LEAST) * tone * tone)
  const x = new Float64Array(count)
  const y = new Float64Array(count)
  for (let i = 0; i < count; ) {
    const k = Math.floor(random() * weights.length)
    if (random() > (weights[k] as number)) continue
    x[i] = (k % width) + random()
    y[i] = Math.floor(k / width) + random()
    i += 1
  }
  const dark = new Float64Array(count)
  for (let round = 0; round < ROUNDS; round++) {
    const grid = new Buckets(x, y, width, height)
    const [sumX, sumY, sum, pixels] = Array.from({ length: 4 }, () => new Float64Array(count)) as [
      Float64Array,
      Float64Array,
      Float64Array,
      Float64Array,
    ]
    dark.fill(0)
    for (let k = 0; k < weights.length; k++) {
      const [px, py] = [(k % width) + 0.5, Math.floor(k / width) + 0.5]
      const i = grid.nearest(px, py, -1)
      const weight = weights[k] as number
      sumX[i] = (sumX[i] as number) + weight * px
      sumY[i] = (sumY[i] as number) + weight * py
      sum[i] = (sum[i] as number) + weight
      pixels[i] = (pixels[i] as number) + 1
      dark[i] = (dark[i] as number) + (tones[k] as number)
    }
    for (let i = 0; i < count; i++) {
      if (sum[i] === 0) continue
      x[i] = (sumX[i] as number) / (sum[i] as number)
      y[i] = (sumY[i] as number) / (sum[i] as number)
      dark[i] = (dark[i] as number) / (pixels[i] as number)
    }
  }
  const grid = new Buckets(x, y, width, height)
  const circles = new Float64Array(3 * count)
  for (let i = 0; i < count; i++) {
    const j = grid.nearest(x[i] as number, y[i] as number, i)
    const distance = Math.hypot((x[i] as number) - (x[j] as number), (y[i] as number) - (y[j] as number))
    const r = (FILLED / 2) * distance * Math.sqrt(Math.min(0.08 + (dark[i] as number), 1))
    circles.set([x[i] as number, height - (y[i] as number), r], 3 * i)
  }
  return { circles, colors: colorsOf(pixels, grid, count) }
}

/** The mean color of the pixels nearest to each point. */
function colorsOf({ width, height, data }: Pixels, grid: Buckets, count: number): string[] {
  const sums = new Float64Array(4 * count)
  for (let k = 0; k < width * height; k++) {
    const i = grid.nearest((k % width) + 0.5, Math.floor(k / width) + 0.5, -1)
    for (let channel = 0; channel < 3; channel++) {
      sums[4 * i + channel] = (sums[4 * i + channel] as number) + (data[4 * k + channel] as number)
    }
    sums[4 * i + 3] = (sums[4 * i + 3] as number) + 1
  }
  return Array.from({ length: count }, (_, i) => {
    const channels = [0, 1, 2].map((channel) => (sums[4 * i + channel] as number) / (sums[4 * i + 3] || 1))
    return `#${channels.map((value) => Math.round(value).toString(16).padStart(2, '0')).join('')}`
  })
}

/** Points sorted into squares, for nearest-point queries. */
class Buckets {
  readonly #x: Float64Array
  readonly #y: Float64Array
  readonly #side: number
  readonly #columns: number
  readonly #rows: number
  readonly #buckets: number[][]

  constructor(x: Float64Array, y: Float64Array, width: number, height: number) {
    this.#x = x
    this.#y = y
    this.#side = Math.max(Math.sqrt((2 * width * height) / x.length), 1)
    this.#columns = Math.ceil(width / this.#side) + 1
    this.#rows = Math.ceil(height / this.#side) + 1
    this.#buckets = Array.from({ length: this.#columns * this.#rows }, () => [])
    for (let i = 0; i < x.length; i++) {
      const place =
        Math.floor((y[i] as number) / this.#side) * this.#columns + Math.floor((x[i] as number) / this.#side)
      this.#buckets[place]?.push(i)
    }
  }

  /** The nearest point other than `but`. */
  nearest(px: number, py: number, but: number): number {
    const [column, row] = [Math.floor(px / this.#side), Math.floor(py / this.#side)]
    let best = -1
    let least = Number.POSITIVE_INFINITY
    for (let ring = 0; ring <= Math.max(this.#columns, this.#rows); ring++) {
      // Rings farther out contain only more distant points.
      if (least < ((ring - 1) * this.#side) ** 2) break
      for (let r = Math.max(row - ring, 0); r <= Math.min(row + ring, this.#rows - 1); r++) {
        const isEdge = Math.abs(r - row) === ring
        for (let c = column - ring; c <= column + ring; c += isEdge || ring === 0 ? 1 : 2 * ring) {
          if (c < 0 || c >= this.#columns) continue
          for (const i of this.#buckets[r * this.#columns + c] as number[]) {
            const distance = ((this.#x[i] as number) - px) ** 2 + ((this.#y[i] as number) - py) ** 2
            if (i !== but && distance < least) [best, least] = [i, distance]
          }
        }
      }
    }
    return best
  }
}
