// SPDX-License-Identifier: GPL-3.0-or-later
// The two canvases, and when they are drawn.
import { PALETTES } from './colors.js'
import { paintGlobe, paintMarks } from './paint.js'

/** A picture that takes longer, in milliseconds, is drawn without cells while the globe moves. */
const SMOOTH = 60
/** A movement ends if nothing comes for this long, in milliseconds. */
const REST = 150
const dark = matchMedia('(prefers-color-scheme: dark)')

/** The colors of the current scheme. */
export function palette() {
  return PALETTES[dark.matches ? 'dark' : 'light']
}

/** The pictures of a scene, which `sceneOf` returns; `undefined` before the first one. */
export class Picture {
  #element
  #sceneOf
  #contexts
  #frame = 0
  #timer = 0
  #duration = 0

  constructor(element, sceneOf) {
    this.#element = element
    this.#sceneOf = sceneOf
    this.#contexts = Array.from(element.querySelectorAll('canvas'), (canvas) => canvas.getContext('2d'))
    new ResizeObserver(() => this.draw()).observe(element)
    dark.addEventListener('change', () => this.draw())
  }

  get size() {
    return { width: this.#element.clientWidth, height: this.#element.clientHeight }
  }

  /** Draws everything in the next frame. */
  draw(isMoving = false) {
    const isDraft = isMoving && this.#duration > SMOOTH
    clearTimeout(this.#timer)
    if (isDraft) this.#timer = setTimeout(() => this.draw(), REST)
    cancelAnimationFrame(this.#frame)
    this.#frame = requestAnimationFrame(() => {
      const scene = this.#sceneOf()
      if (scene === undefined) return
      const [cells] = this.#fitted()
      const start = performance.now()
      paintGlobe(cells, this.size, scene, palette(), isDraft)
      if (!isDraft) this.#duration = performance.now() - start
      this.drawMarks()
    })
  }

  /** Draws the marked cell. */
  drawMarks() {
    const scene = this.#sceneOf()
    if (scene !== undefined) paintMarks(this.#fitted()[1], this.size, scene, palette())
  }

  /** Returns the contexts after setting the sizes of their canvases, in pixels of the screen. */
  #fitted() {
    const { width, height } = this.size
    for (const context of this.#contexts) {
      const { canvas } = context
      const [across, down] = [width, height].map((length) => Math.round(length * devicePixelRatio))
      if (canvas.width === across && canvas.height === down) continue
      canvas.width = across
      canvas.height = down
      context.scale(devicePixelRatio, devicePixelRatio)
    }
    return this.#contexts
  }
}
