// SPDX-License-Identifier: GPL-3.0-or-later
// Explains directed edges: arrows from one circle to another, with the border growing on their right.
import type { Circle } from '../../lib/index.ts'
import { arcBetween, frontOf } from './growing.ts'
import { colorsOf, coordinatesOf, drawDiscs, footOf, type Kind, Pen, said } from './scene.ts'

export const directedEdges: Kind = {
  range: ({ circles }) => ({ last: 4 * radiusBetween(circles), step: 'any' }),

  draw(scene, value, library) {
    const { circles } = scene
    const [a, b] = circles as [Circle, Circle]
    const least = radiusBetween(circles)
    const r = least + value
    const pen = new Pen(scene)
    drawDiscs(pen, circles, colorsOf(library.compute(coordinatesOf(circles))))
    const [forth, back] = [frontOf(a, b, r), frontOf(b, a, r)]
    const middle = { ...footOf(a, b), r: 0 }
    const start = { x: (middle.x + footOf(b, a).x) / 2, y: (middle.y + footOf(b, a).y) / 2, r: least }
    pen.disc('touching', start)
    for (const [from, to, front, name] of [
      [a, b, forth, '0→1'],
      [b, a, back, '1→0'],
    ] as const) {
      if (front === undefined) continue
      if (value > 0) pen.disc('touching good', front)
      pen.segments(`border growing ${name === '0→1' ? 'forth' : 'back'}`, arcBetween(from, to, start, front))
      pen.dot('front', front, 4)
      const [foot, other] = [footOf(from, start), footOf(to, start)]
      pen.arrow(`arrow ${name === '0→1' ? 'forth' : 'back'}`, foot, other, 7)
      const [dx, dy] = [to.x - from.x, to.y - from.y]
      const length = Math.hypot(dx, dy)
      const away = pen.units(24)
      pen.write(
        `label ${name === '0→1' ? 'forth' : 'back'}`,
        { x: start.x + (dy / length) * away - pen.units(26), y: start.y - (dx / length) * away - pen.units(5) },
        name,
      )
    }
    return {
      content: pen.content,
      told: `The smallest disc has radius ${said(least)}. At radius ${said(r)} the border has grown to the right of 0→1 and to the right of 1→0.`,
    }
  },
}

/** Radius of the smallest disc between the first two circles. */
function radiusBetween([a, b]: readonly Circle[]): number {
  if (a === undefined || b === undefined) return 0
  return (Math.hypot(a.x - b.x, a.y - b.y) - a.r - b.r) / 2
}
