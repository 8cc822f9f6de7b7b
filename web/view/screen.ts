// SPDX-License-Identifier: GPL-3.0-or-later
import type { Size } from './camera.ts'
import { scaleOnScreen } from './on-screen.ts'
import { isDark, readStyle, type Style } from './style.ts'

/** Transforms below this scale leave the resolution as it is; larger ones increase it. */
const LEAST_ENLARGED = 1.05
const MOST_SHARPENED = 4

export interface ScreenEvents {
  /** The size or the resolution has changed, and the canvases are empty. */
  resized(): void
  /** The style may have changed. */
  restyled(): void
  /** Printing begins or ends. It shows the pixels painted so far. */
  printed(): void
}

/** Two canvases that cover an element of a page, in the screen's resolution, and the element's style. */
export class Screen {
  readonly #container: HTMLElement
  readonly #events: ScreenEvents
  readonly base: HTMLCanvasElement
  readonly overlay: HTMLCanvasElement
  readonly #observer: ResizeObserver
  readonly #watching = new AbortController()
  #style: Style
  #size: Size = { width: 0, height: 0 }
  #scale = 1
  #isShown = true

  constructor(container: HTMLElement, events: ScreenEvents) {
    this.#container = container
    this.#events = events
    container.classList.add('circle-voronoi')
    this.base = container.appendChild(document.createElement('canvas'))
    this.overlay = container.appendChild(document.createElement('canvas'))
    this.#style = this.#readStyle()
    this.#observer = new ResizeObserver(() => this.#sizeChanges())
    this.#observer.observe(container)
    this.#watchSurroundings()
    this.#fit()
  }

  /** The size in CSS pixels. */
  get size(): Size {
    return this.#size
  }

  get style(): Style {
    return this.#style
  }

  /** The style on white paper. */
  get printStyle(): Style {
    const { style } = this.#container
    const before = style.colorScheme
    style.colorScheme = 'light'
    const light = { ...readStyle(this.#container), paper: '#ffffff' }
    style.colorScheme = before
    return light
  }

  /** Device pixels per CSS pixel of the container. */
  get pixelRatio(): number {
    return devicePixelRatio * this.#scale
  }

  /** Whether anything is painted. */
  get isPainted(): boolean {
    return this.#isShown && this.#size.width > 0 && this.#size.height > 0
  }

  /** Whether the canvases have pixels. */
  get isShown(): boolean {
    return this.#isShown
  }

  set isShown(isShown: boolean) {
    this.#isShown = isShown
    this.#resize()
  }

  set isBusy(isBusy: boolean) {
    this.#container.ariaBusy = String(isBusy)
  }

  /** Reads the container's style again after a change. */
  restyle(): void {
    this.#style = this.#readStyle()
    this.#events.restyled()
  }

  /** Transforms cause no event, so the scale is checked at each drawing and when the window changes. */
  checkScale(): void {
    if (matchMedia('print').matches) return
    const ratio = this.#scaleOnScreen() / this.#scale
    if (Math.max(ratio, 1 / ratio) > LEAST_ENLARGED) this.#resize()
  }

  dispose(): void {
    this.#observer.disconnect()
    this.#watching.abort()
    this.base.remove()
    this.overlay.remove()
  }

  #readStyle(): Style {
    const style = readStyle(this.#container)
    // Print styles use this attribute, because paper is light.
    this.#container.toggleAttribute('data-dark', isDark(style))
    return style
  }

  /** The scale of transforms and zoom around the container. Reductions keep the resolution. */
  #scaleOnScreen(): number {
    const scale = scaleOnScreen(this.#container)
    return scale > LEAST_ENLARGED ? Math.min(scale, MOST_SHARPENED) : 1
  }

  /**
   * Prints the screen's picture scaled (theme.css), because printing does not wait for a picture in the paper's size
   * and resolution.
   */
  #sizeChanges(): void {
    if (!matchMedia('print').matches) this.#resize()
  }

  #resize(): void {
    this.#fit()
    this.#events.resized()
  }

  #fit(): void {
    this.#size = { width: this.#container.clientWidth, height: this.#container.clientHeight }
    this.#scale = this.#scaleOnScreen()
    const pixels = this.#isShown ? this.pixelRatio : 0
    for (const canvas of [this.base, this.overlay]) {
      canvas.width = Math.round(this.#size.width * pixels)
      canvas.height = Math.round(this.#size.height * pixels)
    }
  }

  /** Follows changes of the color scheme, system colors, style sheets and the screen's resolution. */
  #watchSurroundings(): void {
    const { signal } = this.#watching
    // WebKit may run modules before style sheets are loaded.
    const restyleBy = ({ target }: Event) => {
      if (target instanceof HTMLLinkElement && target.relList.contains('stylesheet')) this.restyle()
    }
    document.addEventListener('load', restyleBy, { capture: true, signal })
    for (const query of ['(prefers-color-scheme: dark)', '(forced-colors: active)']) {
      matchMedia(query).addEventListener('change', () => this.restyle(), { signal })
    }
    matchMedia('print').addEventListener('change', () => this.#events.printed(), { signal })
    // Other listeners of the same event may set a transform first.
    const check = () => requestAnimationFrame(() => this.checkScale())
    for (const name of ['resize', 'transitionend']) addEventListener(name, check, { signal })
    const watchPixels = () => {
      const query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`)
      const change = () => {
        this.#sizeChanges()
        watchPixels()
      }
      query.addEventListener('change', change, { signal, once: true })
    }
    watchPixels()
  }
}
