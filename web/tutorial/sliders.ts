// SPDX-License-Identifier: GPL-3.0-or-later
import type { CircleVoronoiElement } from '../element/index.ts'
import type { Layers } from '../view/layers.ts'

/** The radius at a place of a slider, and what it would be where the slider changes nothing. */
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

/** What becomes of the layers at a place of a slider. */
const LAYERS: Record<string, (value: number) => Partial<Layers>> = {
  dynamic: (sampleCount) => ({ candidates: 'dynamic', sampleCount }),
  uniform: (sampleCount) => ({ candidates: 'uniform', sampleCount }),
}

/** Sliders beside figures; what a reader drags meanwhile stays as it is. */
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

/** Has a slider change all radii: what to do when it comes to a place, from `start`. */
export function radiiOf(
  figure: Pick<CircleVoronoiElement, 'circles' | 'updateComplete'>,
  changes: keyof typeof SCALES,
  start: number,
): (value: number) => Promise<void> {
  const { at, back } = SCALES[changes]
  /** Where the slider changes nothing. */
  let base = new Float64Array()
  let before = start
  let underWay = 0
  return async (value) => {
    // A figure that does not have its circles yet tells of older ones, from another place of the slider.
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
 * The radius that a circle had: that of the one with its center, for places in the list change when others go; where it was
 * moved and none came or went, that of the one at its place.
 */
function radiusIn(base: Float64Array, circles: Float64Array, first: number): number | undefined {
  const isSame = (k: number) => base[k] === circles[first] && base[k + 1] === circles[first + 1]
  for (let k = 0; k < base.length; k += 3) if (isSame(k)) return base[k + 2]
  return base.length === circles.length ? base[first + 2] : undefined
}
