// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts cells out of bounds. Exact signs decide which curves cross and in which order, and rounding only moves points.
// web/lib/README.md explains the steps.
import { at, circleOf, NONE } from '../base/diagram-data.ts'
import { compareSurds, coordinateOf, type Surd, surd, wholeOf } from '../base/exact.ts'
import { between, dot } from '../base/point.ts'
import type { DiagramData, Point } from '../base/types.ts'
import { parameterOf, pointOf } from '../curves/bisector.ts'
import { type BoundedCurve, curveOf, reversed, segment } from '../curves/curve.ts'
import { BisectorBorder, placeAlong } from './border-curve.ts'
import type { BorderEnd } from './border-end.ts'
import { type BorderPiece, CellBorder, refuseOutline, type SidePiece } from './cell-border.ts'
import { isKeptWhole, isOutside, type Limits, reachFrom } from './cell-limits.ts'
import { Cells } from './cells.ts'
import { CIRCLE_CUT, isSame, LineCrossing, type Part } from './clip.ts'
import { ClipLine } from './clip-line.ts'
import { CutPoint } from './cut-point.ts'
import type { OutlinePiece } from './outline-piece.ts'
import { TIE } from './sign-filter.ts'

/**
 * A piece with its curve also in the direction of its edge (`forward`). Points computed from `forward` are equal bit
 * for bit in both cells of the edge.
 */
export interface SharedPiece extends OutlinePiece {
  readonly forward: BoundedCurve
}

/** Does what `Diagram.cellOutline` does, for arguments that have been checked. */
export function outlineOf(cells: Cells, circle: number, limits: Limits): readonly (readonly SharedPiece[])[] {
  const { diagram } = cells
  if (!cells.exists(circle)) return []
  const { maxDistance } = limits
  if (maxDistance !== undefined && !(reachFrom(diagram, circle, maxDistance) > 0)) return []
  const reach = cells.reach(circle)
  if (isKeptWhole(diagram, circle, reach, limits)) return [wholeLoop(cells, circle)]
  if (isOutside(diagram, circle, reach, limits)) return []
  return new CellClip(cells, circle, limits).outline()
}

/** Returns the parts of an edge inside the limits, in the direction of the edge. */
export function keptParts(diagram: DiagramData, edge: number, limits: Limits): Part[] {
  const cells = new Cells(diagram)
  const left = cells.circleOf(2 * edge)
  return cells.exists(left) ? new CellClip(cells, left, limits).partsOf(2 * edge) : []
}

/** Returns the outline of a cell that the bounds contain, without clipping it. */
export function wholeLoop(cells: Cells, circle: number): SharedPiece[] {
  const { firstSide, nextSide } = cells.diagram
  const pieces: SharedPiece[] = []
  const first = at(firstSide, circle)
  let side = first
  do {
    const forward = curveOf(cells.diagram, side >> 1) as BoundedCurve
    const curve = side & 1 ? reversed(forward) : forward
    pieces.push({ curve, forward, side, neighbor: cells.neighborOf(side), r: 0 })
    side = at(nextSide, side)
  } while (side !== first)
  return pieces
}

/** A crossing of the border of a cell and a side of the bounds. */
interface Crossing {
  readonly piece: BorderPiece
  readonly line: ClipLine
  /** Whether the border leaves the bounds here, so that the boundary of the bounds enters the cell. */
  readonly leaves: boolean
  /** The vertex at the same place, if the shift decides on which side of it the crossing lies. */
  readonly vertex: BorderEnd | undefined
}

/** The place of a crossing: its point, and the parameter on the curve of its edge. */
interface Place {
  readonly point: Point
  readonly s: number
}

/** A stretch of a piece inside the bounds. Without crossings it reaches from end to end. */
interface Stretch {
  readonly piece: BorderPiece
  readonly enters: Crossing | undefined
  readonly leaves: Crossing | undefined
}

/** One cell, clipped. */
class CellClip {
  readonly #cells: Cells
  readonly #circle: number
  readonly #border: CellBorder
  readonly #radius: number
  readonly #lines: readonly ClipLine[]
  readonly #places = new Map<Crossing, Place>()

  constructor(cells: Cells, circle: number, limits: Limits) {
    this.#cells = cells
    this.#circle = circle
    this.#border = new CellBorder(cells, circle, limits)
    this.#radius = reachFrom(cells.diagram, circle, limits.maxDistance ?? 0)
    this.#lines = ClipLine.of(limits.bounds, this.#border.center)
  }

  outline(): SharedPiece[][] {
    const pieces = this.#border.pieces()
    if (pieces === undefined) return []
    const crossings = pieces.map((piece) => this.#crossingsOf(piece))
    const isCornerInside = pieces.every(({ line }) => line.sideOf(this.#lines[0] as ClipLine) > 0)
    if (crossings.every(({ length }) => length === 0)) {
      if (isCornerInside) return [this.#bounds()]
      const start = pieces[0]?.from
      const isInside = pieces.every(({ from, to }) => from !== undefined && to !== undefined) && this.#contains(start)
      const loop = isInside ? pieces.flatMap((piece) => this.#pieceBetween(piece, undefined, undefined)) : []
      return loop.length > 0 ? [loop] : []
    }
    // In the order of the border, beginning at a place outside if there is one at infinity.
    const begin = Math.max(
      pieces.findIndex(({ from }) => from === undefined),
      0,
    )
    const stretches: Stretch[] = []
    let isInside = this.#contains(pieces[begin]?.from)
    pieces.forEach((_, k) => {
      const i = (begin + k) % pieces.length
      const piece = pieces[i] as BorderPiece
      if (piece.from === undefined && isInside) refuseOutline(this.#circle)
      isInside = this.#addStretches(stretches, piece, crossings[i] as Crossing[], isInside)
    })
    if (isInside !== this.#contains(pieces[begin]?.from)) refuseOutline(this.#circle)
    return this.#joined(stretches, this.#boundary(crossings.flat(), isCornerInside))
  }

  /** Returns the parts of a side inside the limits, in its direction, which is that of its edge. */
  partsOf(side: number): Part[] {
    const piece = this.#border.partOf(side)
    if (piece === undefined) return []
    const stretches: Stretch[] = []
    this.#addStretches(stretches, piece, this.#crossingsOf(piece), this.#contains(piece.from))
    return stretches.flatMap(({ enters, leaves }): Part[] => {
      const curve = this.#curveBetween(piece, enters, leaves)
      const cutFrom = enters ? enters.line.side : piece.isCutFrom ? CIRCLE_CUT : NONE
      const cutTo = leaves ? leaves.line.side : piece.isCutTo ? CIRCLE_CUT : NONE
      if (isSame(curve.start, curve.end) && (cutFrom !== NONE || cutTo !== NONE)) return []
      return [{ curve, cutFrom, cutTo }]
    })
  }

  /** Returns whether the bounds contain an end of the border; not at infinity. */
  #contains(end: BorderEnd | undefined): boolean {
    if (end === undefined) return false
    const isAbove = this.#lines.map((corner) => end.isBelow(corner))
    let winding = 0
    this.#lines.forEach((line, k) => {
      const goesUp = isAbove[(k + 1) % isAbove.length] as boolean
      if (isAbove[k] !== goesUp && end.sideOf(line) > 0 === goesUp) winding += goesUp ? 1 : -1
    })
    return winding !== 0
  }

  /** Returns the crossings of a piece and the sides of the bounds. */
  #crossingsOf(piece: BorderPiece): Crossing[] {
    const { line: curve, from, to } = piece
    const crossings: Crossing[] = []
    const sides = this.#lines.map((corner) => curve.sideOf(corner))
    this.#lines.forEach((line, k) => {
      const after = (k + 1) % this.#lines.length
      const startsInCell = (sides[k] as number) > 0
      const endsInCell = (sides[after] as number) > 0
      const isChanged = startsInCell !== endsInCell
      // Both ends of the side are on the inner side of the curve, which is convex.
      if (!isChanged && (curve.isStraight || startsInCell === curve.isCellInside)) return
      const bulge = curve.isStraight ? 0 : curve.bulgeBeyond(line)
      if (bulge === 0) {
        if (!isChanged) return
        // Where the boundary leaves the cell, the border comes from the right side of the line.
        const before = startsInCell ? -1 : 1
        const isBefore = from === undefined || Math.sign(from.sideOf(line)) === before
        const isAfter = to === undefined || Math.sign(to.sideOf(line)) !== before
        if (!(isBefore && isAfter)) return
        const vertex = [from, to].find((end) => end !== undefined && Math.abs(end.sideOf(line)) === TIE)
        crossings.push({ piece, line, leaves: !startsInCell, vertex })
        return
      }
      // Both the curve and the line have a part before the first crossing (0), one between the two (1) and one after
      // the second (2).
      const corner = this.#lines[after] as ClipLine
      const partOf = (p: ClipLine, isInCell: boolean) =>
        isInCell === curve.isCellInside ? 1 : curve.isAheadOf(p, line) ? 0 : 2
      const fromPart = partOf(line, startsInCell)
      const toPart = partOf(corner, endsInCell)
      const firstLeaves = bulge < 0
      const isSameOrder = firstLeaves === curve.isCellInside
      const partOfEnd = (end: BorderEnd | undefined, atInfinity: number) => {
        if (end === undefined) return atInfinity
        if (Math.sign(end.sideOf(line)) === bulge) return 1
        const turn = curve.turnAfter(end, line)
        return turn === 0 ? atInfinity : turn > 0 === isSameOrder ? 0 : 2
      }
      const start = partOfEnd(from, 0)
      const end = partOfEnd(to, 2)
      const isOpposite = (end: BorderEnd | undefined) => end !== undefined && curve.turnAfter(end, line) === 0
      // An arc of length zero opposite the line.
      if (start === 0 && end === 2 && isOpposite(from) && isOpposite(to)) return
      for (const number of [0, 1]) {
        const onLine = isSameOrder ? number : 1 - number
        if (start <= number && number < end && fromPart <= onLine && onLine < toPart) {
          crossings.push({ piece, line, leaves: firstLeaves === (number === 0), vertex: undefined })
        }
      }
    })
    return crossings
  }

  /**
   * Sorts crossings where something begins, and those where it ends. They alternate, so each kind is sorted by itself:
   * the shift alone decides the order of two crossings of different kinds at one place.
   *
   * @throws CircleVoronoiError `notCertified`
   */
  #alternating(
    crossings: readonly Crossing[],
    begins: boolean,
    isInside: boolean,
    placeOf: (crossing: Crossing) => Surd,
  ): Crossing[] {
    if (crossings.length === 0) return []
    const sorted = (leaves: boolean) => {
      const found = crossings.filter((crossing) => crossing.leaves === leaves)
      if (found.length < 2) return found
      return found
        .map((crossing) => ({ crossing, place: placeOf(crossing) }))
        .sort((one, other) => compareSurds(one.place, other.place))
        .map(({ crossing }) => crossing)
    }
    const [starts, stops] = [sorted(begins), sorted(!begins)]
    const [first, second] = isInside ? [stops, starts] : [starts, stops]
    const rest = first.length - second.length
    if (rest !== 0 && rest !== 1) refuseOutline(this.#circle)
    return first.flatMap((crossing, k) => (second[k] === undefined ? [crossing] : [crossing, second[k]]))
  }

  /** Adds the stretches of a piece inside the bounds. Returns whether its end is inside. */
  #addStretches(stretches: Stretch[], piece: BorderPiece, crossings: readonly Crossing[], isInside: boolean): boolean {
    const placeOf = ({ line, leaves }: Crossing) => placeAlong(piece.line, line, piece.line.shareOf(line, !leaves))
    let enters: Crossing | undefined
    let isWithin = isInside
    for (const crossing of this.#alternating(crossings, false, isInside, placeOf)) {
      if (crossing.leaves) stretches.push({ piece, enters, leaves: crossing })
      else enters = crossing
      isWithin = !crossing.leaves
    }
    if (isWithin) stretches.push({ piece, enters, leaves: undefined })
    return isWithin
  }

  /** Returns the crossings along the boundary of the bounds, in order. */
  #boundary(crossings: readonly Crossing[], isCornerInside: boolean): Crossing[] {
    let isInside = isCornerInside
    const boundary = this.#lines.flatMap((line) => {
      const along = crossings.filter((crossing) => crossing.line === line)
      const placeOf = ({ piece, leaves }: Crossing) => piece.line.shareOf(line, !leaves)
      const sorted = this.#alternating(along, true, isInside, placeOf)
      isInside = sorted.at(-1)?.leaves ?? isInside
      return sorted
    })
    if (isInside !== isCornerInside) refuseOutline(this.#circle)
    return boundary
  }

  /** Joins stretches of the border, which are in order, to loops along the boundary of the bounds. */
  #joined(stretches: readonly Stretch[], boundary: readonly Crossing[]): SharedPiece[][] {
    const starts = new Map<Crossing, number>()
    stretches.forEach(({ enters }, k) => {
      if (enters !== undefined) starts.set(enters, k)
    })
    const places = new Map(boundary.map((crossing, k) => [crossing, k]))
    const isDone = new Set<number>()
    const loops: SharedPiece[][] = []
    for (const first of starts.values()) {
      const loop: SharedPiece[] = []
      for (let k = first; !isDone.has(k); ) {
        isDone.add(k)
        let stretch = stretches[k] as Stretch
        this.#addPiece(loop, stretch)
        while (stretch.leaves === undefined) {
          k = (k + 1) % stretches.length
          stretch = stretches[k] as Stretch
          if (stretch.enters !== undefined) refuseOutline(this.#circle)
          this.#addPiece(loop, stretch)
        }
        const place = places.get(stretch.leaves) as number
        const isLast = place + 1 === boundary.length
        const next = boundary[isLast ? 0 : place + 1] as Crossing
        this.#addBoundary(loop, stretch.leaves, next, isLast)
        k = starts.get(next) as number
      }
      if (loop.length > 0) loops.push(this.#fromFirstCorner(loop))
    }
    return loops
  }

  /** Returns a loop that begins at the first corner of the bounds, if it passes there. */
  #fromFirstCorner(loop: SharedPiece[]): SharedPiece[] {
    const { from } = this.#lines[0] as ClipLine
    const first = loop.findIndex(({ curve, side }) => side === NONE && isSame(curve.start, from))
    return first > 0 ? [...loop.slice(first), ...loop.slice(0, first)] : loop
  }

  #addPiece(loop: SharedPiece[], { piece, enters, leaves }: Stretch): void {
    for (const each of this.#pieceBetween(piece, enters, leaves)) loop.push(each)
  }

  /** Returns a part of a piece; nothing if cutting has left only a point. */
  #pieceBetween(piece: BorderPiece, enters: Crossing | undefined, leaves: Crossing | undefined): SharedPiece[] {
    const { side } = piece
    if (side === NONE) {
      const start = enters ? this.#placeOf(enters).point : (piece.from as BorderEnd).point
      const end = leaves ? this.#placeOf(leaves).point : (piece.to as BorderEnd).point
      return isSame(start, end) ? [] : [straightPiece(start, end, this.#radius)]
    }
    const its = piece as SidePiece
    const isBackward = side % 2 === 1
    const forward = this.#curveBetween(its, isBackward ? leaves : enters, isBackward ? enters : leaves)
    const isCut = enters !== undefined || leaves !== undefined || its.isCutFrom || its.isCutTo
    if (isCut && isSame(forward.start, forward.end)) return []
    const curve = isBackward ? reversed(forward) : forward
    return [{ curve, forward, side, neighbor: this.#cells.neighborOf(side), r: 0 }]
  }

  /** Returns the part of the curve of an edge between two crossings, or up to its ends. */
  #curveBetween({ forward }: SidePiece, first: Crossing | undefined, last: Crossing | undefined): BoundedCurve {
    const { bisector } = forward
    let { from, to, start, end } = forward
    if (first !== undefined) ({ s: from, point: start } = this.#placeOf(first))
    if (last !== undefined) ({ s: to, point: end } = this.#placeOf(last))
    // Rounding has exchanged ends that are at one place.
    if (from > to) from = to = Math.sqrt(from) * Math.sqrt(to)
    if (start === undefined || end === undefined) refuseOutline(this.#circle)
    return { bisector, from, to, start, end }
  }

  /** Adds the boundary from one crossing to the next, through the first corner if `isAround`. */
  #addBoundary(loop: SharedPiece[], from: Crossing, to: Crossing, isAround: boolean): void {
    let last = this.#placeOf(from).point
    const addTo = (next: Point) => {
      if (!isSame(last, next)) loop.push(straightPiece(last, next, 0))
      last = next
    }
    const count = this.#lines.length
    let line = from.line.side
    if (isAround && line === to.line.side) {
      addTo(from.line.to)
      line = (line + 1) % count
    }
    for (; line !== to.line.side; line = (line + 1) % count) addTo((this.#lines[line] as ClipLine).to)
    addTo(this.#placeOf(to).point)
  }

  #bounds(): SharedPiece[] {
    return this.#lines.map(({ from, to }) => straightPiece(from, to, 0))
  }

  #placeOf(crossing: Crossing): Place {
    let place = this.#places.get(crossing)
    if (place === undefined) {
      const { piece } = crossing
      place = piece.side === NONE ? this.#placeOnRim(crossing) : this.#placeOnSide(crossing, piece as SidePiece)
      this.#places.set(crossing, place)
    }
    return place
  }

  /** Both cells of the edge find the same place, bit for bit. */
  #placeOnSide({ line, leaves, vertex }: Crossing, piece: SidePiece): Place {
    const { forward, side } = piece
    const { bisector } = forward
    const clamped = (s: number) => Math.min(Math.max(s, forward.from), forward.to)
    const { from, to } = line
    if (vertex !== undefined && (vertex === piece.from) !== (side % 2 === 1))
      return { point: vertex.point, s: forward.from }
    if (vertex !== undefined) return { point: vertex.point, s: forward.to }
    const direction = { x: line.dx, y: line.dy }
    const found = new LineCrossing(bisector, from, direction)
    const s = found.crossing(leaves === (side % 2 === 0))
    if (s !== undefined && found.isCertainAt(s)) {
      const seen = pointOf({ ...bisector, origin: between(from, bisector.origin) }, clamped(s))
      const share = dot(seen, direction) / dot(direction, direction)
      if (isBetweenEnds(share)) return { point: pointOnSide(line, share), s: clamped(s) }
    }
    // Seen from the left cell of the edge.
    const { diagram } = this.#cells
    const isLeft = side % 2 === 0
    const left = this.#cells.circleOf(side & ~1)
    const curve = new BisectorBorder(diagram, left, this.#cells.circleOf(side | 1))
    const center = circleOf(diagram.circles, left)
    const point = exactPoint(from, to, curve.shareOf(new ClipLine(line.side, from, to, center), leaves !== isLeft))
    const seen = CutPoint.seenFrom(bisector.origin, point)
    return { point, s: clamped(parameterOf({ ...bisector, origin: ORIGIN }, seen.x, seen.y)) }
  }

  #placeOnRim({ line, leaves, piece }: Crossing): Place {
    const { from, to, x, y, dx, dy } = line
    const size = Math.sqrt(dx * dx + dy * dy)
    const height = (dx * y - dy * x) / size
    const depth = Math.abs(height)
    const half = Math.sqrt(Math.max(this.#radius - depth, 0)) * Math.sqrt(this.#radius + depth)
    const scale = this.#radius + Math.abs(x) + Math.abs(y)
    // The boundary leaves the cell where the border enters the bounds.
    const share = ((leaves ? -half : half) - (dx * x + dy * y) / size) / size
    const isCertain = scale * this.#radius < 2 ** 6 * size * half
    const point =
      isCertain && isBetweenEnds(share)
        ? pointOnSide(line, share)
        : exactPoint(from, to, piece.line.shareOf(line, !leaves))
    return { point, s: 1 }
  }
}

const ORIGIN: Point = { x: 0, y: 0 }

/** Next to its ends, the points of a side are exact. */
function isBetweenEnds(share: number): boolean {
  return share > 2 ** -30 && share < 1 - 2 ** -30
}

function pointOnSide({ from, dx, dy }: ClipLine, share: number): Point {
  return CutPoint.after(from, { x: share * dx, y: share * dy })
}

/** Returns the point at a share of the way between two corners, rounded. */
function exactPoint(from: Point, to: Point, { p, q, d, w }: Surd): Point {
  const coordinate = (first: number, last: number) => {
    const start = wholeOf(first)
    const step = wholeOf(last) - start
    const exact = surd(start * w + step * p, step * q, d, w)
    const rounded = coordinateOf(exact)
    return [rounded, coordinateOf({ ...exact, p: exact.p - wholeOf(rounded) * exact.w })] as const
  }
  const [x, restX] = coordinate(from.x, to.x)
  const [y, restY] = coordinate(from.y, to.y)
  return new CutPoint(x, y, { x: restX, y: restY })
}

function straightPiece(start: Point, end: Point, r: number): SharedPiece {
  const curve = segment(start, end)
  return { curve, forward: curve, side: NONE, neighbor: NONE, r }
}
