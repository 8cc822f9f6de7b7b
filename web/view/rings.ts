// SPDX-License-Identifier: GPL-3.0-or-later
// Rings around circles with a label each, above the picture of a view. The styles are in theme.css.
import type { View } from './view.ts'

/** A ring around a circle. It is open until its goal is reached. */
export interface Ring {
  readonly id: number
  readonly number: string
  /** The text beside the number; may be empty. */
  readonly text: string
  readonly isClosed: boolean
}

const SVG = 'http://www.w3.org/2000/svg'
/** Distance from a circle to its ring, the smallest ring, and from a ring to its label, in pixels. */
const DISTANCE = 7
const SMALLEST = 14
const GAP = 4
/** Height of a label, in pixels. */
const LABEL = 22

/** Draws rings in a container, which the view's container covers exactly. */
export class Rings {
  readonly #view: View
  readonly #layer: HTMLElement
  readonly #svg: SVGSVGElement
  readonly #drawn = new Map<number, { readonly ring: SVGCircleElement; readonly label: HTMLElement }>()
  readonly #stop: readonly (() => void)[]
  #rings: readonly Ring[] = []

  constructor(container: HTMLElement, view: View) {
    this.#view = view
    const page = container.ownerDocument
    this.#layer = page.createElement('div')
    this.#layer.className = 'rings'
    this.#layer.setAttribute('part', 'rings')
    // The text of the page says the same.
    this.#layer.ariaHidden = 'true'
    this.#svg = page.createElementNS(SVG, 'svg')
    this.#layer.append(this.#svg)
    container.append(this.#layer)
    const observer = new ResizeObserver(() => this.#place())
    observer.observe(container)
    this.#stop = [
      view.on('camera', () => this.#place()),
      view.on('changed', () => this.#place()),
      () => observer.disconnect(),
    ]
  }

  /** Shows these rings instead of the former ones. */
  show(rings: readonly Ring[]): void {
    const page = this.#layer.ownerDocument
    this.#rings = rings
    for (const [id, { ring, label }] of this.#drawn) {
      if (rings.some((shown) => shown.id === id)) continue
      ring.remove()
      label.remove()
      this.#drawn.delete(id)
    }
    for (const { id, number, text, isClosed } of rings) {
      let drawn = this.#drawn.get(id)
      if (drawn === undefined) {
        const label = page.createElement('span')
        const name = page.createElement('b')
        name.setAttribute('part', 'ring-number')
        const value = page.createElement('span')
        value.setAttribute('part', 'ring-value')
        label.append(name, value)
        drawn = { ring: page.createElementNS(SVG, 'circle'), label }
        // Lengths along the ring do not depend on its size.
        drawn.ring.setAttribute('pathLength', '100')
        this.#svg.append(drawn.ring)
        this.#layer.append(label)
        this.#drawn.set(id, drawn)
      }
      const [first, second] = drawn.label.children as unknown as [HTMLElement, HTMLElement]
      first.textContent = number
      second.textContent = text
      for (const part of [drawn.ring, drawn.label]) part.classList.toggle('closed', isClosed)
    }
    this.#place()
  }

  #place(): void {
    const { camera, size } = this.#view
    // All lengths are read before any style changes.
    const widths = this.#rings.map(({ id }) => this.#drawn.get(id)?.label.offsetWidth ?? 0)
    const taken: (readonly [x: number, top: number, width: number])[] = []
    for (const [k, { id }] of this.#rings.entries()) {
      const { ring, label } = this.#drawn.get(id) as { ring: SVGCircleElement; label: HTMLElement }
      const circle = this.#view.discOf(id)
      const isHidden = circle === undefined
      ring.classList.toggle('gone', isHidden)
      label.classList.toggle('gone', isHidden)
      if (isHidden) continue
      const { x, y } = this.#view.toScreen(circle)
      const r = Math.max(circle.r * camera.scale + DISTANCE, SMALLEST)
      for (const [name, value] of Object.entries({ cx: x, cy: y, r })) ring.setAttribute(name, `${value}`)
      const width = widths[k] as number
      const isTaken = (top: number) =>
        taken.some(([left, above, wide]) => 2 * Math.abs(x - left) < width + wide && Math.abs(top - above) < LABEL)
      // A label stays in sight: below its circle, or else above or on it.
      const places = [y + r + GAP, y - r - GAP - LABEL, y - LABEL / 2]
      const seen = places.filter((top) => top >= 0 && top + LABEL <= size.height)
      const top = seen.find((top) => !isTaken(top)) ?? seen[0] ?? (places[0] as number)
      taken.push([x, top, width])
      label.style.translate = `calc(${x}px - 50%) ${top}px`
    }
  }

  dispose(): void {
    for (const stop of this.#stop) stop()
    this.#layer.remove()
  }
}
