// SPDX-License-Identifier: GPL-3.0-or-later
import { checkData, checkNoOptions } from '../base/check.ts'
import { at, circleOf } from '../base/diagram-data.ts'
import { between, cross, dot } from '../base/point.ts'
import { lengthOf } from '../base/scale.ts'
import type { Circle, DiagramData, Point } from '../base/types.ts'
import { pointOn, tangentNormal } from '../curves/tangent.ts'

/**
 * An arc of a circle on the convex hull, counter-clockwise from `start` to `end`. A point (radius 0) has an arc of
 * length zero with an angle.
 *
 * @category Questions
 */
export interface HullArc {
  readonly circle: number
  /** The radius of the circle, grown as described at `convexHull`. */
  readonly r: number
  readonly start: Point
  readonly end: Point
  /** The angle of the arc, from 0 to 2 pi. */
  readonly angle: number
}

/**
 * The convex hull of circles: arcs, each joined to the next by the tangent segment from its end to the start of the
 * next arc, and the last arc to the first. The angles add up to 2 pi.
 *
 * @category Questions
 */
export interface Hull {
  readonly arcs: readonly HullArc[]
  readonly length: number
  readonly area: number
}

const FULL_TURN = 2 * Math.PI
const THREE_QUARTER_TURN = 1.5 * Math.PI

/**
 * Returns the convex hull of the circles of a certified diagram, with its arcs in the order of `diagram.hull`. The hull
 * of a single circle is the circle itself: one arc with the angle 2 pi. For the metrics `centers` and `power`, it is
 * the hull of the centers. If weights on the hull are negative, all circles are first grown equally, until the smallest
 * weight on the hull is 0.
 *
 * @throws CircleVoronoiError `badInput`
 *
 * @category Questions
 * @example
 * convexHull(diagram).arcs.length // 3
 * convexHull(diagram).length.toFixed(4) // '30.2832'
 */
export function convexHull(diagram: DiagramData): Hull
export function convexHull(diagram: DiagramData, ...others: readonly unknown[]): Hull {
  checkNoOptions(others, 'convexHull')
  checkData(diagram, 'convexHull')
  const growth = hullGrowth(diagram)
  const circles = Array.from(diagram.hull, (circle) => hullCircleAt(diagram, circle, growth))
  const count = circles.length
  if (count === 0) return { arcs: [], length: 0, area: 0 }
  const circleOf = (step: number) => circles[(step + count) % count] as Circle
  let angles = [FULL_TURN]
  let normals = [{ x: 1, y: 0 }]
  if (count !== 1) {
    normals = circles.map((circle, step) => tangentNormal(circleOf(step - 1), circle))
    angles = turnedOnce(
      normals.map((normal, step) => {
        const out = normals[(step + 1) % count] as Point
        const angle = Math.atan2(cross(normal, out), dot(normal, out))
        return angle < 0 ? angle + FULL_TURN : angle
      }),
      circles.map(({ r }) => r),
    )
  }
  const arcs = circles.map((circle, step) => ({
    circle: at(diagram.hull, step),
    r: circle.r,
    start: pointOn(circle, normals[step] as Point),
    end: pointOn(circle, normals[(step + 1) % count] as Point),
    angle: angles[step] as number,
  }))

  let [perimeter, area] = [0, 0]
  arcs.forEach(({ start, end, angle }, step) => {
    const origin = (arcs[0] as HullArc).start
    const next = (arcs[(step + 1) % count] as HullArc).start
    const triangle = (p: Point, q: Point) => cross(between(origin, p), between(origin, q)) / 2
    const { r } = circleOf(step)
    perimeter += r * angle + lengthOf(between(end, next))
    area += triangle(start, end) + triangle(end, next) + (r * r * (angle - Math.sin(angle))) / 2
  })
  return { arcs, length: perimeter, area }
}

/** Returns the growth of all circles for the hull: 0, unless weights on the hull are negative. */
export function hullGrowth({ circles, hull }: DiagramData): number {
  return hull.reduce((growth, circle) => Math.max(growth, -at(circles, 3 * circle + 2)), 0)
}

/** Returns a circle as the hull uses it: grown by `hullGrowth`, or a point for the metrics `centers` and `power`. */
export function hullCircleAt({ circles, metric }: DiagramData, circle: number, growth: number): Circle {
  const { x, y, r } = circleOf(circles, circle)
  return { x, y, r: metric === 'circles' ? r + growth : 0 }
}

/**
 * Corrects angles so that they add up to one full turn. Rounding may turn an arc of almost no angle into almost a full
 * turn, or the reverse. Only the largest circle of the hull may have an arc of more than half a turn, because a circle
 * that reaches farthest in two opposite directions is as wide as any other circle.
 */
function turnedOnce(angles: readonly number[], radii: readonly number[]): number[] {
  const largest = radii.reduce((one, other) => Math.max(one, other))
  const result = angles.map((angle, step) => {
    const isFalse = (radii[step] as number) < largest && angle > THREE_QUARTER_TURN
    return isFalse ? 0 : angle
  })
  const sum = () => result.reduce((partial, angle) => partial + angle, 0)
  const widest = () => result.indexOf(result.reduce((one, other) => Math.max(one, other)))
  // The angles may be NaN if a program has changed the arrays.
  const turns = Number.isFinite(sum()) ? sum() / FULL_TURN : 1
  for (let excess = Math.round(turns) - 1; excess !== 0; excess -= Math.sign(excess)) {
    result[excess > 0 ? widest() : radii.indexOf(largest)] = excess > 0 ? 0 : FULL_TURN
  }
  // The missing angle was lost by rounding in arcs of almost no angle.
  ;(result[widest()] as number) += FULL_TURN - sum()
  return result
}
