// SPDX-License-Identifier: GPL-3.0-or-later
import type { CircleVoronoiElement } from '../element/index.ts'
import type { Layers } from '../view/layers.ts'

/** The formulas of the sliders: the new radius at a value, and the value that leaves radii unchanged. */
const SCALES = {
  scale: {
    at: (r: number, value: number) => r * value,
    back: (r: number, value: number) => (value > 0 ? r / value : undefined),
  },
  sum: {
    at: (r: number, value: number) => r + value,
    back: (r: number, value: number) => Math.max(0, r - value),
  },
}

/** The layers at a value of a slider. */
const LAYERS: Record<string, (value: number) => Partial<Layers>> = {
  dynamic: (sampleCount) => ({ candidates: 'dynamic', sampleCount }),
  uniform: (sampleCount) => ({ candidates: 'uniform', sampleCount }),
}

/** Connects sliders to their figures. Circles that the reader has dragged keep their places. */
export function slideFigures(page: Document): void {
  for (const slider of page.querySelectorAll<HTMLInputElement>('input[data-changes]')) {
    const figure = page.querySelector(`#${slider.dataset.figure} circle-voronoi`) as CircleVoronoiElement
    const changes = slider.dataset.changes as string
    const layersAt = LAYERS[changes]
    const slide =
      layersAt === undefined
        ? radiiOf(figure, changes as keyof typeof SCALES, slider.valueAsNumber)
        : (value: number) => {
            figure.layers = { ...figure.layers, ...layersAt(value) }
          }
    const output = slider.parentElement?.querySelector('output') as HTMLOutputElement
    slider.addEventListener('input', () => {
      output.value = `${Number(slider.valueAsNumber.toFixed(2))}`
      slide(slider.valueAsNumber)
    })
  }
}

/** Returns a function that changes all radii of `start` to a value of the slider. */
export function radiiOf(
  figure: Pick<CircleVoronoiElement, 'circles' | 'updateComplete'>,
  changes: keyof typeof SCALES,
  start: number,
): (value: number) => Promise<void> {
  const { at, back } = SCALES[changes]
  /** The circles at the value at which the slider changes nothing. */
  let base = new Float64Array()
  let before = start
  let underWay = 0
  return async (value) => {
    // A figure that is still computing reports the circles of an older slider value.
    if (underWay === 0) {
      const circles = figure.circles
      base = circles.map((number, k) =>
        k % 3 === 2 ? (back(number, before) ?? radiusIn(base, circles, k - 2) ?? number) : number,
      )
    }
    before = value
    figure.circles = base.map((number, k) => (k % 3 === 2 ? at(number, value) : number))
    underWay += 1
    await figure.updateComplete
    underWay -= 1
  }
}

/**
 * The original radius of a circle. Circles are matched by their centers, because indices shift when circles are
 * removed. A circle that was moved is matched by its index if the number of circles is unchanged.
 */
function radiusIn(base: Float64Array, circles: Float64Array, first: number): number | undefined {
  const isSame = (k: number) => base[k] === circles[first] && base[k + 1] === circles[first + 1]
  for (let k = 0; k < base.length; k += 3) if (isSame(k)) return base[k + 2]
  return base.length === circles.length ? base[first + 2] : undefined
}
