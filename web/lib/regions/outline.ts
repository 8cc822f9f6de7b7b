// SPDX-License-Identifier: GPL-3.0-or-later
import { at, circleOf, NONE } from '../base/diagram-data.ts'
import { between } from '../base/point.ts'
import { lengthOf, ROUNDING } from '../base/scale.ts'
import type { Circle, Point } from '../base/types.ts'
import { type BoundedCurve, curveOf, reversed, seenFrom, segment } from '../curves/curve.ts'
import { isKeptWhole, keptParts, type Limits, reachFrom } from './cell-limits.ts'
import type { Cells } from './cells.ts'
import type { Part } from './clip.ts'
import type { ConvexPolygon } from './convex-polygon.ts'
import { areaOf } from './measure.ts'
import type { OutlinePiece } from './outline-piece.ts'
import { Ring, type RingElement } from './ring.ts'

/** A piece, and the same in the direction of its edge: what is made of that is the same to the bit in both of its cells. */
export interface SharedPiece extends OutlinePiece {
  readonly forward: BoundedCurve
}

/** Does what `Diagram.cellOutline` does, for arguments that have been checked. */
export function outlineOf(cells: Cells, circle: number, limits: Limits): readonly (readonly SharedPiece[])[] {
  if (!cells.exists(circle)) return []
  const { region, maxDistance } = limits
  let disc: Circle | undefined
  if (maxDistance !== undefined) {
    const { x, y } = circleOf(cells.diagram.circles, circle)
    disc = { x, y, r: reachFrom(cells.diagram, circle, maxDistance) }
    if (!(disc.r > 0)) return []
  }
  if (isKeptWhole(cells.diagram, circle, cells.reach(circle), limits)) return [wholeLoop(cells, circle, region)]
  const { chains, isClosed } = chainsOf(cells, circle, limits)
  if (isClosed) return chains.map(({ pieces }) => pieces)
  const ring = new Ring(region, disc)
  if (ring.elements.length === 0) return []
  if (chains.length === 0) {
    const { x, y } = ring.middle()
    return cells.contains(circle, x, y) ? [ring.elements.map(pieceOf)] : []
  }
  const loops = joined(cells, circle, ring, chains)
  // In a disc it is in one piece: what rounding cut off where several edges end next to the circle goes.
  if (loops.length < 2 || !ring.isCircle) return loops
  return [loops.reduce((one, other) => (areaOf([other]) > areaOf([one]) ? other : one))]
}

/** The outline of a cell that the region contains, without cutting it. */
function wholeLoop(cells: Cells, circle: number, region: ConvexPolygon): SharedPiece[] {
  const { diagram } = cells
  const pieces: SharedPiece[] = []
  const first = at(diagram.firstSide, circle)
  let side = first
  do {
    const whole = curveOf(diagram, side >> 1)
    const forward = seenFrom(whole, region.reachFrom(whole.bisector.origin)) as BoundedCurve
    const curve = side & 1 ? reversed(forward) : forward
    pieces.push({ curve, forward, side, neighbor: cells.neighborOf(side), r: 0 })
    side = at(diagram.nextSide, side)
  } while (side !== first)
  return pieces
}

/** Sides of a cell inside the region that follow each other without a gap. */
interface Chain {
  readonly pieces: SharedPiece[]
  /** The side of the region that it comes in by; `NONE` where rounding begins it at a vertex next to the boundary. */
  readonly cutFrom: number
  /** That which it leaves by, likewise. */
  cutTo: number
}

/** `isClosed`: the sides close by themselves, for the cell lies inside the region. */
function chainsOf(cells: Cells, circle: number, limits: Limits): { chains: Chain[]; isClosed: boolean } {
  const chains: Chain[] = []
  const sides = cells.sides(circle)
  let isLinked = false // whether the last chain goes on with the next side
  let firstIsAtOrigin = false // whether the first chain begins where its side begins
  for (const side of sides) {
    let goesOn = false
    for (const { curve, forward, cutFrom, cutTo } of piecesOf(cells, side, limits)) {
      const isAtOrigin = cutFrom === NONE
      if (!isLinked || !isAtOrigin) {
        if (chains.length === 0) firstIsAtOrigin = isAtOrigin && side === sides[0]
        chains.push({ pieces: [], cutFrom, cutTo })
      }
      isLinked = false
      goesOn = cutTo === NONE
      const chain = chains.at(-1) as Chain
      chain.pieces.push({ curve, forward, side, neighbor: cells.neighborOf(side), r: 0 })
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
function piecesOf({ diagram }: Cells, side: number, limits: Limits): (Part & Pick<SharedPiece, 'forward'>)[] {
  const pieces = keptParts(diagram, side >> 1, limits)
  if (side % 2 === 0) return pieces.map((part) => ({ ...part, forward: part.curve }))
  return pieces.reverse().map(({ curve, cutFrom, cutTo }) => ({
    curve: reversed(curve),
    forward: curve,
    cutFrom: cutTo,
    cutTo: cutFrom,
  }))
}

/** A chain, and where on the ring it begins and ends. */
interface Passage {
  readonly pieces: SharedPiece[]
  readonly entry: number
  readonly exit: number
}

function passageOf({ pieces, cutFrom, cutTo }: Chain, ring: Ring): Passage {
  const place = (cut: number, p: Point) => ring.placeNear(p, cut === NONE ? undefined : cut)
  const { curve: first } = pieces[0] as SharedPiece
  const { curve: last } = pieces.at(-1) as SharedPiece
  return { pieces, entry: place(cutFrom, first.start), exit: place(cutTo, last.end) }
}

/**
 * Along the ring exits and entries of the cell alternate. To pair the k-th exit with the k-th entry, or the one after it,
 * is right wherever rounding confuses the order of an exit and an entry next to each other; it takes a place to begin that
 * is neither, and is known to be inside the cell or not.
 */
function joined(cells: Cells, circle: number, ring: Ring, chains: readonly Chain[]): SharedPiece[][] {
  const passages = chains.map((chain) => passageOf(chain, ring))
  const { place: begin, isInside: beginsInside } = clearPlace(cells, circle, ring, passages)
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
    const start = (passage.pieces.at(-1) as SharedPiece).curve.end
    const end = (after.pieces[0] as SharedPiece).curve.start
    for (const part of ring.between(ahead(passage.exit), to, start, end)) passage.pieces.push(pieceOf(part))
  })

  const loops: SharedPiece[][] = []
  const isDone = new Set<Passage>()
  for (const start of passages) {
    const loop: SharedPiece[] = []
    for (let passage = start; !isDone.has(passage); passage = next.get(passage) as Passage) {
      isDone.add(passage)
      for (const piece of passage.pieces) loop.push(piece)
    }
    if (loop.length > 0) loops.push(loop)
  }
  return loops
}

/**
 * Returns a place in one of the largest gaps between entries and exits, and whether it is inside the cell: of several places
 * the deepest one, inside or outside. The largest gap alone may lie on the boundary of both the region and the cell. In a gap
 * that is only rounding, it is not known on which side of the entry or exit a place is.
 */
function clearPlace(
  cells: Cells,
  circle: number,
  ring: Ring,
  passages: readonly Passage[],
): { readonly place: number; readonly isInside: boolean } {
  const tried = 4
  const places = passages.flatMap(({ entry, exit }) => [entry, exit]).sort((one, other) => one - other)
  const gaps = places.map((start, i) => ({
    start,
    size: (places[i + 1] ?? (places[0] as number) + ring.total) - start,
  }))
  const largest = gaps.sort((one, other) => other.size - one.size).slice(0, tried)
  const neighbors = cells.neighbors(circle)
  let best = -1
  let clear = { place: 0, isInside: false }
  for (const { start, size } of largest.filter(({ size }, k) => k === 0 || size > ROUNDING * ring.total)) {
    for (const share of [0.5, 0.3, 0.8]) {
      const place = (start + share * size) % ring.total
      const depth = depthAt(cells, circle, neighbors, ring.at(place))
      if (Math.abs(depth) <= best) continue
      best = Math.abs(depth)
      clear = { place, isInside: depth > 0 }
    }
  }
  return clear
}

/**
 * Returns how much nearer the circle is to a point than any neighbor, as a share of the distance of their centers. The lead
 * over a far neighbor is rounded to more than the whole lead over a near one.
 */
function depthAt(cells: Cells, circle: number, neighbors: Int32Array, { x, y }: Point): number {
  const { circles } = cells.diagram
  const center = circleOf(circles, circle)
  let least = Number.POSITIVE_INFINITY
  for (const neighbor of neighbors) {
    const apart = lengthOf(between(circleOf(circles, neighbor), center))
    least = Math.min(least, cells.lead(circle, neighbor, x, y) / apart)
  }
  return least
}

function pieceOf({ start, end, r }: RingElement): SharedPiece {
  const curve = segment(start, end)
  return { curve, forward: curve, side: NONE, neighbor: NONE, r }
}
