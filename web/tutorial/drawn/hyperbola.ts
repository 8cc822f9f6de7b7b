// SPDX-License-Identifier: GPL-3.0-or-later
// A point on the border of two circles and its distances to both centers, with the other branch of the hyperbola.
import { bisector, type Circle, type Point, pointAt } from '../../lib/index.ts'
import { colorsOf, coordinatesOf, drawDiscs, footOf, type Kind, Pen, type Scene } from './scene.ts'

/** Ends of the drawn border and of the point's way, as parameters of the border. */
const WHOLE = 12
const WAY = 3
const PIECES = 120
/** Distance of a label from its segment, in pixels. */
const ASIDE = 16

export const hyperbola: Kind = {
  range: () => ({ last: 1, step: 'any' }),

  grip: {
    at: (scene, value) => borderOf(scene)?.(value) ?? (scene.circles[1] as Circle),
    valueAt(scene, place) {
      const border = borderOf(scene)
      if (border === undefined) return 0
      const away = (value: number) => {
        const { x, y } = border(value)
        return Math.hypot(x - place.x, y - place.y)
      }
      let best = 0
      for (let k = 1; k <= PIECES; k++) if (away(k / PIECES) < away(best)) best = k / PIECES
      for (let step = 1 / (2 * PIECES); step > 1e-4; step /= 2) {
        for (const value of [best - step, best + step]) if (away(value) < away(best)) best = value
      }
      return Math.min(Math.max(best, 0), 1)
    },
  },

  draw(scene, value, library) {
    const { circles } = scene
    const [a, b] = circles as readonly [Circle, Circle]
    const pen = new Pen(scene)
    const colors = colorsOf(library.compute(coordinatesOf(circles)))
    const border = borderOf(scene, WHOLE)
    if (border === undefined) {
      drawDiscs(pen, circles, colors, false)
      return { content: pen.content, told: 'One circle lies inside the other, so there is no border. Drag it out.' }
    }
    const point = (borderOf(scene) as (value: number) => Point)(value)
    const line = Array.from({ length: PIECES + 1 }, (_, k) => border(k / PIECES))
    drawDiscs(pen, circles, colors, false)
    pen.segments('whole ghost', segmentsOf(line.map((place) => mirrored(place, a, b))))
    pen.segments('border', segmentsOf(line))
    const lengths = [a, b].map((circle) => Math.hypot(point.x - circle.x, point.y - circle.y)) as [number, number]
    for (const [k, circle] of [a, b].entries()) {
      const foot = footOf(circle, point)
      pen.line('way', circle, foot).line(`way best c${colors[k]}`, foot, point)
      pen.dot('front', circle, 4)
      pen.write('label best', aside(pen, circle, point, k), fixed(lengths[k] as number))
      pen.write('number', { x: circle.x, y: circle.y - pen.units(24) }, 'ab'[k] as string)
    }
    pen.dot('point front', point, 7)
    const difference = `${fixed(lengths[0])} − ${fixed(lengths[1])} = ${short(lengths[0] - lengths[1])}`
    return {
      content: pen.content,
      told: `To the center a it is ${fixed(lengths[0])}, and to the center b ${fixed(lengths[1])}. ${difference} = radius of a − radius of b = ${short(a.r)} − ${short(b.r)}.`,
    }
  },
}

/** The place on the border at a value from 0 to 1; `undefined` if one circle contains the other. */
function borderOf({ circles }: Scene, reach = WAY): ((value: number) => Point) | undefined {
  const [a, b] = circles as readonly [Circle, Circle]
  if (Math.hypot(a.x - b.x, a.y - b.y) <= Math.abs(a.r - b.r)) return undefined
  const curve = bisector(coordinatesOf(circles), 0, 1)
  return (value) => pointAt(curve, reach ** (2 * value - 1))
}

/** The place on the other branch: mirrored at the line halfway between the centers. */
function mirrored({ x, y }: Point, a: Point, b: Point): Point {
  const [dx, dy] = [b.x - a.x, b.y - a.y]
  const along = ((x - (a.x + b.x) / 2) * dx + (y - (a.y + b.y) / 2) * dy) / (dx * dx + dy * dy)
  return { x: x - 2 * along * dx, y: y - 2 * along * dy }
}

/** The middle of the way outside a circle, moved off the line, away from the other way. */
function aside(pen: Pen, circle: Circle, point: Point, k: number): Point {
  const foot = footOf(circle, point)
  const [dx, dy] = [point.x - circle.x, point.y - circle.y]
  const length = Math.hypot(dx, dy)
  const side = (k === 0 ? 1 : -1) * (dy < 0 ? -1 : 1) * pen.units(ASIDE)
  return {
    x: (foot.x + point.x) / 2 - (dy / length) * side,
    y: (foot.y + point.y) / 2 + (dx / length) * side - pen.units(5),
  }
}

function segmentsOf(places: readonly Point[]): number[] {
  return places.slice(1).flatMap(({ x, y }, k) => {
    const { x: fromX, y: fromY } = places[k] as Point
    return [fromX, fromY, x, y]
  })
}

function fixed(length: number): string {
  return length.toFixed(1)
}

function short(value: number): string {
  return `${Number(value.toFixed(1))}`.replace('-', '−')
}
