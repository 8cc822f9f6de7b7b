// SPDX-License-Identifier: GPL-3.0-or-later

import { checkDiagram, checkMetric, checkNoOptions, checkOptionNames } from '../base/check.ts'
import { at, edgeOf, NONE, vertexOf } from '../base/diagram-data.ts'
import { distanceFrom } from '../base/metric.ts'
import { between, dot } from '../base/point.ts'
import type { DiagramData, Point, Vertex } from '../base/types.ts'
import { pointOf } from '../curves/bisector.ts'
import { pointOn, tangentNormal } from '../curves/tangent.ts'
import type { Diagram } from '../diagram/diagram.ts'
import { LineCrossing } from '../regions/clip.ts'
import { type ConvexBoundsOptions, ConvexPolygon } from '../regions/convex-polygon.ts'
import { hullCircleAt, hullGrowth } from '../regions/hull.ts'
import { keptParts } from '../regions/outline.ts'
import { type Region, regionOption } from '../regions/region.ts'

/**
 * A disc that touches circles but overlaps no circle.
 *
 * @category Questions
 */
export interface EmptyDisc {
  readonly disc: Vertex
  /** The circles that the disc touches, up to three. */
  readonly circles: readonly number[]
}

/**
 * Finds the largest empty disc whose center lies in some bounds or in a region: the point there that is farthest from
 * all circles. The disc may stick out. Its radius is negative if circles cover all points. Returns `undefined` if there
 * are no circles. The diagram must have the metric `circles`.
 *
 * @throws CircleVoronoiError `badInput`, `badOption`
 *
 * @category Questions
 * @example
 * largestEmptyDiscCenteredIn(diagram, { bounds: [0, 0, 6, 8] }).disc // { x: 6, y: 6.25, r: 5.25 }
 */
export function largestEmptyDiscCenteredIn(
  diagram: Diagram,
  options: ConvexBoundsOptions | { readonly region: Region },
): EmptyDisc | undefined {
  const caller = 'largestEmptyDiscCenteredIn'
  checkDiagram(diagram, caller)
  checkMetric(diagram, caller, 'circles')
  checkOptionNames(options, caller, ['bounds', 'region'])
  const given = regionOption(options, caller)
  if (given !== undefined) return given.module.clip(diagram, undefined).largestEmptyDisc()
  const region = ConvexPolygon.of((options as ConvexBoundsOptions).bounds)
  // In a cell, the distance from the nearest circle is convex along every line. Its maximum is therefore at a vertex,
  // at a corner, or where an edge crosses the boundary.
  const largest = new Largest(diagram)
  for (const corner of region.corners) {
    const nearest = diagram.find(corner.x, corner.y)
    if (nearest !== NONE) largest.offerAround(corner, nearest)
  }
  for (let v = 0; v < diagram.vertices.length / 3; v++) {
    if (region.contains(vertexOf(diagram, v))) largest.offerVertex(v)
  }
  for (let e = 0; e < diagram.edges.length / 4; e++) {
    const { left, right, start, end } = edgeOf(diagram, e)
    const radiusAt = (v: number) => (v === NONE ? Number.POSITIVE_INFINITY : at(diagram.vertices, 3 * v + 2))
    // Along an edge the distance is largest at one of its ends.
    if (Math.max(radiusAt(start), radiusAt(end)) <= largest.radius) continue
    for (const { curve, cutFrom, cutTo } of keptParts(diagram, e, { bounds: region, maxDistance: undefined })) {
      if (cutFrom !== NONE) largest.offerAround(curve.start, left, right)
      if (cutTo !== NONE) largest.offerAround(curve.end, left, right)
    }
  }
  return largest.best
}

/**
 * Finds the largest empty disc whose center lies in the convex hull of the circles. Its radius is not negative. Returns
 * `undefined` if there are no circles. The diagram must have the metric `circles`.
 *
 * @throws CircleVoronoiError `badInput`
 *
 * @category Questions
 * @example
 * const { x, y } = largestEmptyDiscCenteredInHull(diagram).disc
 * [x.toFixed(9), y.toFixed(9)] // [ '3.800000000', '4.600000000' ]
 */
export function largestEmptyDiscCenteredInHull(diagram: Diagram): EmptyDisc | undefined
export function largestEmptyDiscCenteredInHull(diagram: Diagram, ...others: readonly unknown[]): EmptyDisc | undefined {
  checkDiagram(diagram, 'largestEmptyDiscCenteredInHull')
  checkMetric(diagram, 'largestEmptyDiscCenteredInHull', 'circles')
  checkNoOptions(others, 'largestEmptyDiscCenteredInHull')
  const { cells, hull, vertices, edges, vertexSides } = diagram
  const largest = new Largest(diagram)
  if (hull.length === 0) return undefined
  const growth = hullGrowth(diagram)
  const grown = (circle: number) => hullCircleAt(diagram, circle, growth)
  if (hull.length === 1) {
    const circle = at(hull, 0)
    largest.offerTouch(pointOn(grown(circle), { x: 1, y: 0 }), growth, circle)
    return largest.best
  }

  // The part of the diagram outside the hull, beyond the tangent segment from circle i to circle j, is a tree that
  // hangs from infinity by an edge of i and j. Seen from there every circle's center is below the tangent line.
  // Therefore:
  //   - an edge is never parallel to the line: at such a point its two circles' centers would lie in one direction;
  //   - at a vertex one edge leads up and two lead down: above it the nearest circle is one of the two whose centers lie
  //     outermost, never the third, since the unit vectors from the centers to the vertex lie on a convex arc;
  //   - no edge crosses the normals at the points where the segment touches i and j: they belong to the cells of i and j.
  // So the edges that cross the segment are found by going down from infinity, each vertex outside once; the others are
  // inside the hull.
  const isOutside = new Uint8Array(vertices.length / 3)
  for (let top = 0; top < edges.length / 2; top++) {
    if (cells.originOf(top) !== NONE) continue
    // The unbounded side of i next to j belongs to the hull's step from i to j.
    const i = cells.circleOf(top)
    const circle = grown(i)
    const normal = tangentNormal(circle, grown(cells.neighborOf(top)))
    const touch = pointOn(circle, normal)
    largest.offerTouch(touch, growth, i)
    const pending = [top]
    for (let side = pending.pop(); side !== undefined; side = pending.pop()) {
      const { bisector, from, to } = cells.curveOf(side)
      const line = new LineCrossing(bisector, touch, { x: -normal.y, y: normal.x })
      const crossings = line.parameters.filter((s) => from < s && s < to)
      const target = cells.targetOf(side)
      // An edge that crosses the line twice leaves the hull again elsewhere.
      if (target !== NONE && crossings.length < 2 && dot(normal, between(touch, vertexOf(diagram, target))) > 0) {
        // Only rounding can lead to a vertex twice.
        if (isOutside[target] === 0) {
          isOutside[target] = 1
          for (const next of vertexSides.subarray(3 * target, 3 * target + 3))
            if (next !== (side ^ 1)) pending.push(next)
        }
      } else if (crossings[0] !== undefined) {
        largest.offerAround(pointOf(bisector, crossings[0]), cells.circleOf(side), cells.neighborOf(side))
      }
    }
  }
  isOutside.forEach((outside, v) => {
    if (outside === 0) largest.offerVertex(v)
  })
  return largest.best
}

/** Keeps the largest disc. */
class Largest {
  best: EmptyDisc | undefined
  readonly #diagram: DiagramData

  constructor(diagram: DiagramData) {
    this.#diagram = diagram
  }

  get radius(): number {
    return this.best?.disc.r ?? Number.NEGATIVE_INFINITY
  }

  offerVertex(v: number): void {
    this.#offer(vertexOf(this.#diagram, v), this.#diagram.vertexCircles.subarray(3 * v, 3 * v + 3))
  }

  /** Offers the disc around a point that touches the given circles. */
  offerAround({ x, y }: Point, ...circles: readonly number[]): void {
    this.#offer({ x, y, r: distanceFrom(this.#diagram, circles[0] as number, x, y) }, circles)
  }

  /** Offers a point on a circle that has grown by `growth`. */
  offerTouch({ x, y }: Point, growth: number, circle: number): void {
    this.#offer({ x, y, r: growth }, [circle])
  }

  #offer(disc: Vertex, circles: Iterable<number>): void {
    if (disc.r > this.radius) this.best = { disc, circles: [...circles] }
  }
}
