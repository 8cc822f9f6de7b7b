// SPDX-License-Identifier: GPL-3.0-or-later
import type { Cells } from './cells.ts'
import { checkDiagram, checkIndex } from './check.ts'
import { type Part, partsInside } from './clip.ts'
import { type Bounds, ConvexPolygon } from './convex-polygon.ts'
import { type BoundedCurve, edgeCurve, reversed, segment } from './curve.ts'
import type { Diagram } from './diagram.ts'
import { NONE } from './diagram-data.ts'
import type { Point } from './point.ts'
import { Ring } from './ring.ts'

/** A piece of the outline of a clipped cell, with the cell on its left. */
export interface OutlinePiece {
  readonly curve: BoundedCurve
  /** The side of the cell (see `Cells`); `NONE`: a piece of the boundary of the region. */
  readonly side: number
  /** The circle on the other side; `NONE` likewise. */
  readonly neighbor: number
}

/**
 * Closed loops of pieces, counter-clockwise, one for each component: the end of a piece is the start of the next. Pieces
 * of length zero occur.
 */
export type Outline = readonly (readonly OutlinePiece[])[]

/**
 * The part of the cell of a circle inside some bounds: empty if they do not meet, several loops if the bounds cut the cell
 * apart.
 *
 * @throws CircleVoronoiError `badArgument`, `badOption`
 */
export function outline(diagram: Diagram, circle: number, bounds: Bounds): Outline {
  checkDiagram(diagram, 'outline')
  checkIndex(circle, diagram.circles.length / 3, 'outline', 'circle')
  return outlineOf(diagram.cells, circle, ConvexPolygon.of(bounds))
}

/** The same of checked arguments. */
export function outlineOf(cells: Cells, circle: number, region: ConvexPolygon): Outline {
  if (!cells.exists(circle)) return []
  const { chains, isClosed } = chainsOf(cells, circle, region)
  if (chains.length === 0) {
    const { x, y } = region.middle()
    return cells.contains(circle, x, y) ? [boundaryOf(region)] : []
  }
  return isClosed ? chains.map(({ pieces }) => pieces) : joined(cells, circle, new Ring(region), chains)
}

/** Sides of a cell inside the region that follow each other without a gap. */
interface Chain {
  readonly pieces: OutlinePiece[]
  /** The side of the region that it comes in by; `NONE` where rounding begins it at a vertex next to the boundary. */
  readonly cutFrom: number
  /** That which it leaves by, likewise. */
  cutTo: number
}

/** `isClosed`: the sides close by themselves, for the cell lies inside the region. */
function chainsOf(cells: Cells, circle: number, region: ConvexPolygon): { chains: Chain[]; isClosed: boolean } {
  const chains: Chain[] = []
  const sides = cells.sides(circle)
  let isLinked = false // whether the last chain goes on with the next side
  let firstIsAtOrigin = false // whether the first chain begins where its side begins
  for (const side of sides) {
    let goesOn = false
    for (const { curve, cutFrom, cutTo } of piecesOf(cells, side, region)) {
      const isAtOrigin = cutFrom === NONE
      if (!isLinked || !isAtOrigin) {
        if (chains.length === 0) firstIsAtOrigin = isAtOrigin && side === sides[0]
        chains.push({ pieces: [], cutFrom, cutTo })
      }
      isLinked = false
      goesOn = cutTo === NONE
      const chain = chains.at(-1) as Chain
      chain.pieces.push({ curve, side, neighbor: cells.neighborOf(side) })
      chain.cutTo = cutTo
    }
    isLinked = goesOn
  }
  if (!isLinked || !firstIsAtOrigin) return { chains, isClosed: false }
  if (chains.length === 1) return { chains, isClosed: true }
  const first = chains.shift() as Chain
  const last = chains.at(-1) as Chain
  last.cutTo = first.cutTo
  for (const piece of first.pieces) last.pieces.push(piece)
  return { chains, isClosed: false }
}

/**
 * The pieces of a side inside the region. Both sides of an edge are cut in the edge's own direction, so that the cells on
 * either side meet bit for bit.
 */
function piecesOf({ diagram }: Cells, side: number, region: ConvexPolygon): Part[] {
  const pieces = partsInside(edgeCurve(diagram, side >> 1), region)
  if (side % 2 === 0) return pieces
  return pieces.reverse().map(({ curve, cutFrom, cutTo }) => ({
    curve: reversed(curve),
    cutFrom: cutTo,
    cutTo: cutFrom,
  }))
}

/** A chain, and where on the ring it begins and ends. */
interface Passage {
  readonly pieces: OutlinePiece[]
  readonly entry: number
  readonly exit: number
}

function passageOf({ pieces, cutFrom, cutTo }: Chain, ring: Ring): Passage {
  const place = (cut: number, p: Point) => (cut === NONE ? ring.placeNear(p) : ring.placeOn(cut, p))
  const { curve: first } = pieces[0] as OutlinePiece
  const { curve: last } = pieces.at(-1) as OutlinePiece
  return { pieces, entry: place(cutFrom, first.start), exit: place(cutTo, last.end) }
}

/**
 * Along the ring exits and entries of the cell alternate. To pair the k-th exit with the k-th entry, or the one after it,
 * is right wherever rounding confuses the order of an exit and an entry next to each other; it takes a place to begin that
 * is neither, and is known to be inside the cell or not.
 */
function joined(cells: Cells, circle: number, ring: Ring, chains: readonly Chain[]): Outline {
  const passages = chains.map((chain) => passageOf(chain, ring))
  const begin = clearPlace(cells, circle, ring, passages)
  const beginsInside = leadAt(cells, circle, ring.at(begin)) > 0
  const ahead = (place: number) => (place < begin ? place + ring.total : place)
  const byExit = [...passages].sort((one, other) => ahead(one.exit) - ahead(other.exit))
  const byEntry = [...passages].sort((one, other) => ahead(one.entry) - ahead(other.entry))
  if (beginsInside) byEntry.push(byEntry.shift() as Passage)

  const next = new Map<Passage, Passage>()
  byExit.forEach((passage, k) => {
    const after = byEntry[k] as Passage
    next.set(passage, after)
    const isAround = beginsInside && k + 1 === passages.length
    const to = ahead(after.entry) + (isAround ? ring.total : 0)
    let last = (passage.pieces.at(-1) as OutlinePiece).curve.end
    for (const corner of ring.cornersBetween(ahead(passage.exit), to)) {
      appendSegment(passage.pieces, last, corner)
      last = corner
    }
    appendSegment(passage.pieces, last, (after.pieces[0] as OutlinePiece).curve.start)
  })

  const loops: OutlinePiece[][] = []
  const isDone = new Set<Passage>()
  for (const start of passages) {
    const loop: OutlinePiece[] = []
    for (let passage = start; !isDone.has(passage); passage = next.get(passage) as Passage) {
      isDone.add(passage)
      for (const piece of passage.pieces) loop.push(piece)
    }
    if (loop.length > 0) loops.push(loop)
  }
  return loops
}

/**
 * A place in one of the largest gaps between entries and exits: of several that where the cell's own circle and the others
 * differ most. One alone may lie on the boundary of both the region and the cell.
 */
function clearPlace(cells: Cells, circle: number, ring: Ring, passages: readonly Passage[]): number {
  const tried = 4
  const places = passages.flatMap(({ entry, exit }) => [entry, exit]).sort((one, other) => one - other)
  const gaps = places.map((start, i) => ({
    start,
    size: (places[i + 1] ?? (places[0] as number) + ring.total) - start,
  }))
  let best = -1
  let clear = 0
  for (const { start, size } of gaps.sort((one, other) => other.size - one.size).slice(0, tried)) {
    for (const share of [0.5, 0.3, 0.8]) {
      const place = (start + share * size) % ring.total
      const difference = Math.abs(leadAt(cells, circle, ring.at(place)))
      if (difference <= best) continue
      best = difference
      clear = place
    }
  }
  return clear
}

/** How much nearer the circle is to a point than its nearest neighbour. */
function leadAt(cells: Cells, circle: number, { x, y }: Point): number {
  let least = Number.POSITIVE_INFINITY
  for (const side of cells.sides(circle)) least = Math.min(least, cells.lead(circle, cells.neighborOf(side), x, y))
  return least
}

function boundaryOf(region: ConvexPolygon): OutlinePiece[] {
  const loop: OutlinePiece[] = []
  region.corners.forEach((corner, k) => {
    appendSegment(loop, corner, region.cornerAfter(k))
  })
  return loop
}

function appendSegment(loop: OutlinePiece[], from: Point, to: Point): void {
  if (from.x !== to.x || from.y !== to.y) loop.push({ curve: segment(from, to), side: NONE, neighbor: NONE })
}
