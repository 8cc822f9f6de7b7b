// SPDX-License-Identifier: GPL-3.0-or-later

import { refuseArrays, refuseInput } from '../base/check.ts'
import { at, NONE } from '../base/diagram-data.ts'
import type { DiagramData, Float64s, Int32s, SnapshotNumbers } from '../base/types.ts'
import type { Change } from './change.ts'
import { before } from './link-sides.ts'

/** The arrays of a diagram after a change. */
export type PatchedArrays = Omit<DiagramData, 'metric' | 'weights' | 'certificate' | 'stats' | 'numbers'> & {
  readonly numbers: SnapshotNumbers
}

/**
 * Applies the changes of an editor to the arrays of a diagram, in place and in time proportional to the change. Arrays
 * have no gaps: the last entries move into the places of removed ones.
 */
export class DiagramPatch {
  readonly #circles: GrowableArray<Float64s>
  readonly #firstSide: GrowableArray<Int32s>
  readonly #ids: GrowableArray<Int32s>
  readonly #vertices: GrowableArray<Float64s>
  readonly #vertexCircles: GrowableArray<Int32s>
  readonly #vertexSides: GrowableArray<Int32s>
  readonly #vertexNumbers: GrowableArray<Int32s>
  readonly #edges: GrowableArray<Int32s>
  readonly #nextSide: GrowableArray<Int32s>
  readonly #edgeNumbers: GrowableArray<Int32s>
  /** Maps each id or number to its index in the arrays. */
  readonly #circleOfId: IndexMap
  readonly #vertexOf: IndexMap
  readonly #edgeOf: IndexMap
  #hidden: Int32s
  #hull: Int32s
  #revision: number

  /** `data` is a diagram whose arrays are changed in place; `numbers` are the ids and numbers of its parts. */
  constructor(data: DiagramData, numbers: SnapshotNumbers) {
    this.#circles = new GrowableArray(data.circles)
    this.#firstSide = new GrowableArray(data.firstSide)
    this.#ids = new GrowableArray(numbers.circles)
    this.#vertices = new GrowableArray(data.vertices)
    this.#vertexCircles = new GrowableArray(data.vertexCircles)
    this.#vertexSides = new GrowableArray(data.vertexSides)
    this.#vertexNumbers = new GrowableArray(numbers.vertices)
    this.#edges = new GrowableArray(data.edges)
    this.#nextSide = new GrowableArray(data.nextSide)
    this.#edgeNumbers = new GrowableArray(numbers.edges)
    this.#circleOfId = new IndexMap(numbers.circles)
    this.#vertexOf = new IndexMap(numbers.vertices)
    this.#edgeOf = new IndexMap(numbers.edges)
    const { hiders } = numbers
    this.#hidden =
      hiders === undefined
        ? data.hidden
        : data.hidden.map((circle, k) => (k & 1 ? this.indexOf(at(hiders, k >> 1)) : circle))
    this.#hull = data.hull
    this.#revision = numbers.revision
  }

  /** Returns the index of a circle, or `NONE`. */
  indexOf(id: number): number {
    return this.#circleOfId.of(id)
  }

  /**
   * Applies a change. Returns the indices of circles whose cell, place or index has changed.
   *
   * @throws CircleVoronoiError `badInput`, if a change has been left out
   */
  apply(change: Change): Set<number> {
    if (change?.revision !== this.#revision + 1) {
      refuseInput(
        `The diagram is that of the editor after ${this.#revision} changes; what is applied has to be the next one.`,
      )
    }
    this.#revision = change.revision
    this.#putCircles(change)
    const shortened = new Set<number>()
    const freeEdges = this.#takeEdges(change, shortened)
    const freeVertices = Array.from(change.removedVertices, (number) => this.#vertexOf.take(number))
    this.#putVertices(change, freeVertices)
    this.#putEdges(change, freeEdges)
    this.#link(change)
    for (const circle of shortened) this.#findFirstSide(circle)
    const hidden = withChanges(this.#hidden, this.#hiddenChanges(change))
    const hull = this.#hullAfter(change, hidden)
    const edgeCount = closeGaps(freeEdges, this.#edgeNumbers.length, (from, to) => this.#moveEdge(from, to))
    const vertexCount = closeGaps(freeVertices, this.#vertexNumbers.length, (from, to) => this.#moveVertex(from, to))
    const moved = this.#removeCircles(change)
    this.#resize(this.#ids.length - change.removed.length, vertexCount, edgeCount)
    this.#hidden = renamed(hidden, moved, this.#ids.length)
    this.#hull = rotated(hull.map((circle) => moved.get(circle) ?? circle))
    return new Set([...[...change.cells, ...change.replaced].map((id) => this.indexOf(id)), ...moved.values()])
  }

  /** Returns the current arrays, which are valid until the next change. */
  arrays(): PatchedArrays {
    return {
      circles: this.#circles.view,
      vertices: this.#vertices.view,
      vertexCircles: this.#vertexCircles.view,
      edges: this.#edges.view,
      hidden: this.#hidden,
      hull: this.#hull,
      nextSide: this.#nextSide.view,
      vertexSides: this.#vertexSides.view,
      firstSide: this.#firstSide.view,
      numbers: {
        revision: this.#revision,
        circles: this.#ids.view,
        vertices: this.#vertexNumbers.view,
        edges: this.#edgeNumbers.view,
      },
    }
  }

  #putCircles({ inserted, replaced, circles }: Change): void {
    const first = this.#ids.length
    this.#resize(first + inserted.length, this.#vertexNumbers.length, this.#edgeNumbers.length)
    inserted.forEach((id, k) => {
      this.#circleOfId.put(id, first + k)
      this.#ids.list[first + k] = id
      this.#firstSide.list[first + k] = NONE
      copyThree(circles, k, this.#circles.list, first + k)
    })
    replaced.forEach((id, k) => {
      copyThree(circles, inserted.length + k, this.#circles.list, this.indexOf(id))
    })
  }

  /** Returns the places of the removed edges, and adds the circles that lose their first side to `shortened`. */
  #takeEdges({ removedEdges }: Change, shortened: Set<number>): number[] {
    return Array.from(removedEdges, (number) => {
      const edge = this.#edgeOf.take(number)
      for (const side of [2 * edge, 2 * edge + 1]) {
        const circle = this.#circleOf(side)
        if (at(this.#firstSide.list, circle) !== side) continue
        this.#firstSide.list[circle] = NONE
        shortened.add(circle)
      }
      return edge
    })
  }

  #putVertices({ addedVertices, vertices, vertexCircles }: Change, free: number[]): void {
    addedVertices.forEach((number, k) => {
      const vertex = free.pop() ?? this.#addVertex()
      this.#vertexOf.put(number, vertex)
      this.#vertexNumbers.list[vertex] = number
      copyThree(vertices, k, this.#vertices.list, vertex)
      for (let slot = 0; slot < 3; slot++) {
        this.#vertexCircles.list[3 * vertex + slot] = this.indexOf(at(vertexCircles, 3 * k + slot))
      }
    })
  }

  #addVertex(): number {
    const vertex = this.#vertexNumbers.length
    this.#resize(this.#ids.length, vertex + 1, this.#edgeNumbers.length)
    return vertex
  }

  #putEdges({ addedEdges, edges }: Change, free: number[]): void {
    const place = (number: number) => (number === NONE ? NONE : this.#vertexOf.of(number))
    addedEdges.forEach((number, k) => {
      const edge = free.pop() ?? this.#addEdge()
      this.#edgeOf.put(number, edge)
      this.#edgeNumbers.list[edge] = number
      const list = this.#edges.list
      list[4 * edge] = this.indexOf(at(edges, 4 * k))
      list[4 * edge + 1] = this.indexOf(at(edges, 4 * k + 1))
      list[4 * edge + 2] = place(at(edges, 4 * k + 2))
      list[4 * edge + 3] = place(at(edges, 4 * k + 3))
      for (const side of [2 * edge, 2 * edge + 1]) this.#noteSide(side)
    })
  }

  #addEdge(): number {
    const edge = this.#edgeNumbers.length
    this.#resize(this.#ids.length, this.#vertexNumbers.length, edge + 1)
    return edge
  }

  /** Makes a side the first side of its circle if it is the smallest. */
  #noteSide(side: number): void {
    const circle = this.#circleOf(side)
    const first = at(this.#firstSide.list, circle)
    if (first === NONE || side < first) this.#firstSide.list[circle] = side
  }

  #link({ addedEdges, hullSides }: Change): void {
    const ends: number[] = []
    for (const number of addedEdges) {
      const edge = this.#edgeOf.of(number)
      for (const side of [2 * edge, 2 * edge + 1]) {
        const vertex = this.#originOf(side)
        if (vertex === NONE) continue
        this.#vertexSides.list[this.#slotOf(vertex, this.#circleOf(side))] = side
        ends.push(vertex)
      }
    }
    const vertexSides = this.#vertexSides.list
    for (const vertex of ends) {
      for (let slot = 3 * vertex; slot < 3 * vertex + 3; slot++) {
        this.#nextSide.list[at(vertexSides, slot) ^ 1] = at(vertexSides, before(slot))
      }
    }
    for (let k = 0; k < hullSides.length; k += 2) {
      const side = this.#sideOf(at(hullSides, k))
      this.#nextSide.list[side] = this.#sideOf(at(hullSides, k + 1))
      // The only remaining side of a cell may belong to an unchanged edge.
      this.#noteSide(side)
    }
  }

  #findFirstSide(circle: number): void {
    const some = at(this.#firstSide.list, circle)
    if (some === NONE) return
    let least = some
    let left = this.#nextSide.length
    for (let side = this.#sideAfter(some, left); side !== some; side = this.#sideAfter(side, --left)) {
      least = Math.min(least, side)
    }
    this.#firstSide.list[circle] = least
  }

  /** Returns the new hull, with the indices of circles before `removeCircles` moves them. */
  #hullAfter({ hullSides, removed }: Change, hidden: Int32s): Int32s {
    if (hullSides.length > 0) {
      const hull: number[] = []
      const start = this.#sideOf(at(hullSides, 1))
      let side = start
      do {
        hull.push(this.#circleOf(side))
        side = this.#sideAfter(side ^ 1, this.#nextSide.length - hull.length)
      } while (side !== start)
      return Int32Array.from(hull)
    }
    if (this.#edgeOf.count > 0) return this.#hull
    // Without edges, at most one circle has a cell.
    const without = new Set(removed.map((id) => this.indexOf(id)))
    for (let k = 0; k < hidden.length; k += 2) without.add(at(hidden, k))
    const visible = this.#ids.view.findIndex((_, circle) => !without.has(circle))
    return visible === -1 ? new Int32Array() : Int32Array.of(visible)
  }

  #hiddenChanges({ removed, shown, hiders }: Change): HidingChange[] {
    const changes = [...removed, ...shown].map((id): HidingChange => [this.indexOf(id), NONE])
    for (let k = 0; k < hiders.length; k += 2) {
      changes.push([this.indexOf(at(hiders, k)), this.indexOf(at(hiders, k + 1))])
    }
    return changes
  }

  #moveEdge(from: number, to: number): void {
    const nextSide = this.#nextSide.list
    for (const parity of [0, 1]) {
      const side = 2 * from + parity
      const name = 2 * to + parity
      const vertex = this.#originOf(side)
      if (vertex === NONE) {
        let previous = side
        let left = this.#nextSide.length
        while (at(nextSide, previous) !== side) previous = this.#sideAfter(previous, left--)
        nextSide[previous] = name
      } else {
        const slot = this.#slotOf(vertex, this.#circleOf(side))
        this.#vertexSides.list[slot] = name
        nextSide[at(this.#vertexSides.list, after(slot)) ^ 1] = name
      }
      const circle = this.#circleOf(side)
      if (at(this.#firstSide.list, circle) === side) this.#firstSide.list[circle] = name
      // The twin finds the side by this entry, even if the cell has no other side.
      nextSide[name] = at(nextSide, side)
      this.#edges.list[4 * to + parity] = circle
      this.#edges.list[4 * to + 2 + parity] = vertex
      this.#noteSide(name)
    }
    const number = at(this.#edgeNumbers.list, from)
    this.#edgeNumbers.list[to] = number
    this.#edgeOf.put(number, to)
  }

  #moveVertex(from: number, to: number): void {
    copyThree(this.#vertices.list, from, this.#vertices.list, to)
    copyThree(this.#vertexCircles.list, from, this.#vertexCircles.list, to)
    copyThree(this.#vertexSides.list, from, this.#vertexSides.list, to)
    for (let slot = 3 * to; slot < 3 * to + 3; slot++) {
      const side = at(this.#vertexSides.list, slot)
      this.#edges.list[4 * (side >> 1) + 2 + (side & 1)] = to
    }
    const number = at(this.#vertexNumbers.list, from)
    this.#vertexNumbers.list[to] = number
    this.#vertexOf.put(number, to)
  }

  /** Removes circles. Returns the new index of each circle that moved into a free place. */
  #removeCircles({ removed }: Change): Map<number, number> {
    const moved = new Map<number, number>()
    const free = Array.from(removed, (id) => this.indexOf(id))
    for (const id of removed) this.#circleOfId.take(id)
    closeGaps(free, this.#ids.length, (from, to) => {
      moved.set(from, to)
      this.#moveCircle(from, to)
    })
    return moved
  }

  #moveCircle(from: number, to: number): void {
    copyThree(this.#circles.list, from, this.#circles.list, to)
    const first = at(this.#firstSide.list, from)
    this.#firstSide.list[to] = first
    const id = at(this.#ids.list, from)
    this.#ids.list[to] = id
    this.#circleOfId.put(id, to)
    if (first === NONE) return
    let side = first
    let left = this.#nextSide.length
    do {
      const vertex = this.#originOf(side)
      if (vertex !== NONE) this.#vertexCircles.list[this.#slotOf(vertex, from)] = to
      this.#edges.list[4 * (side >> 1) + (side & 1)] = to
      side = this.#sideAfter(side, left--)
    } while (side !== first)
  }

  /** Returns the next side of a walk with at most `left` more sides. */
  #sideAfter(side: number, left: number): number {
    if (left < 0) refuseArrays('side', side)
    return at(this.#nextSide.list, side)
  }

  #resize(circles: number, vertices: number, edges: number): void {
    this.#circles.resize(3 * circles)
    this.#firstSide.resize(circles)
    this.#ids.resize(circles)
    this.#vertices.resize(3 * vertices)
    this.#vertexCircles.resize(3 * vertices)
    this.#vertexSides.resize(3 * vertices)
    this.#vertexNumbers.resize(vertices)
    this.#edges.resize(4 * edges)
    this.#nextSide.resize(2 * edges)
    this.#edgeNumbers.resize(edges)
  }

  /** Returns the side in these arrays for a side of a change. */
  #sideOf(side: number): number {
    return 2 * this.#edgeOf.of(side >> 1) + (side & 1)
  }

  #circleOf(side: number): number {
    return at(this.#edges.list, 4 * (side >> 1) + (side & 1))
  }

  #originOf(side: number): number {
    return at(this.#edges.list, 4 * (side >> 1) + 2 + (side & 1))
  }

  /** Returns the place of a circle among the three circles of a vertex. */
  #slotOf(vertex: number, circle: number): number {
    const list = this.#vertexCircles.list
    return 3 * vertex + (at(list, 3 * vertex) === circle ? 0 : at(list, 3 * vertex + 1) === circle ? 1 : 2)
  }
}

class GrowableArray<List extends Float64s | Int32s> {
  list: List
  length: number
  #view: List

  constructor(list: List) {
    this.list = list
    this.length = list.length
    this.#view = list
  }

  get view(): List {
    if (this.#view.length !== this.length || this.#view.buffer !== this.list.buffer) {
      this.#view = this.list.subarray(0, this.length) as List
    }
    return this.#view
  }

  resize(length: number): void {
    this.length = length
    if (length <= this.list.length) return
    const larger = new (this.list.constructor as new (length: number) => List)(Math.max(length, 2 * this.list.length))
    larger.set(this.list)
    this.list = larger
  }
}

class IndexMap {
  count: number
  #places: Int32Array

  constructor(numbers: Int32s) {
    this.count = numbers.length
    this.#places = new Int32Array(numbers.reduce((most, number) => Math.max(most, number + 1), 0)).fill(NONE)
    numbers.forEach((number, place) => {
      this.#places[number] = place
    })
  }

  of(number: number): number {
    return this.#places[number] ?? NONE
  }

  take(number: number): number {
    const place = this.of(number)
    this.#places[number] = NONE
    this.count -= 1
    return place
  }

  put(number: number, place: number): void {
    if (number >= this.#places.length) {
      const larger = new Int32Array(2 * number + 16).fill(NONE)
      larger.set(this.#places)
      this.#places = larger
    }
    if (this.#places[number] === NONE) this.count += 1
    this.#places[number] = place
  }
}

/** Returns the place after `slot` among the three circles of a vertex, counter-clockwise. */
function after(slot: number): number {
  return slot % 3 === 2 ? slot - 2 : slot + 1
}

function copyThree(from: Float64Array | Int32Array, i: number, to: Float64Array | Int32Array, j: number): void {
  for (let k = 0; k < 3; k++) to[3 * j + k] = at(from, 3 * i + k)
}

/** Moves the last of `count` entries into free places, each entry at most once. Returns the new number of entries. */
function closeGaps(free: number[], count: number, move: (from: number, to: number) => void): number {
  const left = count - free.length
  const gaps = free.sort((a, b) => a - b)
  let last = count - 1
  let highest = gaps.length - 1
  for (const gap of gaps) {
    if (gap >= left) break
    while (last === gaps[highest]) {
      last -= 1
      highest -= 1
    }
    move(last, gap)
    last -= 1
  }
  return left
}

/** A circle and the circle that hides it now, or `NONE`. */
type HidingChange = readonly [circle: number, by: number]

/** Applies changes to the pairs of a hidden circle and its hider, which are sorted. */
function withChanges(hidden: Int32s, changes: HidingChange[]): Int32s {
  if (changes.length === 0) return hidden
  const result = new Int32Array(hidden.length + 2 * changes.length)
  let read = 0
  let written = 0
  const copyUpTo = (end: number) => {
    result.set(hidden.subarray(read, end), written)
    written += end - read
    read = end
  }
  for (const [circle, by] of changes.sort(([a], [b]) => a - b)) {
    copyUpTo(placeOf(hidden, circle))
    if (hidden[read] === circle) read += 2
    if (by === NONE) continue
    result[written++] = circle
    result[written++] = by
  }
  copyUpTo(hidden.length)
  return result.slice(0, written)
}

/** Returns the index of the first pair whose circle is at least `circle`. */
function placeOf(hidden: Int32s, circle: number): number {
  let low = 0
  let high = hidden.length >> 1
  while (low < high) {
    const middle = (low + high) >> 1
    if (at(hidden, 2 * middle) < circle) low = middle + 1
    else high = middle
  }
  return 2 * low
}

/** Renames moved circles in the pairs and sorts the pairs again. All indices are then below `count`. */
function renamed(hidden: Int32s, moved: ReadonlyMap<number, number>, count: number): Int32s {
  if (moved.size === 0) return hidden
  const changes: HidingChange[] = []
  for (let k = placeOf(hidden, count); k < hidden.length; k += 2) {
    const circle = at(hidden, k)
    changes.push([circle, NONE], [moved.get(circle) as number, at(hidden, k + 1)])
  }
  const result = withChanges(hidden, changes).slice()
  for (let k = 1; k < result.length; k += 2) {
    const by = at(result, k)
    if (by >= count) result[k] = moved.get(by) as number
  }
  return result
}

/** Rotates a hull so that it starts with its smallest step, as in `compute`. */
function rotated(hull: Int32s): Int32s {
  const next = (k: number) => at(hull, (k + 1) % hull.length)
  let start = 0
  for (let k = 1; k < hull.length; k++) {
    const order = at(hull, k) - at(hull, start)
    if (order < 0 || (order === 0 && next(k) < next(start))) start = k
  }
  if (start === 0) return hull
  const result = new Int32Array(hull.length)
  result.set(hull.subarray(start))
  result.set(hull.subarray(0, start), hull.length - start)
  return result
}
