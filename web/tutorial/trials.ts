// SPDX-License-Identifier: GPL-3.0-or-later
import type { CircleVoronoiElement } from '../element/index.ts'

/** Shows the goals of exercises and the message of success, and undoes and resets their figures. */
export function followTrials(page: ParentNode): void {
  for (const section of page.querySelectorAll<HTMLElement>('.try')) {
    const output = section.querySelector('figcaption output') as HTMLOutputElement
    const figure = section.querySelector('circle-voronoi') as CircleVoronoiElement
    const now = section.querySelector('.now') as HTMLElement
    figure.addEventListener('goalschange', ({ detail: { text } }) => {
      now.textContent = text
    })
    // The reader has not solved what the page has shown.
    let isShown = false
    figure.addEventListener('checkchange', ({ detail: { isMet } }) => {
      if (isMet && !isShown) section.dispatchEvent(new Event('solved', { bubbles: true }))
      section.classList.toggle('done', isMet)
      output.value = isMet ? (output.dataset.done as string) : ''
    })
    const surface = () => figure.shadowRoot?.querySelector('.figure')
    const undo = () =>
      surface()?.dispatchEvent(new KeyboardEvent('keydown', { key: 'z', ctrlKey: true, bubbles: true }))
    section.querySelector('button.undo')?.addEventListener('click', undo)
    section.querySelector('button.reset')?.addEventListener('click', () => {
      isShown = false
      figure.circles = JSON.parse(figure.getAttribute('circles') as string)
    })
    section.querySelector<HTMLButtonElement>('button.show')?.addEventListener('click', ({ currentTarget }) => {
      isShown = true
      figure.circles = JSON.parse((currentTarget as HTMLElement).dataset.circles as string)
      figure.scrollIntoView({ block: 'nearest' })
    })
  }
}
