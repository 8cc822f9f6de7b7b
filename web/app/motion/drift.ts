// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle } from '../../lib/index.ts'
import { toPlane } from '../../view/camera.ts'
import type { View } from '../../view/view.ts'

/** The circle that moves, how long it takes to come around, in milliseconds, and how far it goes, in units. */
const MOVING = 7
const TURN = 9000
const REACH = { x: 0.9, y: 0.7 }
/** How long it takes to come back once something is touched, in milliseconds. */
const BACK = 350

/**
 * Moves one circle of the first scene gently until something is touched: then it comes back, so that the circles are those of
 * the data set. Nothing of it is kept or undone. Whoever wants less motion sees none.
 * `onend`: called once the circle is back, or once other circles are there or it cannot be moved.
 */
export function driftAtStart(view: View, figure: HTMLElement, onend: () => void): void {
  const table = view.circles
  const home = table.get(MOVING)
  if (home === undefined || matchMedia('(prefers-reduced-motion: reduce)').matches) return
  const listening = new AbortController()
  const begin = performance.now()
  let place = home
  let isAsked = false
  /** When it was touched, and where the circle was then. */
  let touched: { readonly at: number; readonly from: Circle } | undefined

  let isOver = false

  const end = () => {
    if (isOver) return
    isOver = true
    listening.abort()
    onend()
  }
  const frame = (now: number) => {
    if (isOver) return
    // Other circles are there, or it is at home again.
    if (view.circles !== table || (touched !== undefined && place === home && !isAsked)) {
      end()
      return
    }
    if (!isAsked) {
      place = placeAt(now)
      isAsked = true
      view.apply([{ kind: 'replace', id: MOVING, circle: place }]).then(() => {
        isAsked = false
      }, end)
    }
    requestAnimationFrame(frame)
  }
  const placeAt = (now: number): Circle => {
    if (touched === undefined) {
      const angle = (2 * Math.PI * (now - begin)) / TURN
      return { ...home, x: home.x + REACH.x * (1 - Math.cos(angle)), y: home.y + REACH.y * Math.sin(angle) }
    }
    const share = Math.min((now - touched.at) / BACK, 1)
    if (share === 1) return home
    const rest = (1 - share) ** 2
    const { from } = touched
    return { ...home, x: home.x + (from.x - home.x) * rest, y: home.y + (from.y - home.y) * rest }
  }
  const touch = (event: Event) => {
    touched ??= { at: performance.now(), from: place }
    // Whoever takes this one has it where it is.
    if (event instanceof PointerEvent && isOn(event)) {
      place = home
      listening.abort()
    }
  }
  const isOn = ({ clientX, clientY }: PointerEvent): boolean => {
    const { left, top } = figure.getBoundingClientRect()
    const { x, y } = toPlane(view.camera, view.size, { x: clientX - left, y: clientY - top })
    return Math.hypot(x - place.x, y - place.y) < 1.5 * place.r
  }
  for (const name of ['pointerdown', 'keydown', 'wheel'] as const) {
    document.addEventListener(name, touch, { capture: true, signal: listening.signal, passive: true })
  }
  requestAnimationFrame(frame)
}
