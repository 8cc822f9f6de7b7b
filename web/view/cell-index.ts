// SPDX-License-Identifier: GPL-3.0-or-later
import { at, NONE } from '../lib/base/diagram-data.ts'
import type { Float64s, Point } from '../lib/index.ts'

/** Circles in a leaf of the tree. */
const LEAF = 8
/** Numbers of a node: the bounding box of its centers and its largest radius. */
const NODE = 5

/**
 * Finds circles that are closer to a point than a given one, without the diagram: a k-d tree of the centers, whose nodes have
 * the largest radius of their circles.
 */
export class CellIndex {
  readonly #circles: Float64s
  /** The circles in the order of the leaves. */
  readonly #order: Int32Array
  readonly #nodes: Float64Array

  /** `circles` has x, y and r of each circle, and is not copied. Only the circles `indices` are in the tree. */
  constructor(circles: Float64s, indices: Int32Array) {
    this.#circles = circles
    this.#order = indices
    let leaves = 1
    while (leaves * LEAF < indices.length) leaves *= 2
    this.#nodes = new Float64Array(NODE * 2 * leaves)
    this.#build(1, 0, indices.length)
  }

  /**
   * Returns a circle, except those that `isExcluded` names, that is closer to a point than `distance`; `NONE` if there is
   * none. Distances are those to the circles, so they are negative inside.
   */
  closerTo(point: Point, distance: number, isExcluded: (circle: number) => boolean): number {
    return this.#closerIn(1, 0, this.#order.length, point, distance, isExcluded)
  }

  #closerIn(
    node: number,
    from: number,
    to: number,
    point: Point,
    distance: number,
    isExcluded: (circle: number) => boolean,
  ): number {
    if (2 * node * NODE >= this.#nodes.length) {
      for (let k = from; k < to; k++) {
        const circle = at(this.#order, k)
        const dx = at(this.#circles, 3 * circle) - point.x
        const dy = at(this.#circles, 3 * circle + 1) - point.y
        const isCloser = Math.sqrt(dx * dx + dy * dy) - at(this.#circles, 3 * circle + 2) < distance
        if (isCloser && !isExcluded(circle)) return circle
      }
      return NONE
    }
    const middle = (from + to) >> 1
    const [left, right] = [this.#least(2 * node, point), this.#least(2 * node + 1, point)]
    // The nearer half probably has the circle.
    const isLeftFirst = left <= right
    for (const isLeft of [isLeftFirst, !isLeftFirst]) {
      if (!((isLeft ? left : right) < distance)) continue
      const found = isLeft
        ? this.#closerIn(2 * node, from, middle, point, distance, isExcluded)
        : this.#closerIn(2 * node + 1, middle, to, point, distance, isExcluded)
      if (found !== NONE) return found
    }
    return NONE
  }

  /** The least distance that a circle of a node may have; infinite if the node is empty. */
  #least(node: number, { x, y }: Point): number {
    const first = NODE * node
    const dx = Math.max(at(this.#nodes, first) - x, 0, x - at(this.#nodes, first + 2))
    const dy = Math.max(at(this.#nodes, first + 1) - y, 0, y - at(this.#nodes, first + 3))
    return Math.sqrt(dx * dx + dy * dy) - at(this.#nodes, first + 4)
  }

  #build(node: number, from: number, to: number): void {
    const box = [Infinity, Infinity, -Infinity, -Infinity, -Infinity] as [number, number, number, number, number]
    for (let k = from; k < to; k++) {
      const place = 3 * at(this.#order, k)
      const [x, y] = [at(this.#circles, place), at(this.#circles, place + 1)]
      box[0] = Math.min(box[0], x)
      box[1] = Math.min(box[1], y)
      box[2] = Math.max(box[2], x)
      box[3] = Math.max(box[3], y)
      box[4] = Math.max(box[4], at(this.#circles, place + 2))
    }
    this.#nodes.set(box, NODE * node)
    if (2 * node * NODE >= this.#nodes.length) return
    const middle = (from + to) >> 1
    this.#select(box[2] - box[0] < box[3] - box[1] ? 1 : 0, middle, from, to - 1)
    this.#build(2 * node, from, middle)
    this.#build(2 * node + 1, middle, to)
  }

  /** Orders a range so that no coordinate before position k is larger, and none after it is smaller (Hoare). */
  #select(axis: 0 | 1, k: number, left: number, right: number): void {
    const order = this.#order
    const value = (place: number) => at(this.#circles, 3 * at(order, place) + axis)
    while (left < right) {
      const pivot = value((left + right) >> 1)
      let [i, j] = [left, right]
      while (i <= j) {
        while (value(i) < pivot) i += 1
        while (value(j) > pivot) j -= 1
        if (i > j) break
        const moved = at(order, i)
        order[i] = at(order, j)
        order[j] = moved
        i += 1
        j -= 1
      }
      if (k <= j) right = j
      else if (k >= i) left = i
      else return
    }
  }
}
