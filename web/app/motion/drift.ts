// SPDX-License-Identifier: GPL-3.0-or-later
import type { Circle } from '../../lib/index.ts'
import type { View } from '../../view/view.ts'
import { showStop } from '../panels/stop.ts'

/** The moving circle, the time of one round in milliseconds, and the distance in units. */
const MOVING = 7
const TURN = 9000
const REACH = { x: 0.9, y: 0.7 }
/** Duration of the return after a touch, in milliseconds. */
const BACK = 350

/**
 * Moves one circle of the first scene gently until the user touches anything. The circle then returns to its place
 * in the data set. The motion is neither saved nor undone, and is off if the user prefers reduced
 * motion. `onend` is called when the circle is back, when other circles are opened, or if the circle cannot be moved.
 */
export function driftAtStart(view: View, figure: HTMLElement, onend: () => void): void {
  const table = view.circles
  const home = table.get(MOVING)
  if (home === undefined || matchMedia('(prefers-reduced-motion: reduce)').matches) return
  const listening = new AbortController()
  const begin = performance.now()
  let place = home
  let isAsked = false
  /** The time of the touch, and the circle at that time. */
  let touched: { readonly at: number; readonly from: Circle } | undefined

  let isOver = false

  const end = () => {
    if (isOver) return
    isOver = true
    listening.abort()
    showStop(false)
    onend()
  }
  const frame = (now: number) => {
    if (isOver) return
    // Stops after an opening, or when the circle is back.
    if (view.circles !== table || (touched !== undefined && place === home && !isAsked)) {
      end()
      return
    }
    if (!isAsked) {
      place = placeAt(now)
      isAsked = true
      view.scene.edit([{ kind: 'replace', id: MOVING, circle: place }]).then(() => {
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
    // A user who grabs this circle gets it at its current position.
    if (event instanceof PointerEvent && isOn(event)) {
      place = home
      listening.abort()
    }
  }
  const isOn = ({ clientX, clientY }: PointerEvent): boolean => {
    const { left, top } = figure.getBoundingClientRect()
    const { x, y } = view.toPlane({ x: clientX - left, y: clientY - top })
    return Math.hypot(x - place.x, y - place.y) < 1.5 * place.r
  }
  showStop(true)
  for (const name of ['pointerdown', 'click', 'keydown', 'wheel'] as const) {
    document.addEventListener(name, touch, { capture: true, signal: listening.signal, passive: true })
  }
  requestAnimationFrame(frame)
}
