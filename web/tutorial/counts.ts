// SPDX-License-Identifier: GPL-3.0-or-later
import type { CircleVoronoiElement } from '../element/index.ts'
import { loadLibrary } from '../lib/wasm/loader.ts'
import { countSamples, sentenceOf } from './count-samples.ts'

/** Writes below each figure how many samples its circles get, and updates the counts when its slider moves. */
export async function sayCounts(page: ParentNode): Promise<void> {
  const library = await loadLibrary()
  for (const output of page.querySelectorAll<HTMLOutputElement>('output.counts')) {
    const around = output.closest('figure') as HTMLElement
    const figure = around.querySelector('circle-voronoi') as CircleVoronoiElement
    const say = () => {
      output.value = sentenceOf(countSamples(library, figure.circles, figure.layers.sampleCount ?? 1))
    }
    figure.addEventListener('circleschange', say)
    around.addEventListener('input', say)
    await figure.ready
    say()
  }
}
