// SPDX-License-Identifier: GPL-3.0-or-later
// A walk from the center of a circle to a point, with a plot of the distance to the nearest circle.
import {
  colorsOf,
  coordinatesOf,
  distance,
  drawCells,
  drawDiscs,
  HEIGHT,
  type Kind,
  nearest,
  Pen,
  said,
  WIDTH,
} from './scene.ts'

const STEPS = 160
/** The plot's place on the picture. */
const PLOT = { left: 56, right: WIDTH - 24, top: HEIGHT + 46, bottom: HEIGHT + 206 }
const WALK_HEIGHT = HEIGHT + 236

export const walk: Kind = {
  height: WALK_HEIGHT,
  range: () => ({ last: 1, step: 'any' }),

  draw(scene, value, library) {
    const { circles, point = { x: 0, y: 0 } } = scene
    const pen = new Pen(scene)
    const diagram = library.compute(coordinatesOf(circles))
    const colors = colorsOf(diagram)
    const start = circles[0] as (typeof circles)[number]
    const length = Math.hypot(point.x - start.x, point.y - start.y)
    const placeAt = (part: number) => ({
      x: start.x + part * (point.x - start.x),
      y: start.y + part * (point.y - start.y),
    })
    const best = (part: number) => {
      const at = placeAt(part)
      const i = nearest(circles, at)
      return { i, f: distance(circles[i] as (typeof circles)[number], at) }
    }
    drawCells(pen, diagram, colors)
    drawDiscs(pen, circles, colors)
    pen.line('trail', start, point).line('trail walked', start, placeAt(value)).dot('point', point, 7)
    pen.dot('walker', placeAt(value), 6)

    const steepest = length - start.r
    const samples = Array.from({ length: STEPS + 1 }, (_, k) => best(k / STEPS))
    const least = Math.min(-start.r, ...samples.map(({ f }) => f))
    const most = Math.max(steepest, 0.1)
    const x = (part: number) => PLOT.left + part * (PLOT.right - PLOT.left)
    const y = (f: number) => PLOT.bottom - ((f - least) / (most - least)) * (PLOT.bottom - PLOT.top)
    const at = (part: number, f: number) => `${x(part).toFixed(1)},${y(f).toFixed(1)}`
    pen.raw(`<path class="axis" d="M${at(0, least)}L${at(0, most)}M${at(0, 0)}L${at(1, 0)}"/>`)
    pen.raw(`<path class="bound" d="M${at(0, -start.r)}L${at(1, steepest)}"/>`)
    for (let k = 0; k < STEPS; k++) {
      const [from, to] = [samples[k], samples[k + 1]] as [(typeof samples)[number], (typeof samples)[number]]
      const d = `M${at(k / STEPS, from.f)}L${at((k + 1) / STEPS, to.f)}`
      pen.raw(`<path class="curve c${colors[from.i]}" d="${d}"/>`)
    }
    const now = best(value)
    pen.raw(`<circle class="walker" cx="${x(value).toFixed(1)}" cy="${y(now.f).toFixed(1)}" r="6"/>`)
    const word = (part: number, f: number, text: string, anchor: string, dy: number, dx = 0) =>
      pen.raw(
        `<text class="label" x="${(x(part) + dx).toFixed(1)}" y="${(y(f) + dy).toFixed(1)}" text-anchor="${anchor}">${text}</text>`,
      )
    word(0, 0, '0', 'end', 5, -8)
    word(0, -start.r, said(-start.r), 'end', 5, -8)
    word(0.6, steepest * 0.6 - start.r * 0.4, 'as fast as you walk', 'end', -12)
    pen.raw(`<text class="label" x="${PLOT.right}" y="${WALK_HEIGHT - 10}" text-anchor="end">distance walked</text>`)
    pen.raw(`<text class="label" x="8" y="${PLOT.top - 12}">distance f to the nearest circle</text>`)
    const walked = value * length
    return {
      content: pen.content,
      told: `At distance ${said(walked)} of the walk, circle ${now.i} is nearest, and f is ${said(now.f)}. If f had risen as fast as you walked, it would be ${said(walked - start.r)}.`,
    }
  },
}
