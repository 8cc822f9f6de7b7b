// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, render, type TemplateResult } from 'lit/html.js'
import { icon } from '../../player/icon.ts'
import { CLOSE } from '../../view/icons.ts'
import { NOT_LOADED } from '../not-loaded.ts'

const STORAGE = 'circle-voronoi:open-panel'
/** Distance by which a pulled handle resizes the sheet, in pixels. */
const PULLED = 24

/** A panel beside the rail, opened and closed by a button. */
export interface Panel {
  readonly isOpen: boolean
  /** Opens the panel if it is closed. */
  open(): void
  close(): void
  render(body: () => TemplateResult): void
}

export interface PanelOptions {
  /** Called when the panel opens. */
  readonly onopen?: () => void
  /** Whether a reload opens the panel again. Default: true. */
  readonly isKept?: boolean
}

/** The open panel. */
let current: Panel | undefined
/** Whether the handle was pulled during the current press, so that the click is ignored. */
let wasPulled = false

/** Creates a panel. At most one is open. `draw` is called whenever it opens or closes. */
export function panelOf(
  element: HTMLElement,
  title: string,
  draw: () => void,
  { onopen = () => {}, isKept = true }: PanelOptions = {},
): Panel {
  const button = document.querySelector(`[aria-controls="${element.id}"]`) as HTMLButtonElement
  let isOpen = false
  const show = (shown: boolean) => {
    isOpen = shown
    element.hidden = !shown
    button.setAttribute('aria-expanded', String(shown))
    if (isKept) remember(shown ? element.id : '')
    draw()
  }
  const panel: Panel = {
    get isOpen() {
      return isOpen
    },
    open() {
      if (isOpen) return
      current?.close()
      current = panel
      show(true)
      onopen()
    },
    close() {
      if (!isOpen) return
      const hadFocus = element.contains(document.activeElement)
      current = undefined
      show(false)
      if (hadFocus) button.focus()
    },
    render(body) {
      render(
        html`<header>
            <button
              type="button"
              class="handle"
              aria-label="Larger or smaller"
              title="Pull up for more room"
              @pointerdown=${(event: PointerEvent) => pull(event, panel)}
              @click=${() => wasPulled || resize(undefined)}
            ></button>
            <h2>${title}</h2>
            <button type="button" class="icon" aria-label="Close" title="Close (Escape)" @click=${() => panel.close()}>
              ${icon(CLOSE)}
            </button>
          </header>
          <div class="body">${isOpen ? body() : nothing}</div>`,
        element,
      )
    },
  }
  button.addEventListener('click', () => (isOpen ? panel.close() : panel.open()))
  for (const place of [element, button]) {
    place.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || event.defaultPrevented || !isOpen) return
      event.stopPropagation()
      panel.close()
    })
  }
  // The rail's other tools lie between the button and its panel.
  button.addEventListener('keydown', (event) => {
    if (event.key !== 'Tab' || event.shiftKey || !isOpen) return
    event.preventDefault()
    element.querySelector<HTMLElement>('header .icon')?.focus()
  })
  // Waits until the caller has the panel.
  if (isKept && remembered() === element.id) queueMicrotask(() => panel.open())
  return panel
}

/** Loads and mounts a panel when its button is pressed, or at once if it was open before a reload. */
export function panelLater(id: string, complain: (problem: string) => void, mount: () => Promise<unknown>): void {
  const button = document.querySelector(`[aria-controls="${id}"]`) as HTMLButtonElement
  const load = async (isPressed: boolean) => {
    try {
      await mount()
      // Repeats the click for the new listener.
      if (isPressed) button.click()
    } catch {
      complain(NOT_LOADED)
      listen()
    }
  }
  const press = (event: Event) => {
    // The panel may have been mounted by other means. Its own listener waits for the repeated click.
    event.stopImmediatePropagation()
    load(true)
  }
  const listen = () => button.addEventListener('click', press, { once: true })
  if (remembered() === id) load(false)
  else listen()
}

/** Resizes the sheet on a phone; `undefined` toggles between large and small. */
function resize(isLarge: boolean | undefined): boolean {
  return document.body.classList.toggle('large-sheet', isLarge)
}

/** Follows a handle: up enlarges the sheet, down reduces it, and down again closes it. */
function pull({ target, clientY: start, pointerId }: PointerEvent, panel: Panel): void {
  const handle = target as HTMLElement
  wasPulled = false
  handle.setPointerCapture(pointerId)
  const listening = new AbortController()
  const { signal } = listening
  handle.addEventListener(
    'pointermove',
    ({ clientY }) => {
      if (Math.abs(clientY - start) < PULLED) return
      listening.abort()
      wasPulled = true
      const isLarge = document.body.classList.contains('large-sheet')
      if (clientY < start) resize(true)
      else if (isLarge) resize(false)
      else panel.close()
    },
    { signal },
  )
  for (const name of ['pointerup', 'pointercancel'] as const) {
    handle.addEventListener(name, () => listening.abort(), { signal })
  }
}

function remembered(): string {
  try {
    return localStorage.getItem(STORAGE) ?? ''
  } catch {
    return ''
  }
}

/** The panel is not remembered without storage. */
function remember(id: string): void {
  try {
    localStorage.setItem(STORAGE, id)
  } catch {}
}
