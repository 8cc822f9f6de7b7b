// SPDX-License-Identifier: GPL-3.0-or-later
// Sites in a box, joined by springs across their borders. A stronger spring means that area passes faster when weights
// change.
import type { Point } from '../../lib/index.ts'
import { areaOf, areasIn, drawWeighted, frameIn, percent, stiffnessIn, weighted } from './areas.ts'
import { type Kind, Pen, said } from './scene.ts'

/** Borders whose spring is weaker than this are left out. */
const SOFTEST = 1e-6
/** Pixels between two turns of a spring, and the amplitude of its turns. */
const TURN = 9
const WIDE = 6

export const springs: Kind = {
  range: ({ circles }) => ({ last: heaviestOf(circles), step: 'any' }),

  draw(scene, value, library) {
    const { circles } = scene
    const pen = new Pen(scene)
    const frame = frameIn(pen)
    const weights = circles.map((_, i) => (i === 0 ? value : 0))
    const diagram = weighted(circles, weights, library)
    drawWeighted(pen, frame, diagram, circles)
    const stiffness = stiffnessIn(frame, circles, weights, library)
    const hardest = Math.max(...circles.flatMap((_, i) => circles.map((_, j) => -(stiffness[i]?.[j] ?? 0))))
    for (const [i, a] of circles.entries()) {
      for (const [j, b] of circles.entries()) {
        const h = -(stiffness[i]?.[j] as number)
        if (j <= i || h < SOFTEST * hardest) continue
        pen.path(`spring s${Math.min(4, Math.ceil((5 * h) / hardest) - 1)}`, coil(pen, a, b))
      }
    }
    for (const [i, site] of circles.entries()) pen.write('number', { x: site.x, y: site.y + pen.units(14) }, `${i}`)
    const gain = 0.1 * ((stiffness[0]?.[0] as number) / areaOf(frame))
    const losses = circles.map((_, j) => (j === 0 ? 0 : -(stiffness[j]?.[0] as number)))
    const most = losses.indexOf(Math.max(...losses))
    const share = (areasIn(frame, diagram)[0] as number) / areaOf(frame)
    const exact = (part: number) => `${said(100 * part)} %`
    return {
      content: pen.content,
      told: `At weight ${said(value)} cell 0 has ${percent(share)} of the area. 0.1 more weight would add about ${exact(gain)}. ${exact((0.1 * (losses[most] as number)) / areaOf(frame))} would come from cell ${most}, across the strongest of its springs.`,
    }
  },
}

/** The largest weight at which the first site hides no other. */
function heaviestOf([first, ...others]: readonly Point[]): number {
  return first === undefined ? 1 : 0.9 * Math.min(...others.map(({ x, y }) => Math.hypot(x - first.x, y - first.y)))
}

function coil(pen: Pen, a: Point, b: Point): string {
  const length = Math.hypot(b.x - a.x, b.y - a.y)
  if (length === 0) return ''
  const [ux, uy] = [(b.x - a.x) / length, (b.y - a.y) / length]
  const turns = Math.max(4, 2 * Math.round(length / pen.units(TURN) / 2))
  const at = (part: number, aside: number) => {
    const along = part * length
    return `${(a.x + ux * along - uy * aside).toFixed(3)},${(a.y + uy * along + ux * aside).toFixed(3)}`
  }
  const wide = pen.units(WIDE)
  const middle = Array.from({ length: turns }, (_, k) =>
    at(0.15 + (0.7 * (k + 0.5)) / turns, k % 2 === 0 ? wide : -wide),
  )
  return `M${[at(0, 0), at(0.15, 0), ...middle, at(0.85, 0), at(1, 0)].join('L')}`
}
