// SPDX-License-Identifier: GPL-3.0-or-later
// Writes numbers at the circles above the picture of an element.
import type { CircleVoronoiElement } from '../element/index.ts'
import { toScreen } from '../view/camera.ts'
import { lookAt } from './printed-picture.ts'

const SVG = 'http://www.w3.org/2000/svg'
/** The events after which a figure's viewport may have changed. */
const MOVES = ['pointermove', 'pointerup', 'wheel', 'keydown', 'keyup', 'dblclick', 'circleschange'] as const

/** Writes its index at each circle. */
export function numberCircles(figure: CircleVoronoiElement): void {
  const page = figure.ownerDocument
  const svg = page.createElementNS(SVG, 'svg')
  svg.classList.add('numbers')
  svg.setAttribute('aria-hidden', 'true')
  figure.after(svg)
  let isAsked = false
  const draw = () => {
    isAsked = false
    const { circles, clientWidth: width, clientHeight: height } = figure
    const { view } = figure.getState()
    if (width === 0 || view?.span === 0) return
    const size = { width, height }
    const camera = lookAt(circles, view, size)
    const names = Array.from({ length: circles.length / 3 }, (_, i) => {
      const { x, y } = toScreen(camera, size, { x: circles[3 * i] as number, y: circles[3 * i + 1] as number })
      const text = page.createElementNS(SVG, 'text')
      text.setAttribute('x', `${x}`)
      text.setAttribute('y', `${y}`)
      text.textContent = `${i}`
      return text
    })
    svg.setAttribute('viewBox', `0 0 ${width} ${height}`)
    svg.replaceChildren(...names)
  }
  const ask = () => {
    if (isAsked) return
    isAsked = true
    requestAnimationFrame(draw)
  }
  for (const name of MOVES) figure.addEventListener(name, ask, { passive: true })
  new ResizeObserver(ask).observe(figure)
  void figure.ready.then(ask)
}
