// SPDX-License-Identifier: GPL-3.0-or-later

import { at, NONE } from '../base/diagram-data.ts'
import type { Float64s } from '../base/types.ts'

/** Circles for each bucket, on average. */
const PER_BUCKET = 2
/** A bucket with more circles is divided. */
const CROWD = 8

/**
 * Square buckets over a box, each with a circle whose center lies in it or near it: where a walk to a point may start.
 * A bucket with many circles is a grid of its own, so that a walk is short however the circles are distributed.
 */
export class BucketGrid {
  /** The corner of the grid, the side of its buckets, and their number. */
  readonly #minX: number
  readonly #minY: number
  readonly #side: number
  readonly #columns: number
  readonly #rows: number
  /** A circle for each bucket, row by row; below `NONE`, the number of a grid. */
  readonly #starts: Int32Array
  readonly #grids: BucketGrid[] = []

  /** Makes about a bucket for each two of the circles with these indices, at least one of which is given. */
  constructor(circles: Float64s, indices: Int32Array) {
    let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity]
    for (const i of indices) {
      minX = Math.min(minX, at(circles, 3 * i))
      minY = Math.min(minY, at(circles, 3 * i + 1))
      maxX = Math.max(maxX, at(circles, 3 * i))
      maxY = Math.max(maxY, at(circles, 3 * i + 1))
    }
    this.#minX = minX
    this.#minY = minY
    const [width, height] = [maxX - minX, maxY - minY]
    const wanted = Math.max(1, indices.length / PER_BUCKET)
    const extent = Math.max(width, height) // the product of the smallest numbers would be 0
    const share = Math.max(Math.sqrt(((width / extent) * (height / extent)) / wanted), 1 / wanted)
    this.#side = extent * share || 1 // any size is right if all centers are equal
    this.#columns = Math.floor(width / this.#side) + 1
    this.#rows = Math.floor(height / this.#side) + 1
    this.#starts = new Int32Array(this.#columns * this.#rows).fill(NONE)
    for (const i of indices) this.#starts[this.#bucketOf(at(circles, 3 * i), at(circles, 3 * i + 1))] = i
    if (extent > 0) this.#divideCrowds(circles, indices)
    this.#spread()
  }

  /** Returns the circle in the bucket of a point. */
  near(x: number, y: number): number {
    const start = at(this.#starts, this.#bucketOf(x, y))
    return start < NONE ? this.#gridOf(start).near(x, y) : start
  }

  /** Puts a circle into the bucket of its center, in place of the circle there. */
  put(x: number, y: number, circle: number): void {
    const bucket = this.#bucketOf(x, y)
    const start = at(this.#starts, bucket)
    if (start < NONE) this.#gridOf(start).put(x, y, circle)
    else this.#starts[bucket] = circle
  }

  /** Replaces the circles of buckets that have many by grids. */
  #divideCrowds(circles: Float64s, indices: Int32Array): void {
    const buckets = indices.map((i) => this.#bucketOf(at(circles, 3 * i), at(circles, 3 * i + 1)))
    const ends = new Int32Array(this.#starts.length + 1)
    for (const bucket of buckets) ends[bucket + 1] = at(ends, bucket + 1) + 1
    if (ends.every((count) => count <= CROWD)) return
    for (let bucket = 0; bucket < this.#starts.length; bucket++)
      ends[bucket + 1] = at(ends, bucket + 1) + at(ends, bucket)
    const sorted = new Int32Array(indices.length)
    buckets.forEach((bucket, k) => {
      const place = at(ends, bucket)
      sorted[place] = at(indices, k)
      ends[bucket] = place + 1
    })
    let begin = 0
    for (let bucket = 0; bucket < this.#starts.length; bucket++) {
      const crowd = sorted.subarray(begin, at(ends, bucket))
      begin = at(ends, bucket)
      if (crowd.length <= CROWD) continue
      this.#starts[bucket] = NONE - 1 - this.#grids.length
      this.#grids.push(new BucketGrid(circles, crowd))
    }
  }

  /** Gives each empty bucket the start of a filled bucket near it. */
  #spread(): void {
    const starts = this.#starts
    const columns = this.#columns
    // The list grows during the loop.
    const filled: number[] = []
    for (let bucket = 0; bucket < starts.length; bucket++) {
      if (at(starts, bucket) !== NONE) filled.push(bucket)
    }
    for (const bucket of filled) {
      const column = bucket % columns
      const near = []
      if (column > 0) near.push(bucket - 1)
      if (column + 1 < columns) near.push(bucket + 1)
      near.push(bucket - columns, bucket + columns)
      for (const next of near) {
        if (starts[next] !== NONE) continue
        starts[next] = at(starts, bucket)
        filled.push(next)
      }
    }
  }

  #gridOf(start: number): BucketGrid {
    return this.#grids[NONE - 1 - start] as BucketGrid
  }

  #bucketOf(x: number, y: number): number {
    const column = Math.min(Math.max(Math.floor((x - this.#minX) / this.#side), 0), this.#columns - 1)
    const row = Math.min(Math.max(Math.floor((y - this.#minY) / this.#side), 0), this.#rows - 1)
    return row * this.#columns + column
  }
}
