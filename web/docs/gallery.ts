// SPDX-License-Identifier: GPL-3.0-or-later

/** Runs examples in the page on request. Each replaces its picture. */
export function runExamples(page: Document): void {
  for (const figure of page.querySelectorAll<HTMLElement>('figure.example')) {
    const button = figure.querySelector('button') as HTMLButtonElement
    const picture = figure.querySelector('img') as HTMLImageElement
    button.hidden = false
    button.addEventListener('click', () => {
      const frame = page.createElement('iframe')
      frame.title = picture.alt
      frame.src = figure.dataset.page as string
      picture.replaceWith(frame)
      frame.focus()
      button.remove()
    })
  }
}
