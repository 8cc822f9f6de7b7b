// SPDX-License-Identifier: GPL-3.0-or-later
// Draws each circle as a cone that the reader can turn. Seen from above, the cones show the Voronoi diagram.
import { type Pose, paintCones } from './drawn/paint-cones.ts'

/** Rotation of the cones, in degrees per pixel of a drag. */
const TURN = 0.4
const TILT = 0.3
/** Device pixels per CSS pixel, at most. At least 1.5 are painted, so that lines are smooth. */
const FINEST = 2

export function turnCones(page: Document): void {
  for (const figure of page.querySelectorAll<HTMLElement>('[data-cones]')) turn(figure)
}

function turn(figure: HTMLElement): void {
  const picture = figure.querySelector('.picture') as HTMLElement
  const image = picture.querySelector('img') as HTMLImageElement
  const [tilt, spin] = figure.querySelectorAll('input') as unknown as [HTMLInputElement, HTMLInputElement]
  const canvas = figure.ownerDocument.createElement('canvas')
  canvas.className = 'cones'
  canvas.setAttribute('role', 'img')
  canvas.setAttribute('aria-label', image.alt)
  const { circles, view } = JSON.parse(figure.dataset.cones as string)
  let isAsked = false
  const draw = () => {
    isAsked = false
    const { width } = canvas.getBoundingClientRect()
    if (width === 0) return
    const pixels = Math.round(width * Math.min(Math.max(devicePixelRatio, FINEST / 2 + 0.5), FINEST))
    const [w, h] = [pixels, Math.round(pixels / 1.6)]
    if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h })
    const pose: Pose = { tilt: tilt.valueAsNumber, turn: spin.valueAsNumber }
    const context = canvas.getContext('2d') as CanvasRenderingContext2D
    context.putImageData(new ImageData(paintCones(circles, view, pose, w, h), w, h), 0, 0)
  }
  const ask = () => {
    if (isAsked) return
    isAsked = true
    requestAnimationFrame(draw)
  }
  for (const slider of [tilt, spin]) {
    slider.addEventListener('input', () => {
      const output = slider.parentElement?.querySelector('output') as HTMLOutputElement
      output.value = `${Math.round(slider.valueAsNumber)}°`
      ask()
    })
  }
  const add = (slider: HTMLInputElement, degrees: number) => {
    slider.valueAsNumber += degrees
    slider.dispatchEvent(new Event('input'))
  }
  canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture(event.pointerId))
  canvas.addEventListener('pointermove', (event) => {
    if (!canvas.hasPointerCapture(event.pointerId)) return
    const wanted = spin.valueAsNumber - event.movementX * TURN
    add(spin, ((wanted + 540) % 360) - 180 - spin.valueAsNumber)
    add(tilt, event.movementY * TILT)
  })
  picture.replaceChildren(canvas)
  new ResizeObserver(ask).observe(canvas)
}
