// SPDX-License-Identifier: GPL-3.0-or-later
// Circles on a globe. The slider makes all radii smaller by the same angle, and no border moves.
import { type Kind, list, Pen, said } from './scene.ts'
import { capsOf, drawCaps, drawGlobe } from './sphere.ts'

const MIDDLE = { x: 0, y: 0 }
const DEGREE = Math.PI / 180

export const globeRadii: Kind = {
  range: ({ circles }) => ({ last: largest(circles) / DEGREE, step: 'any' }),

  draw({ circles, ...scene }, value) {
    const pen = new Pen({ circles, ...scene })
    const [most, less] = [largest(circles), value * DEGREE]
    const isLast = most - less < 1e-6
    const caps = capsOf(circles, MIDDLE).map(({ center, r }) => ({ center, r: isLast ? r - most : r - less }))
    drawGlobe(pen, caps, MIDDLE)
    drawCaps(pen, caps, MIDDLE)
    const negative = caps.flatMap(({ r }, i) => (r < 0 ? [i] : []))
    const which = negative.length === 1 ? 'circle' : 'circles'
    const below =
      negative.length === 0 ? 'No radius is negative' : `The radii of ${which} ${list(negative)} are negative`
    const first = caps.findIndex(({ r }) => r === 0)
    const end = isLast ? `, and circle ${first} is a point` : ''
    return { content: pen.content, told: `All radii are ${said(value)}° smaller. ${below}${end}. No border has moved.` }
  },
}

function largest(circles: readonly { readonly r: number }[]): number {
  return Math.max(...circles.map(({ r }) => r))
}
