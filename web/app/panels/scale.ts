// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, render } from 'lit/html.js'
import type { Point } from '../../lib/index.ts'
import { toPlane } from '../../view/camera.ts'
import type { View } from '../../view/view.ts'
import { byId } from './by-id.ts'

/** Largest length of the bar, in pixels. */
const LONGEST = 120

/** A scale bar of a round length, and the position of the pointer in the plane. */
export function mountScale(view: View): void {
  const place = byId('scale', HTMLElement)
  const figure = byId('figure', HTMLElement)
  let pointer: Point | undefined
  let frame = 0

  const draw = () => {
    frame = 0
    const { camera, size } = view
    const length = roundLength(LONGEST / camera.scale)
    const at = pointer === undefined ? undefined : toPlane(camera, size, pointer)
    // Shows as many digits as one pixel distinguishes.
    const digits = Math.min(Math.max(Math.ceil(Math.log10(camera.scale)), 0), 15)
    const text = (value: number) => (Math.abs(value) < 1e15 ? value.toFixed(digits) : value.toExponential(6))
    render(
      html`
        <span class="pointer">${at === undefined ? nothing : `${text(at.x)}, ${text(at.y)}`}</span>
        <span class="length">${length}</span>
        <svg width=${length * camera.scale + 2} height="7" aria-hidden="true">
          <path d=${`M1 0v6h${length * camera.scale}v-6`} />
        </svg>
      `,
      place,
    )
  }
  const drawSoon = () => {
    if (frame === 0) frame = requestAnimationFrame(draw)
  }

  view.on('camera', drawSoon)
  figure.addEventListener('pointermove', (event) => {
    pointer = event.pointerType === 'touch' ? undefined : { x: event.offsetX, y: event.offsetY }
    drawSoon()
  })
  figure.addEventListener('pointerleave', () => {
    pointer = undefined
    drawSoon()
  })
  draw()
}

/** The largest of 1, 2 and 5 times a power of ten that is at most a length. */
export function roundLength(most: number): number {
  // The logarithm may be rounded up to the next whole number.
  const exponent = Math.floor(Math.log10(most))
  const lengths = [exponent, exponent - 1].flatMap((power) => [5, 2, 1].map((factor) => Number(`${factor}e${power}`)))
  return lengths.find((length) => length <= most) as number
}
