// SPDX-License-Identifier: GPL-3.0-or-later
// Below a figure with cells colored by a measure: the ramp of colors, with numbers.
import { drawLegend } from '../app/panels/legend.ts'
import type { CircleVoronoiElement } from '../element/index.ts'
import type { CircleVoronoi } from '../lib/index.ts'
import { loadLibrary } from '../lib/wasm/loader.ts'
import { isMeasure } from '../view/layers.ts'
import { Measures } from '../view/painter/measures.ts'
import { readStyle } from '../view/style.ts'

export function showLegends(page: Document): void {
  let library: Promise<CircleVoronoi> | undefined
  for (const place of page.querySelectorAll<HTMLElement>('.legend')) {
    const figure = place.closest('figure')?.querySelector('circle-voronoi') as CircleVoronoiElement
    void figure.ready.then(async () => {
      const { cells, maxDistance } = figure.layers
      if (cells === undefined || !isMeasure(cells)) return
      library ??= loadLibrary()
      // Edits do not change the meaning of the colors, in the legend as in the figure.
      const { legend } = new Measures(cells, (await library).compute(figure.circles), { maxDistance })
      const surface = figure.shadowRoot?.querySelector('.figure') as HTMLElement
      const draw = () => drawLegend(place, legend, readStyle(surface), place.dataset.unit)
      draw()
      for (const query of ['(prefers-color-scheme: dark)', '(forced-colors: active)'])
        matchMedia(query).addEventListener('change', draw)
    })
  }
}
