// SPDX-License-Identifier: GPL-3.0-or-later
// A point and its distance to each circle. The slider colors more and more points of the plane by their nearest circle.
import type { Circle, Point } from '../../lib/index.ts'
import {
  colorsOf,
  coordinatesOf,
  distance,
  drawCells,
  drawDiscs,
  footOf,
  type Kind,
  nearest,
  Pen,
  said,
} from './scene.ts'

const MOST_POINTS = 600
/** Distance of a label from the point, in pixels. */
const CLEAR = 30
/** Distance of a label from its way, in pixels. */
const ASIDE = 24

export const nearestCircle: Kind = {
  range: () => ({ last: MOST_POINTS, step: 'any' }),

  draw(scene, value, library) {
    const { circles, point = { x: 0, y: 0 } } = scene
    const pen = new Pen(scene)
    const diagram = library.compute(coordinatesOf(circles))
    const colors = colorsOf(diagram)
    const isFull = value >= MOST_POINTS
    const [minX, minY, maxX, maxY] = pen.bounds
    if (isFull) drawCells(pen, diagram, colors)
    else {
      for (let k = 1; k <= value; k++) {
        const at = { x: minX + (maxX - minX) * radicalInverse(k, 2), y: minY + (maxY - minY) * radicalInverse(k, 3) }
        pen.dot(`c${colors[nearest(circles, at)]}`, at, 3)
      }
    }
    drawDiscs(pen, circles, colors)
    const first = nearest(circles, point)
    const distances = circles.map((circle) => said(distance(circle, point)))
    for (const [i, circle] of circles.entries()) {
      const foot = footOf(circle, point)
      pen.line(i === first ? `way best c${colors[i]}` : 'way', point, foot)
      pen.write(i === first ? 'label best' : 'label', labelPlace(pen, point, circle, foot), distances[i] as string)
    }
    pen.dot(`point c${colors[first]}`, point, 7)
    const others = circles.map((_, i) => `${distances[i]} to circle ${i}`).join(', ')
    return { content: pen.content, told: `The distances are ${others}. Circle ${first} is nearest.` }
  },
}

/** Beside the middle of a way, or beyond its rim if the way is so short that a label would hide the point. */
function labelPlace(pen: Pen, point: Point, circle: Circle, foot: Point): Point {
  const middle = { x: (point.x + foot.x) / 2, y: (point.y + foot.y) / 2 }
  const half = Math.hypot(middle.x - point.x, middle.y - point.y)
  if (half >= pen.units(CLEAR)) {
    const [nx, ny] = [(point.y - middle.y) / half, (middle.x - point.x) / half]
    const side = nx < 0 ? -1 : 1
    return { x: middle.x + side * nx * pen.units(ASIDE), y: middle.y + side * ny * pen.units(ASIDE) - pen.units(5) }
  }
  const [dx, dy] = [circle.x - point.x, circle.y - point.y]
  const length = Math.hypot(dx, dy) || 1
  const away = pen.units(CLEAR)
  return { x: point.x + (dx / length) * away, y: point.y + (dy / length) * away - pen.units(5) }
}

/** Point k of the van der Corput sequence. Every prefix of the sequence is evenly spread. */
function radicalInverse(k: number, base: number): number {
  let [rest, part, sum] = [k, 1, 0]
  while (rest > 0) {
    part /= base
    sum += part * (rest % base)
    rest = Math.floor(rest / base)
  }
  return sum
}
