// SPDX-License-Identifier: GPL-3.0-or-later
// Sliders of the tutorial that change radii.
import { describe, expect, it } from 'vitest'
import { radiiOf } from '../../web/tutorial/sliders.ts'

/** The part of `<circle-voronoi>` that sliders use. New circles are visible once they are computed. */
class Figure {
  updateComplete: Promise<void> = Promise.resolve()
  #circles: Float64Array

  constructor(circles: readonly number[]) {
    this.#circles = Float64Array.from(circles)
  }

  get circles(): Float64Array<ArrayBuffer> {
    return this.#circles.slice()
  }

  set circles(circles: Iterable<number>) {
    this.updateComplete = this.updateComplete.then(() => {
      this.#circles = Float64Array.from(circles)
    })
  }

  /** Edits the circles like a reader. */
  edit(circles: readonly number[]): void {
    this.#circles = Float64Array.from(circles)
  }
}

const THREE = [0, 0, 4, 9, 0, 1, 3, 8, 2]

function sliding(changes: 'scale' | 'sum', start: number) {
  const figure = new Figure(THREE)
  return { figure, slide: radiiOf(figure as unknown as Parameters<typeof radiiOf>[0], changes, start) }
}

describe('a slider gives back the radii that were', () => {
  it('after it was at 0', async () => {
    const { figure, slide } = sliding('scale', 1)
    await slide(0)
    expect([...figure.circles]).toEqual([0, 0, 0, 9, 0, 0, 3, 8, 0])
    await slide(1)
    expect([...figure.circles]).toEqual(THREE)
  })

  it('where a circle was deleted at 0', async () => {
    const { figure, slide } = sliding('scale', 1)
    await slide(0)
    figure.edit([9, 0, 0, 3, 8, 0])
    await slide(1)
    expect([...figure.circles]).toEqual([9, 0, 1, 3, 8, 2])
  })

  it('where a circle was moved at 0', async () => {
    const { figure, slide } = sliding('scale', 1)
    await slide(0)
    figure.edit([0, 1, 0, 9, 0, 0, 3, 8, 0])
    await slide(1)
    expect([...figure.circles]).toEqual([0, 1, 4, 9, 0, 1, 3, 8, 2])
  })

  it('where a circle was added or changed', async () => {
    const { figure, slide } = sliding('scale', 1)
    await slide(0.5)
    figure.edit([0, 0, 2, 9, 0, 2, 3, 8, 1, 5, 5, 3])
    await slide(1)
    expect([...figure.circles]).toEqual([0, 0, 4, 9, 0, 4, 3, 8, 2, 5, 5, 6])
  })

  it.each([
    ['scale', 1],
    ['sum', 0],
  ] as const)('where it is faster than the figure: %s', async (changes, start) => {
    const { figure, slide } = sliding(changes, start)
    await Promise.all([0.5, 0.25, 2, 0, 4, start].map((value) => slide(value)))
    expect([...figure.circles]).toEqual(THREE)
  })
})
