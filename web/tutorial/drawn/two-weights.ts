// SPDX-License-Identifier: GPL-3.0-or-later
// Two sites in a box, with a plot of the concave function of the second weight. Its maximum has the prescribed areas.
import { areaOf, areasIn, drawWeighted, frameIn, heightOver, percent, weighted, writeShares } from './areas.ts'
import { HEIGHT, type Kind, Pen, said, WIDTH } from './scene.ts'

/** The prescribed shares of the area. */
export const TWO_SHARES = [0.35, 0.65] as const
const SAMPLES = 120
const PLOT = { left: 24, right: WIDTH - 24, top: HEIGHT + 34, bottom: HEIGHT + 184 }
/** Half the length of the drawn tangent, in pixels. */
const SLOPE = 70

export const twoWeights: Kind = {
  height: HEIGHT + 220,
  range: ({ circles }) => ({ last: 2 * reachOf(circles), step: 'any' }),

  draw(scene, value, library) {
    const { circles } = scene
    const pen = new Pen(scene)
    const frame = frameIn(pen)
    const reach = reachOf(circles)
    const weight = value - reach
    const diagram = weighted(circles, [0, weight], library)
    drawWeighted(pen, frame, diagram, circles)
    const shares = areasIn(frame, diagram).map((area) => area / areaOf(frame))
    writeShares(pen, circles, shares, TWO_SHARES)

    const height = heightOver(frame, circles, TWO_SHARES)
    const heights = Array.from({ length: SAMPLES + 1 }, (_, k) => height([0, reach * ((2 * k) / SAMPLES - 1)]))
    const [least, most] = [Math.min(...heights), Math.max(...heights)]
    const x = (at: number) => PLOT.left + ((at + reach) / (2 * reach)) * (PLOT.right - PLOT.left)
    const y = (f: number) => PLOT.bottom - ((f - least) / (most - least || 1)) * (PLOT.bottom - PLOT.top)
    const points = heights.map((f, k) => `${x(reach * ((2 * k) / SAMPLES - 1)).toFixed(1)},${y(f).toFixed(1)}`)
    pen.raw(`<path class="axis" d="M${PLOT.left},${PLOT.bottom}H${PLOT.right}"/>`)
    pen.raw(`<path class="curve" d="M${points.join('L')}"/>`)
    const missing = TWO_SHARES[1] - (shares[1] as number)
    const now = { x: x(weight), y: y(height([0, weight])) }
    const rise = -missing * ((PLOT.bottom - PLOT.top) / (most - least || 1)) * ((2 * reach) / (PLOT.right - PLOT.left))
    const run = SLOPE / Math.hypot(1, rise)
    pen.raw(
      `<path class="slope" d="M${(now.x - run).toFixed(1)},${(now.y - run * rise).toFixed(1)}L${(now.x + run).toFixed(1)},${(now.y + run * rise).toFixed(1)}"/>`,
    )
    pen.raw(`<circle class="walker" cx="${now.x.toFixed(1)}" cy="${now.y.toFixed(1)}" r="6"/>`)
    pen.raw(`<text class="label" x="8" y="${HEIGHT + 22}">height of the curve</text>`)
    pen.raw(`<text class="label" x="${PLOT.right}" y="${PLOT.bottom + 22}" text-anchor="end">weight of site 1</text>`)
    const slope =
      Math.abs(missing) < 0.005
        ? 'The slope is 0: this is the top, and both areas are right.'
        : missing > 0
          ? `The cell lacks ${percent(missing)}, so the curve rises.`
          : `The cell has ${percent(-missing)} too much, so the curve falls.`
    return {
      content: pen.content,
      told: `At weight ${said(weight)} cell 1 has ${percent(shares[1] as number)} of the area; the goal is ${percent(TWO_SHARES[1])}. ${slope}`,
    }
  },
}

/** The weight beyond which one of the cells is hidden. */
function reachOf([a, b]: readonly { readonly x: number; readonly y: number }[]): number {
  return a === undefined || b === undefined ? 1 : 1.15 * Math.max(Math.hypot(a.x - b.x, a.y - b.y), 1)
}
