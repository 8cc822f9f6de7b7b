// SPDX-License-Identifier: GPL-3.0-or-later
// The library's Newton steps toward cells of equal areas, with a plot of the error after each step.
import type { Circle } from '../../lib/index.ts'
import type { Regions } from '../../lib/wasm/regions.ts'
import { areaOf, areasIn, drawWeighted, type Frame, frameIn, weighted } from './areas.ts'
import { HEIGHT, type Kind, Pen, WIDTH } from './scene.ts'

const PLOT = { left: 104, right: WIDTH - 24, top: HEIGHT + 34, bottom: HEIGHT + 184 }
/** Range of the plotted errors, as powers of ten. */
const [HIGHEST, LOWEST] = [1, -12]

export interface Step {
  readonly error: number
  readonly weights: readonly number[]
}

export const newton: Kind = {
  height: HEIGHT + 220,
  hasRegions: true,
  range: (scene, _, regions) => ({
    last: Math.max(1, stepsOf(scene.circles, frameIn(new Pen(scene)), regions).steps.length - 1),
    step: 1,
  }),

  draw(scene, value, library, regions) {
    const { circles } = scene
    const pen = new Pen(scene)
    const frame = frameIn(pen)
    const { steps, problem } = stepsOf(circles, frame, regions)
    const k = Math.min(Math.floor(value), steps.length - 1)
    const [step, next] = [steps[k] as Step, steps[k + 1] ?? (steps[k] as Step)]
    // Weights change linearly between two steps.
    const weights = step.weights.map((weight, i) => weight + (value - k) * ((next.weights[i] as number) - weight))
    const diagram = weighted(circles, weights, library)
    drawWeighted(pen, frame, diagram, circles, { hasDiscs: false })
    const asked = areaOf(frame) / circles.length
    for (const [i, area] of areasIn(frame, diagram).entries()) {
      const off = Math.round(100 * (area / asked - 1))
      const { x, y } = circles[i] as Circle
      pen.write('label', { x, y: y - pen.units(22) }, `${off > 0 ? '+' : off < 0 ? '−' : '±'}${Math.abs(off)} %`)
    }
    plot(pen, steps, k)
    if (problem !== undefined) return { content: pen.content, told: problem }
    const now = k === 0 ? 'Before the first step' : `After step ${k} of ${steps.length - 1}`
    return {
      content: pen.content,
      told: `${now} the worst cell is off by ${errorSaid(step.error)} of its area.${k > 0 && k === steps.length - 1 ? ' That is as near as rounding allows.' : ''}`,
    }
  },
}

/** The last result. A slider requests the same sites again and again. */
let kept: { readonly key: string; readonly steps: readonly Step[]; readonly problem: string | undefined } | undefined

/** The steps of the library, beginning with the start. */
export function stepsOf(circles: readonly Circle[], frame: Frame, regions: Regions | undefined) {
  if (regions === undefined) throw new Error('This figure needs regions.')
  const key = JSON.stringify([circles, frame])
  if (kept?.key === key) return kept
  const { minX, minY, maxX, maxY } = frame
  const box = regions.region([
    [
      [minX, minY],
      [maxX, minY],
      [maxX, maxY],
      [minX, maxY],
    ],
  ])
  const steps: Step[] = []
  let problem: string | undefined
  try {
    regions.fitAreas(
      circles.map(({ x, y }) => [x, y] as const),
      circles.map(() => 1),
      {
        region: box,
        shares: true,
        tolerance: 1e-11,
        onStep: ({ error, weights }) => steps.push({ error, weights: [...weights] }),
      },
    )
  } catch (error) {
    if (steps.length === 0) {
      problem = (error as Error).message
      steps.push({ error: 1, weights: circles.map(() => 0) })
    }
  }
  kept = { key, steps, problem }
  return kept
}

/** Draws one bar per step, up from the lowest error shown. */
function plot(pen: Pen, steps: readonly Step[], now: number): void {
  const y = (error: number) => {
    const power = Math.log10(Math.max(error, 10 ** LOWEST))
    return PLOT.bottom - ((Math.min(power, HIGHEST) - LOWEST) / (HIGHEST - LOWEST)) * (PLOT.bottom - PLOT.top)
  }
  const width = (PLOT.right - PLOT.left) / steps.length
  for (const [power, text] of [
    [0, '100 %'],
    [-2, '1 %'],
    [-6, '10⁻⁶'],
    [-10, '10⁻¹⁰'],
  ] as const) {
    const at = y(10 ** power).toFixed(1)
    pen.raw(`<path class="axis" d="M${PLOT.left},${at}H${PLOT.right}"/>`)
    pen.raw(
      `<text class="label" x="${PLOT.left - 8}" y="${at}" text-anchor="end" dominant-baseline="central">${text}</text>`,
    )
  }
  for (const [k, { error }] of steps.entries()) {
    const top = y(error)
    // Steps have their numbers below, as long as these do not touch.
    if (width > 16 || k % 5 === 0)
      pen.raw(
        `<text class="label" x="${(PLOT.left + (k + 0.5) * width).toFixed(1)}" y="${PLOT.bottom + 20}" text-anchor="middle">${k}</text>`,
      )
    pen.raw(
      `<rect class="${k === now ? 'bar now' : 'bar'}" x="${(PLOT.left + k * width + 0.15 * width).toFixed(1)}" y="${top.toFixed(1)}" width="${(0.7 * width).toFixed(1)}" height="${Math.max(PLOT.bottom - top, 2).toFixed(1)}"/>`,
    )
  }
  pen.raw(`<text class="label" x="8" y="${HEIGHT + 20}">largest error</text>`)
  pen.raw(`<path class="axis" d="M${PLOT.left},${PLOT.bottom}H${PLOT.right}"/>`)
  pen.raw(`<text class="label" x="${PLOT.left - 8}" y="${PLOT.bottom + 20}" text-anchor="end">step</text>`)
}

function errorSaid(error: number): string {
  if (error >= 0.0005) return `${Number((100 * error).toPrecision(2))} %`
  const power = Math.floor(Math.log10(Math.max(error, 1e-16)))
  return `about ${[...`${power}`]
    .map((c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(c)]))
    .join('')
    .replace(/^/, '10')}`
}
