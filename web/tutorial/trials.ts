// SPDX-License-Identifier: GPL-3.0-or-later
import type { CircleVoronoiElement } from '../element/index.ts'

/** Checks the goals of exercises, and shows or hides the message of success. */
export function followTrials(page: ParentNode): void {
  for (const section of page.querySelectorAll<HTMLElement>('.try')) {
    const output = section.querySelector('figcaption output') as HTMLOutputElement
    const figure = section.querySelector('circle-voronoi') as CircleVoronoiElement
    figure.addEventListener('checkchange', ({ detail: { isMet } }) => {
      section.classList.toggle('done', isMet)
      output.value = isMet ? (output.dataset.done as string) : ''
    })
    section.querySelector<HTMLButtonElement>('button.show')?.addEventListener('click', ({ currentTarget }) => {
      figure.circles = JSON.parse((currentTarget as HTMLElement).dataset.circles as string)
      figure.scrollIntoView({ block: 'nearest' })
    })
  }
}
