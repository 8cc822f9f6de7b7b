// SPDX-License-Identifier: GPL-3.0-or-later
import { html, render, type TemplateResult } from 'lit'

const STORAGE = 'circle-voronoi:open-panels'

/** A panel that folds to its title, and remembers. */
export interface Folding {
  readonly isOpen: boolean
  /** If it is not. */
  open(): void
  render(body: () => TemplateResult): void
}

/** `onopen`: called when it is opened. */
export function folding(
  panel: HTMLElement,
  title: string,
  icon: TemplateResult,
  draw: () => void,
  onopen = () => {},
): Folding {
  let isOpen = remembered().includes(panel.id)
  const toggle = () => {
    isOpen = !isOpen
    remember(panel.id, isOpen)
    draw()
    if (isOpen) onopen()
  }
  return {
    get isOpen() {
      return isOpen
    },
    open() {
      if (!isOpen) toggle()
    },
    render(body) {
      panel.classList.toggle('open', isOpen)
      const id = `${panel.id}-body`
      render(
        html`<h2>
            <button type="button" aria-expanded=${isOpen} aria-controls=${id} @click=${toggle}>
              <svg viewBox="0 0 20 20" aria-hidden="true">${icon}</svg>${title}
            </button>
          </h2>
          <div id=${id} class="body" ?hidden=${!isOpen}>${isOpen ? body() : undefined}</div>`,
        panel,
      )
    },
  }
}

function remembered(): readonly string[] {
  try {
    return (localStorage.getItem(STORAGE) ?? '').split(' ')
  } catch {
    return []
  }
}

/** Without storage it forgets. */
function remember(id: string, isOpen: boolean): void {
  try {
    const others = remembered().filter((name) => name !== id && name !== '')
    localStorage.setItem(STORAGE, [...others, ...(isOpen ? [id] : [])].join(' '))
  } catch {}
}
