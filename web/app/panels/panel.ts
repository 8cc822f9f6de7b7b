// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, render, type TemplateResult } from 'lit/html.js'
import { icon } from '../../player/icon.ts'
import { CLOSE } from '../../view/icons.ts'
import { NOT_LOADED } from '../not-loaded.ts'

const STORAGE = 'circle-voronoi:open-panel'
/** A handle that is pulled so far, in pixels, makes the sheet larger or smaller. */
const PULLED = 24

/** A panel beside the rail, which a button opens and closes. */
export interface Panel {
  readonly isOpen: boolean
  /** If it is not. */
  open(): void
  close(): void
  render(body: () => TemplateResult): void
}

export interface PanelOptions {
  /** Called when it is opened. */
  readonly onopen?: () => void
  /** Whether the page opens it again when it is loaded. Default: true. */
  readonly isKept?: boolean
}

/** The one that is open. */
let current: Panel | undefined
/** Whether the handle was pulled since it was pressed: then that was no click. */
let wasPulled = false

/** One panel is open at a time; `draw` is called whenever it is opened or closed. */
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
  element.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || event.defaultPrevented) return
    event.stopPropagation()
    panel.close()
  })
  // Once whoever made it has it.
  if (isKept && remembered() === element.id) queueMicrotask(() => panel.open())
  return panel
}

/** Loads and mounts a panel once its button is pressed, or at once if the page opens it again. */
export function panelLater(id: string, complain: (problem: string) => void, mount: () => Promise<void>): void {
  const button = document.querySelector(`[aria-controls="${id}"]`) as HTMLButtonElement
  const load = async (isPressed: boolean) => {
    try {
      await mount()
      // Now it hears of it.
      if (isPressed) button.click()
    } catch {
      complain(NOT_LOADED)
      listen()
    }
  }
  const listen = () => button.addEventListener('click', () => load(true), { once: true })
  if (remembered() === id) load(false)
  else listen()
}

/** Makes the sheet of a phone larger or smaller; `undefined`: the other of the two. */
function resize(isLarge: boolean | undefined): boolean {
  return document.body.classList.toggle('large-sheet', isLarge)
}

/** Follows a handle: up makes the sheet larger, down smaller, and down once more closes it. */
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

/** Without storage it forgets. */
function remember(id: string): void {
  try {
    localStorage.setItem(STORAGE, id)
  } catch {}
}
