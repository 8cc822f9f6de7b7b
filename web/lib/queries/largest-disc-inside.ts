// SPDX-License-Identifier: GPL-3.0-or-later

import { checkDiagram, checkMetric, checkOptionNames } from '../base/check.ts'
import { at, circleOf, edgeOf, NONE, vertexOf } from '../base/diagram-data.ts'
import { distanceFrom } from '../base/metric.ts'
import { between, dot, length } from '../base/point.ts'
import { lengthOf, ROUNDING, turn } from '../base/scale.ts'
import type { Point, Vector } from '../base/types.ts'
import { pointOf } from '../curves/bisector.ts'
import type { Diagram } from '../diagram/diagram.ts'
import { type ConvexBoundsOptions, ConvexPolygon } from '../regions/convex-polygon.ts'
import { keptParts } from '../regions/outline.ts'
import { type Region, regionOption } from '../regions/region.ts'
import { type EmptyDisc, largestEmptyDiscCenteredIn } from './largest-empty-disc.ts'

/** The relative rounding error of depths. */
const ROUNDING_OF_DEPTH = 2 ** -48
/** The largest relative difference of two distances that count as equal, from a circle and from a side. */
const ROUNDING_OF_PLACE = 2 ** -31

/**
 * Finds the largest empty disc that lies completely inside some bounds or a region. The disc may touch the boundary as
 * well as circles. Without circles, the result is the largest disc inside. If circles cover the region, the result is
 * that of `largestEmptyDiscCenteredIn`, with a radius that is not positive. The diagram must have the metric `circles`.
 * For bounds, the time is proportional to the number of circles times the number of sides.
 *
 * @throws CircleVoronoiError `badInput`, `badOption`
 *
 * @category Questions
 * @example
 * largestEmptyDiscInside(diagram, { bounds: [-2, -2, 8, 10] }).disc.r.toFixed(6) // '4.119661'
 */
export function largestEmptyDiscInside(
  diagram: Diagram,
  options: ConvexBoundsOptions | { readonly region: Region },
): EmptyDisc | undefined {
  const caller = 'largestEmptyDiscInside'
  checkDiagram(diagram, caller)
  checkMetric(diagram, caller, 'circles')
  checkOptionNames(options, caller, ['bounds', 'region'])
  const given = regionOption(options, caller)
  if (given !== undefined) return given.module.clip(diagram, undefined).largestEmptyDiscInside()
  // The radius of a disc is the smaller of two lengths: the distance from the nearest circle, and the depth in the
  // region. If circles alone bound the disc, it can grow inside a cell (away from the center) and along an edge (away
  // from the apex). If one circle and one side bound it, it can grow along the side. So the largest disc touches three
  // circles, two circles and a side, one circle and two sides, or sides alone. In the last two cases its center lies on
  // the medial axis of the region, which has about two segments for each side. All candidates are tried. Each is shrunk
  // until it is empty and inside, so rounding cannot make the result too large.
  const region = ConvexPolygon.of((options as ConvexBoundsOptions).bounds)
  const centered = largestEmptyDiscCenteredIn(diagram, { bounds: region })
  if (centered !== undefined && centered.disc.r <= 0) return centered
  const sides = sidesOf(region)
  const ridges = ridgesOf(region, sides)
  let best: EmptyDisc | undefined
  const radius = () => best?.disc.r ?? -Infinity
  /** The circle that was nearest last. A disc that it cuts needs no search for another one. */
  let nearest = NONE
  const gapOf = ({ x, y }: Point, circle: number) => (circle === NONE ? Infinity : distanceFrom(diagram, circle, x, y))
  const depthOf = (p: Point) => sides.reduce((least, side) => Math.min(least, depth(side, p)), Infinity)
  /** Tries the largest disc around a point, which should touch the given circles up to rounding. */
  const offer = (p: Point, ...circles: readonly number[]) => {
    const inside = depthOf(p)
    if (!(Math.min(inside, gapOf(p, nearest)) > radius())) return
    nearest = diagram.find(p.x, p.y, circles[0] ?? NONE)
    const empty = gapOf(p, nearest)
    const least = Math.min(inside, empty)
    if (least <= radius()) return
    if (circles[0] === undefined) {
      best = { disc: { x: p.x, y: p.y, r: least }, circles: empty > inside ? [] : [nearest] }
      return
    }
    const size = Math.abs(p.x) + Math.abs(p.y) + inside + Math.abs(circleOf(diagram.circles, circles[0]).r)
    if (!circles.includes(nearest) && gapOf(p, circles[0]) > empty + ROUNDING * size) return
    // The disc may touch sides only.
    const touched = empty > inside + ROUNDING * size + ROUNDING_OF_PLACE * inside ? [] : circles
    best = { disc: { x: p.x, y: p.y, r: least }, circles: touched }
  }

  // The first of equal discs is kept, so discs that touch most circles come first.
  for (let v = 0; v < diagram.vertices.length / 3; v++) {
    const { x, y, r: empty } = vertexOf(diagram, v)
    if (empty <= radius() || depthOf({ x, y }) < empty) continue
    best = { disc: { x, y, r: empty }, circles: [...diagram.vertexCircles.subarray(3 * v, 3 * v + 3)] }
  }
  for (let e = 0; e < diagram.edges.length / 4; e++) {
    const { left, right, start, end } = edgeOf(diagram, e)
    const radiusAt = (v: number) => (v === NONE ? Infinity : at(diagram.vertices, 3 * v + 2))
    // Along an edge the distance is largest at one of its ends.
    if (Math.max(radiusAt(start), radiusAt(end)) > radius()) {
      for (const p of placesAlongEdge(diagram, e, region, sides)) offer(p, left, right)
    }
  }
  for (const ridge of ridges) {
    offer(ridge.from)
    offer(ridge.to)
  }
  for (const ridge of ridges) {
    for (let i = 0; i < diagram.circles.length / 3; i++) {
      if (Math.max(ridge.depthFrom, ridge.depthTo) <= radius()) break
      if (!diagram.cells.exists(i)) continue
      for (const p of placesAlongRidge(diagram, i, ridge)) offer(p, i)
    }
  }
  return best
}

/** A side of the region as a line, with the region on the left. */
interface Side {
  readonly corner: Point
  /** Unit normal. */
  readonly inward: Vector
}

function depth({ corner, inward }: Side, p: Point): number {
  return dot(inward, between(corner, p))
}

/** Returns the sides of a region. Sides on one line are joined. */
function sidesOf(region: ConvexPolygon): Side[] {
  const directions = region.corners.map((corner, k) => between(corner, region.cornerAfter(k)))
  return region.corners.flatMap((corner, k) => {
    const direction = directions[k] as Vector
    const size = lengthOf(direction)
    if (turn(directions.at(k - 1) as Vector, direction) === 0) return []
    return [{ corner, inward: { x: -direction.y / size, y: direction.x / size } }]
  })
}

/**
 * A segment of the medial axis of the region: its points have the same depth from two sides and no smaller depth from
 * others.
 */
interface Ridge {
  readonly from: Point
  readonly to: Point
  readonly depthFrom: number
  readonly depthTo: number
}

/** Returns the medial axis. For each side, the part of the region nearest to it is cut out of the region. */
function ridgesOf(region: ConvexPolygon, sides: readonly Side[]): Ridge[] {
  const allowed = ROUNDING_OF_DEPTH * region.reachFrom(region.corner(0))
  return sides.flatMap((side, k) => {
    // `cut` is the side on the other side of the line from a corner to the next; k for a side of the region.
    let part = region.corners.map((point) => ({ point, cut: k }))
    sides.forEach((other, j) => {
      if (j === k) return
      const excess = (p: Point) => depth(side, p) - depth(other, p)
      part = part.flatMap((here, i) => {
        const next = part[(i + 1) % part.length] as typeof here
        const first = excess(here.point)
        const second = excess(next.point)
        const isKept = first <= allowed
        const kept = isKept ? [here] : []
        if (isKept === second <= allowed) return kept
        const share = Math.min(Math.max(first / (first - second), 0), 1)
        const x = here.point.x + share * (next.point.x - here.point.x)
        const y = here.point.y + share * (next.point.y - here.point.y)
        return [...kept, { point: { x, y }, cut: isKept ? j : here.cut }]
      })
    })
    return part.flatMap(({ point: from, cut }, i) => {
      const to = (part[(i + 1) % part.length] as { point: Point }).point
      // Each ridge belongs to two sides and is kept once.
      return cut <= k ? [] : [{ from, to, depthFrom: depth(side, from), depthTo: depth(side, to) }]
    })
  })
}

/**
 * Returns the centers of discs that touch the two circles of an edge and a side. Let n be the normal of the side, D the
 * depth of the curve's origin, and r the radius of its circle. Distance and depth are equal where
 *
 *     (P - Q) s^2 - 2 K s + (P + Q) = 0
 *
 * with P = c + |a| n . along, Q = b n . across, and K = D + r + c n . along + |a|. The discriminant is
 *
 *     K^2 - P^2 + Q^2 = (D + r) (D + r + 2 (c n . along + |a|)).
 */
function placesAlongEdge(diagram: Diagram, e: number, region: ConvexPolygon, sides: readonly Side[]): Point[] {
  const { left, right } = edgeOf(diagram, e)
  const radius = Math.min(circleOf(diagram.circles, left).r, circleOf(diagram.circles, right).r)
  return keptParts(diagram, e, { bounds: region, maxDistance: undefined }).flatMap(
    ({ curve: { bisector, from, to } }) =>
      sides.flatMap((side) => {
        const a = Math.abs(bisector.a)
        const c = bisector.apex + a
        const along = dot(side.inward, bisector.along)
        const p = c + a * along
        const q = bisector.b * dot(side.inward, bisector.across)
        const reach = depth(side, bisector.origin) + radius
        const bend = c * along + a
        return rootsOf(p - q, reach + bend, p + q, reach * (reach + 2 * bend))
          .filter((s) => s >= from * (1 - ROUNDING) && s <= to * (1 + ROUNDING))
          .map((s) => pointOf(bisector, s))
      }),
  )
}

/** Returns the centers of discs that touch a circle and the two sides of a ridge. */
function placesAlongRidge({ circles }: Diagram, circle: number, { from, to, depthFrom, depthTo }: Ridge): Point[] {
  const c = circleOf(circles, circle)
  const toFrom = between(c, from)
  const step = between(from, to)
  const reach = depthFrom + c.r
  const rise = depthTo - depthFrom
  const growth = (length(step) - rise) * (length(step) + rise)
  const half = reach * rise - dot(toFrom, step)
  const decay = (length(toFrom) - reach) * (length(toFrom) + reach)
  return rootsOf(growth, half, decay, half * half - growth * decay)
    .filter((u) => u >= -ROUNDING && u <= 1 + ROUNDING)
    .map((u) => Math.min(Math.max(u, 0), 1))
    .map((u) => ({ x: from.x + u * step.x, y: from.y + u * step.y }))
}

/** Solves u^2 growth - 2 u half + decay = 0. `discriminant` is half^2 - growth decay. */
function rootsOf(growth: number, half: number, decay: number, discriminant: number): number[] {
  if (!(discriminant >= 0)) return []
  const root = Math.sqrt(discriminant)
  const sum = half < 0 ? half - root : half + root
  return [sum / growth, decay / sum]
}
