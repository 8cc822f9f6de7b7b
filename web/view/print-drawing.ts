// SPDX-License-Identifier: GPL-3.0-or-later
// Figures in print. Printing does not wait, so each figure keeps a drawing ready, which is sharp at any resolution.
import { parsedSvg } from './parsed-svg.ts'

/** Pause after a change before the drawing is made, in milliseconds. */
const DRAWING_DELAY = 300

const drawings = new Set<PrintDrawing>()
let isListening = false

/** The drawing of one figure for print. */
export class PrintDrawing {
  readonly #place: HTMLElement
  readonly #draw: () => Promise<string>
  #text = ''
  #timer: ReturnType<typeof setTimeout> | undefined
  #turn = 0

  /** `place` gets the drawing as its child. If `draw` returns an empty text, the pixels of the screen are printed. */
  constructor(place: HTMLElement, draw: () => Promise<string>) {
    this.#place = place
    this.#draw = draw
    drawings.add(this)
    if (isListening) return
    isListening = true
    const show = (isShown: boolean) => {
      for (const drawing of drawings) drawing.show(isShown)
    }
    addEventListener('beforeprint', () => show(true))
    addEventListener('afterprint', () => show(false))
    matchMedia('print').addEventListener('change', ({ matches }) => show(matches))
  }

  /** Schedules a new drawing, once nothing else changes. */
  change(): void {
    this.#turn += 1
    const turn = this.#turn
    clearTimeout(this.#timer)
    this.#timer = setTimeout(async () => {
      const text = await this.#draw().catch(() => '')
      const isPrinting = matchMedia('print').matches
      // While a page is printed, its figures may have no size; then the former drawing is printed.
      if (turn !== this.#turn || (isPrinting && text === '')) return
      this.#text = text
      if (isPrinting) this.show(true)
    }, DRAWING_DELAY)
  }

  show(isShown: boolean): void {
    this.#place.replaceChildren()
    const drawing = isShown && this.#text !== '' ? parsedSvg(this.#text) : undefined
    if (drawing !== undefined) this.#place.append(drawing)
    this.#place.hidden = drawing === undefined
  }

  dispose(): void {
    drawings.delete(this)
    this.#turn += 1
    clearTimeout(this.#timer)
    this.show(false)
  }
}
