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
        ? radiiOf(figure, SCALES[changes as keyof typeof SCALES], slider.valueAsNumber)
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

/** Has a slider change all radii. */
function radiiOf(figure: CircleVoronoiElement, { at, back }: (typeof SCALES)['scale' | 'sum'], start: number) {
  /** Where the slider changes nothing. */
  let base: Float64Array | undefined
  let before = start
  return (value: number) => {
    const next = figure.circles.map((number, k) =>
      k % 3 === 2 ? (back(number, before) ?? base?.[k] ?? number) : number,
    )
    base = next
    before = value
    figure.circles = next.map((number, k) => (k % 3 === 2 ? at(number, value) : number))
  }
}
