// SPDX-License-Identifier: GPL-3.0-or-later
import { at, circleOf, NONE } from '../base/diagram-data.ts'
import { CircleVoronoiError } from '../base/errors.ts'
import { between, cross, dot } from '../base/point.ts'
import { facing, largestOf, lengthOf, measuredIn, ROUNDING, turn, unitFor } from '../base/scale.ts'
import type { Point, Vector } from '../base/types.ts'
import { type BoundedCurve, curveOf, reversed, segment } from '../curves/curve.ts'
import { isKeptWhole, type Limits, partAtDistance, reachFrom } from './cell-limits.ts'
import type { Cells } from './cells.ts'
import { cutPart, HalfPlane, isPoint, isSame, movedOntoSides, type Part } from './clip.ts'
import { middleOf, roundingOf } from './measure.ts'
import type { OutlinePiece } from './outline-piece.ts'

/**
 * A piece with its curve also in the direction of its edge (`forward`). Points computed from `forward` are equal bit
 * for bit in both cells of the edge.
 */
export interface SharedPiece extends OutlinePiece {
  readonly forward: BoundedCurve
}

const AXES: readonly Vector[] = [
  { x: 1, y: 0 },
  { x: 0, y: 1 },
  { x: -1, y: 0 },
  { x: 0, y: -1 },
]
/** The radius of a cell without sides, as a multiple of the distance of the bounds. */
const FAR_OUT = 64
/**
 * Tolerance for the crossings of a line and a curve, relative to the size of the part that is clipped. If the two are
 * nearly tangent, a rounding error moves the crossing by the square root of that error.
 */
const SLACK = 2 ** -20
/** Largest angle between two directions whose order rounding may exchange on a narrow branch, in radians. */
const NEAR = 2 ** -20

/** Does what `Diagram.cellOutline` does, for arguments that have been checked. */
export function outlineOf(cells: Cells, circle: number, limits: Limits): readonly (readonly SharedPiece[])[] {
  if (!cells.exists(circle)) return []
  const { maxDistance } = limits
  const radius = maxDistance === undefined ? undefined : reachFrom(cells.diagram, circle, maxDistance)
  if (radius !== undefined && !(radius > 0)) return []
  if (isKeptWhole(cells.diagram, circle, cells.reach(circle), limits)) return [wholeLoop(cells, circle)]
  return new LoopCutter(cells, circle, limits, radius).run()
}

/** Returns the outline of a cell that the bounds contain, without clipping it. */
function wholeLoop(cells: Cells, circle: number): SharedPiece[] {
  const { diagram } = cells
  const pieces: SharedPiece[] = []
  const first = at(diagram.firstSide, circle)
  let side = first
  do {
    const forward = curveOf(diagram, side >> 1) as BoundedCurve
    const curve = side & 1 ? reversed(forward) : forward
    pieces.push({ curve, forward, side, neighbor: cells.neighborOf(side), r: 0 })
    side = at(diagram.nextSide, side)
  } while (side !== first)
  return pieces
}

/** @throws CircleVoronoiError `notCertified` */
function refuseOutline(circle: number): never {
  throw new CircleVoronoiError('notCertified', `The outline of cell ${circle} does not close.`, { circle })
}

/**
 * A piece of a loop. The pieces of an edge follow its direction, so that both cells of the edge cut it at the same
 * points, bit for bit.
 */
interface CutPiece {
  /** For a segment or an arc of a circle, only the ends count. */
  readonly part: Part
  /** The side of the cell; `NONE` for a segment or an arc. */
  readonly side: number
  /** The radius of an arc. */
  readonly r: number
  /** The side of the bounds on whose line a segment lies; `NONE` if it lies far outside. */
  readonly line: number
}

function isSegment({ side, r }: CutPiece): boolean {
  return side === NONE && r === 0
}

function isAgainst({ side }: CutPiece): boolean {
  return side !== NONE && side % 2 === 1
}

function startOf(piece: CutPiece): Point {
  return isAgainst(piece) ? piece.part.curve.end : piece.part.curve.start
}

function endOf(piece: CutPiece): Point {
  return isAgainst(piece) ? piece.part.curve.start : piece.part.curve.end
}

function cutStart(piece: CutPiece): number {
  return isAgainst(piece) ? piece.part.cutTo : piece.part.cutFrom
}

function cutEnd(piece: CutPiece): number {
  return isAgainst(piece) ? piece.part.cutFrom : piece.part.cutTo
}

function isPointOf(piece: CutPiece): boolean {
  return isPoint(piece.part) || (isSegment(piece) && isSame(startOf(piece), endOf(piece)))
}

/** A placeholder for pieces without a bisector. */
const NO_BISECTOR = segment({ x: 0, y: 0 }, { x: 1, y: 0 }).bisector

function pieceBetween(start: Point, end: Point, r: number, line: number): CutPiece {
  const curve = { bisector: NO_BISECTOR, from: 0, to: 0, start, end }
  return { part: { curve, cutFrom: NONE, cutTo: NONE }, side: NONE, r, line }
}

/** The part of a loop in a half-plane between an entry and the next exit. */
interface Chain {
  readonly pieces: CutPiece[]
  readonly entry: Point
  exit: Point
}

/**
 * A gap between a side that is cut off, far outside or by the circle, and the next side, as directions from the center.
 */
interface Gap {
  readonly from: Vector
  readonly to: Vector
  /** Whether the gap is a full turn or zero, up to rounding. */
  readonly isNear: boolean
  readonly sweep: number
}

/**
 * Returns a number that grows with the angle of v from the x axis, from 0 to 4 for a full turn; 0 for the zero vector.
 */
function pseudoAngle({ x, y }: Vector): number {
  const size = Math.abs(x) + Math.abs(y)
  const along = size > 0 ? x / size : 1
  return y >= 0 ? 1 - along : 3 + along
}

/** Returns the turn from u to v as a difference of pseudo-angles. It may be slightly below 0. */
function sweep(u: Vector, v: Vector): number {
  const difference = pseudoAngle(v) - pseudoAngle(u)
  return difference <= -1 ? difference + 4 : difference > 3 ? difference - 4 : difference
}

function negative({ x, y }: Vector): Vector {
  return { x: -x, y: -y }
}

function onAxis(middle: Point, r: number, k: number): Point {
  const axis = AXES[k] as Vector
  return { x: middle.x + r * axis.x, y: middle.y + r * axis.y }
}

/** Returns the quarter of the circle that contains a direction. A quarter includes its first axis only. */
function quarterOf({ x, y }: Vector): number {
  if (y >= 0) return x > 0 ? 0 : y > 0 ? 1 : 2
  return x < 0 ? 2 : 3
}

/** Returns the approximate distance that the chains reach from the line of a side. */
function extentOf(chains: readonly Chain[], half: HalfPlane): number {
  let extent = 0
  for (const { pieces } of chains) {
    for (const piece of pieces) extent = Math.max(extent, largestOf(between(half.from, startOf(piece))))
  }
  return extent
}

/**
 * A cell as a loop, cut by one line after the other. Every step is continuous, so a rounding error of a point moves the
 * result only slightly.
 */
class LoopCutter {
  readonly #cells: Cells
  readonly #circle: number
  readonly #limits: Limits
  /** The radius of the kept disc around the circle's center, if the limits have a distance. */
  readonly #radius: number | undefined
  readonly #center: Point
  readonly #halves: readonly HalfPlane[]
  #loops: CutPiece[][] = []
  /** Whether entries and exits have alternated along each line, and nothing far outside is left. */
  #isSound = true

  constructor(cells: Cells, circle: number, limits: Limits, radius: number | undefined) {
    this.#cells = cells
    this.#circle = circle
    this.#limits = limits
    this.#radius = radius
    const { x, y } = circleOf(cells.diagram.circles, circle)
    this.#center = { x, y }
    this.#halves = HalfPlane.of(limits.bounds)
  }

  run(): SharedPiece[][] {
    this.#begin()
    for (let h = 0; h < this.#halves.length && this.#loops.length > 0; h++) this.#cut(h)
    const outline = this.#loops.map((loop) => this.#finished(loop)).filter((loop) => loop.length > 0)
    if (!this.#isSound) refuseOutline(this.#circle)
    return outline
  }

  /**
   * Starts with the cell inside the disc of the maximum distance. Without a maximum distance, unbounded sides end far
   * outside and are joined around the bounds.
   */
  #begin(): void {
    const sides: CutPiece[] = []
    for (const side of this.#cells.sides(this.#circle)) {
      const part = partAtDistance(this.#cells.diagram, side >> 1, this.#limits)
      if (part !== undefined) sides.push({ part, side, r: 0, line: NONE })
    }
    if (sides.length > 0) {
      this.#loops.push(this.#closed(sides))
      return
    }
    const radius = this.#radius ?? FAR_OUT * this.#limits.bounds.reachFrom(this.#center)
    const loop: CutPiece[] = []
    const corner = (k: number) => onAxis(this.#center, radius, k % AXES.length)
    for (const k of AXES.keys()) this.#addStep(loop, corner(k), corner(k + 1))
    this.#loops.push(loop)
  }

  /** Joins the sides to a closed loop, counter-clockwise around the center, across the gaps between cut ends. */
  #closed(sides: readonly CutPiece[]): CutPiece[] {
    const { metric } = this.#cells.diagram
    let total = 0
    let radius = 0
    let nearest: Gap | undefined
    const middle = this.#pointIn(sides)
    const gaps = sides.map((piece, k): Gap | undefined => {
      const next = sides[(k + 1) % sides.length] as CutPiece
      total += this.#sweepOf(piece)
      if (cutEnd(piece) === NONE && cutStart(next) === NONE && isSame(endOf(piece), startOf(next))) return undefined
      let from = between(middle, endOf(piece))
      let to = between(middle, startOf(next))
      radius = Math.max(radius, lengthOf(from), lengthOf(to))
      // A cell of the power diagram is convex, so these directions stay in the cell from any of its points.
      if (metric === 'power') {
        const { across } = piece.part.curve.bisector
        const { across: nextAcross } = next.part.curve.bisector
        from = isAgainst(piece) ? negative(across) : across
        to = isAgainst(next) ? nextAcross : negative(nextAcross)
      }
      const unit = unitFor(Math.max(largestOf(from), largestOf(to)))
      const u = measuredIn(unit, from)
      const v = measuredIn(unit, to)
      const isNear = dot(u, v) > 0 && Math.abs(cross(u, v)) <= NEAR * dot(u, v)
      const turned = sweep(u, v)
      const gap = { from, to, isNear, sweep: !isNear && turned < 0 ? turned + 4 : turned }
      total += gap.sweep
      if (isNear && (nearest === undefined || gap.sweep < nearest.sweep)) nearest = gap
      return gap
    })
    radius = this.#radius ?? radius
    // Sides and gaps go around the center once. On a folded branch, the directions are only rounding.
    let full: Gap | undefined
    if (nearest !== undefined && total < 2 && metric !== 'power') {
      const { from } = nearest as Gap
      const share = radius / lengthOf(from)
      const opposite = { x: this.#center.x - share * from.x, y: this.#center.y - share * from.y }
      if (this.#cells.contains(this.#circle, opposite.x, opposite.y)) full = nearest
    }
    const loop: CutPiece[] = []
    sides.forEach((piece, k) => {
      loop.push(piece)
      const gap = gaps[k]
      if (gap === undefined) return
      let last = endOf(piece)
      let quarter = quarterOf(gap.from)
      const lastQuarter = quarterOf(gap.to)
      const isOneQuarter = quarter === lastQuarter && turn(gap.from, gap.to) >= 0
      if (gap === full || (!gap.isNear && !isOneQuarter)) {
        do {
          quarter = (quarter + 1) % AXES.length
          const next = onAxis(middle, radius, quarter)
          this.#addStep(loop, last, next)
          last = next
        } while (quarter !== lastQuarter)
      }
      this.#addStep(loop, last, startOf(sides[(k + 1) % sides.length] as CutPiece))
    })
    return loop
  }

  /**
   * Returns the angle that a side covers around the center. A branch around the center covers less than half a turn on
   * each side of its apex.
   */
  #sweepOf(piece: CutPiece): number {
    const { bisector, from, to } = piece.part.curve
    const u = between(this.#center, startOf(piece))
    const v = between(this.#center, endOf(piece))
    if (!(from < 1 && 1 < to) || !isSame(bisector.origin, this.#center)) return sweep(u, v)
    return sweep(u, bisector.along) + sweep(bisector.along, v)
  }

  #addStep(loop: CutPiece[], last: Point, next: Point): void {
    if (!isSame(last, next)) loop.push(pieceBetween(last, next, this.#radius ?? 0, NONE))
  }

  /**
   * Returns a point of the cell: its center, or for the power diagram, whose cells need not contain their centers, the
   * nearest end of a side.
   */
  #pointIn(sides: readonly CutPiece[]): Point {
    if (this.#cells.diagram.metric !== 'power') return this.#center
    const distance = (p: Point) => lengthOf(between(this.#center, p))
    return sides
      .flatMap((piece) => [startOf(piece), endOf(piece)])
      .reduce((nearest, p) => (distance(p) < distance(nearest) ? p : nearest))
  }

  /**
   * Cuts all loops by the line of a half-plane. From left to right as seen from outside, exits and entries alternate
   * along the line, and the first is an exit. So the k-th exit is joined to the k-th entry, even if rounding exchanges
   * exits and entries at the same place.
   */
  #cut(h: number): void {
    const half = this.#halves[h] as HalfPlane
    const loops: CutPiece[][] = []
    const chains: Chain[] = []
    for (const loop of this.#loops) this.#cutLoop(h, loop, loops, chains)
    this.#loops = loops
    if (chains.length === 0) return

    const exitOf = (chain: Chain) => half.place(chain.exit)
    const entryOf = (chain: Chain) => half.place(chain.entry)
    const byExit = [...chains].sort((one, other) => exitOf(one) - exitOf(other))
    const byEntry = [...chains].sort((one, other) => entryOf(one) - entryOf(other))
    const rounding = ROUNDING * Math.max(largestOf(this.#center), largestOf(half.from))
    const slack = SLACK * extentOf(chains, half) + rounding
    const next = new Map<Chain, Chain>()
    byExit.forEach((chain, k) => {
      const after = byEntry[k] as Chain
      const later = byExit[k + 1]
      next.set(chain, after)
      const isAhead = exitOf(chain) <= entryOf(after) + slack
      const isBeforeNext = later === undefined || entryOf(after) <= exitOf(later) + slack
      if (!isAhead || !isBeforeNext) this.#isSound = false
    })
    const isDone = new Set<Chain>()
    for (const first of chains) {
      if (isDone.has(first)) continue
      const loop: CutPiece[] = []
      for (let chain = first; !isDone.has(chain); chain = next.get(chain) as Chain) {
        isDone.add(chain)
        for (const piece of chain.pieces) loop.push(piece)
        const to = (next.get(chain) as Chain).entry
        if (!isSame(chain.exit, to)) loop.push(pieceBetween(chain.exit, to, 0, half.side))
      }
      this.#loops.push(loop)
    }
  }

  /** Adds a loop to `loops` if it is all inside, otherwise its parts to `chains`. */
  #cutLoop(h: number, loop: CutPiece[], loops: CutPiece[][], chains: Chain[]): void {
    const { side } = this.#halves[h] as HalfPlane
    const found: Chain[] = []
    let isLinked = false // whether the last chain goes on with the next piece
    let firstIsLinked = false // whether the first chain goes on from the last piece
    for (const piece of loop) {
      const kept = this.#cutPiece(h, piece)
      if (kept.length === 0) isLinked = false
      for (const rest of kept) {
        const isCut = cutStart(rest) === side
        if (isCut || !isLinked) {
          firstIsLinked ||= !isCut
          found.push({ pieces: [], entry: startOf(rest), exit: endOf(rest) })
        }
        isLinked = cutEnd(rest) !== side
        const chain = found.at(-1) as Chain
        chain.exit = endOf(rest)
        if (!isPointOf(rest)) chain.pieces.push(rest)
      }
    }
    if (isLinked && firstIsLinked) {
      if (found.length === 1) {
        loops.push(loop)
        return
      }
      const first = found.shift() as Chain
      const last = found.at(-1) as Chain
      last.exit = first.exit
      for (const piece of first.pieces) last.pieces.push(piece)
    }
    // A loop that touches the line from outside leaves only a point, which is dropped.
    for (const chain of found) if (chain.pieces.length > 0) chains.push(chain)
  }

  /** Returns the parts of a piece in a half-plane, in the order of the loop. */
  #cutPiece(h: number, piece: CutPiece): readonly CutPiece[] {
    const half = this.#halves[h] as HalfPlane
    if (piece.side !== NONE) {
      const parts = cutPart(piece.part, half)
      if (parts[0] === piece.part) return [piece]
      const { side, r, line } = piece
      const pieces = parts.map((part) => ({ part, side, r, line }))
      return isAgainst(piece) ? pieces.reverse() : pieces
    }
    const { start, end } = piece.part.curve
    const hasStart = half.height(start) >= 0
    const hasEnd = half.height(end) >= 0
    const partOf = (from: Point, to: Point): CutPiece => ({
      ...piece,
      part: {
        curve: { ...piece.part.curve, start: from, end: to },
        cutFrom: from === start ? piece.part.cutFrom : half.side,
        cutTo: to === end ? piece.part.cutTo : half.side,
      },
    })
    if (isSegment(piece)) {
      if (hasStart === hasEnd) return hasStart ? [piece] : []
      const p = { ...this.#crossingOf(h, piece) }
      return [hasStart ? partOf(start, p) : partOf(p, end)]
    }
    const { r } = piece
    const size = lengthOf(half.along)
    const along = measuredIn(size, half.along)
    const depth = half.height(this.#center) / size
    const toMiddle = hasStart ? { x: along.y, y: -along.x } : { x: -along.y, y: along.x }
    if (hasStart === hasEnd) {
      const turnsBack =
        turn(between(this.#center, start), toMiddle) > 0 &&
        turn(toMiddle, between(this.#center, end)) > 0 &&
        Math.abs(depth) < r
      if (!turnsBack) return hasStart ? [piece] : []
    }
    const foot = half.nearest(this.#center)
    const reach = Math.sqrt(Math.max(r - depth, 0)) * Math.sqrt(Math.max(r + depth, 0))
    const exit = { x: foot.x - reach * along.x, y: foot.y - reach * along.y }
    const entry = { x: foot.x + reach * along.x, y: foot.y + reach * along.y }
    if (hasStart && hasEnd) return [partOf(start, exit), partOf(entry, end)]
    return [partOf(hasStart ? start : entry, hasEnd ? end : exit)]
  }

  /**
   * Returns the point where a segment crosses the line. If the segment lies on an adjacent side, this is the shared
   * corner, bit for bit.
   */
  #crossingOf(h: number, piece: CutPiece): Point {
    const half = this.#halves[h] as HalfPlane
    const count = this.#halves.length
    const { start, end } = piece.part.curve
    const whole = between(start, end)
    for (const [other, corner] of [
      [(h + count - 1) % count, half.from],
      [(h + 1) % count, half.to],
    ] as const) {
      if (piece.line !== this.#halves[other]?.side) continue
      if (facing(between(start, corner), whole) <= 0) return start
      return facing(between(corner, end), whole) <= 0 ? end : corner
    }
    const first = half.height(start)
    const share = first / (first - half.height(end))
    return half.nearest({ x: start.x + share * whole.x, y: start.y + share * whole.y })
  }

  /** Returns whether a loop touches a line or lies along it from outside, up to rounding. */
  #isSliver(loop: readonly SharedPiece[]): boolean {
    if (loop.length === 0) return true
    const { rounding, hasArea } = roundingOf(loop, this.#center)
    if (hasArea) return false
    const isBeside = (half: HalfPlane, p: Point) => half.height(p) <= rounding
    return this.#halves.some((half) =>
      loop.every(({ curve, r }) => isBeside(half, curve.start) && (r > 0 || isBeside(half, middleOf(curve)))),
    )
  }

  /** Returns a loop as pieces of an outline; empty if the loop is a sliver. */
  #finished(loop: readonly CutPiece[]): SharedPiece[] {
    const moved = loop.map((piece) =>
      isSegment(piece) ? piece : { ...piece, part: movedOntoSides(piece.part, this.#halves) },
    )
    const isCut = moved.some((piece) => isSegment(piece) || piece.part.cutFrom >= 0 || piece.part.cutTo >= 0)
    if (moved.some((piece) => isSegment(piece) && piece.line === NONE)) this.#isSound = false
    const pieces = moved.flatMap((piece, k): SharedPiece[] => {
      if (piece.side !== NONE) {
        if (isPointOf(piece)) return []
        const forward = piece.part.curve
        const curve = isAgainst(piece) ? reversed(forward) : forward
        return [{ curve, forward, side: piece.side, neighbor: this.#cells.neighborOf(piece.side), r: 0 }]
      }
      let { start, end } = piece.part.curve
      if (isSegment(piece)) {
        const before = moved.at(k - 1) as CutPiece
        const after = moved[(k + 1) % moved.length] as CutPiece
        if (!isSegment(before)) start = endOf(before)
        if (!isSegment(after)) end = startOf(after)
      }
      if (isSame(start, end)) return []
      const curve = segment(start, end)
      return [{ curve, forward: curve, side: NONE, neighbor: NONE, r: piece.r }]
    })
    return isCut && this.#isSliver(pieces) ? [] : pieces
  }
}
