// SPDX-License-Identifier: GPL-3.0-or-later
// An arc of a border as a Bézier curve: both ends, the pulling point where the tangents meet, and its weight.
import { bezierPointAt } from '../../lib/curves/bezier.ts'
import { type BoundedCurve, bisector, type Point, pointAt, rationalBezier } from '../../lib/index.ts'
import { colorsOf, coordinatesOf, drawDiscs, type Kind, Pen, said } from './scene.ts'

/** Ends of the longest arc, as a parameter of the border. */
const LONGEST = 2.3
const SHORTEST = 1.1
const PIECES = 60

export const bezierArc: Kind = {
  range: () => ({ last: 1, step: 'any' }),

  draw(scene, value, library) {
    const { circles } = scene
    const coordinates = coordinatesOf(circles)
    const pen = new Pen(scene)
    const border = bisector(coordinates, 0, 1)
    const to = SHORTEST * (LONGEST / SHORTEST) ** value
    const curve: BoundedCurve = {
      bisector: border,
      from: 1 / to,
      to,
      start: pointAt(border, 1 / to),
      end: pointAt(border, to),
    }
    const { start, control, end, weight } = rationalBezier(curve)
    const arc = (w: number) => polyline((u) => bezierPointAt({ start, control, end, weight: w }, u))
    drawDiscs(pen, circles, colorsOf(library.compute(coordinates)))
    pen.segments(
      'line whole',
      polyline((u) => pointAt(border, (1.5 * LONGEST) ** (2 * u - 1))),
    )
    pen.line('way', start, control).line('way', control, end)
    pen.segments('parabola', arc(1)).segments('border', arc(weight))
    for (const [name, point] of [
      ['p₀', start],
      ['p₁', control],
      ['p₂', end],
    ] as const) {
      pen.dot('front', point, 5)
      // The arc passes the pulling point on the side of its ends.
      const [dx, dy] = point === control && control.x < (start.x + end.x) / 2 ? [-6, 14] : [14, 8]
      pen.write('label best', { x: point.x + pen.units(dx), y: point.y + pen.units(dy) }, name)
    }
    return {
      content: pen.content,
      told: `The weight of the pulling point p₁ is ${said(weight)}. The dashed curve has weight 1: it is a parabola.`,
    }
  },
}

/** Segments along a curve. */
function polyline(pointOf: (u: number) => Point): number[] {
  const points = Array.from({ length: PIECES + 1 }, (_, k) => pointOf(k / PIECES))
  return points.slice(1).flatMap(({ x, y }, k) => {
    const before = points[k] as Point
    return [before.x, before.y, x, y]
  })
}
