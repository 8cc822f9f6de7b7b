// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse, touch, wheel and keys on the globe.

/** A press that moves less, in pixels, is a click. */
const SLOP = 4
const WHEEL = 0.0015
const KEY_ZOOM = 1.3
/** The part of the picture that an arrow key moves, and that with the Shift key. */
const KEY_TURN = { usual: 12, fine: 2 }
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }

/**
 * @typedef {object} GlobeActions
 * @property {(from: number[], to: number[]) => void} drag moves a point of the picture to another
 * @property {(factor: number, point: number[]) => void} zoom
 * @property {(east: number, north: number) => void} turn by degrees at zoom 1
 * @property {(point: number[] | undefined) => void} hover
 * @property {(point: number[] | undefined) => void} select without a point: the cell under the keyboard's cursor
 * @property {() => void} home shows all places
 * @property {(hasCursor: boolean) => void} showCursor
 */

/**
 * Listens to an element.
 * @param {HTMLElement} element
 * @param {GlobeActions} actions
 */
export function listenTo(element, actions) {
  listenToPointers(element, actions)
  listenToKeys(element, actions)
}

function listenToPointers(element, actions) {
  const pointers = new Map()
  let isClick = false
  const pointOf = ({ clientX, clientY }) => {
    const { left, top } = element.getBoundingClientRect()
    return [clientX - left, clientY - top]
  }

  element.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return
    element.setPointerCapture(event.pointerId)
    isClick = pointers.size === 0
    pointers.set(event.pointerId, { start: pointOf(event), at: pointOf(event) })
    actions.showCursor(false)
  })
  element.addEventListener('pointermove', (event) => {
    const pointer = pointers.get(event.pointerId)
    const to = pointOf(event)
    if (pointer === undefined) {
      if (event.pointerType === 'mouse') actions.hover(to)
      return
    }
    if (isClick && distance(pointer.start, to) < SLOP) return
    isClick = false
    const before = [...pointers.values()].map(({ at }) => at)
    pointer.at = to
    const now = [...pointers.values()].map(({ at }) => at)
    actions.drag(middleOf(before), middleOf(now))
    if (now.length === 2) actions.zoom(distance(...now) / distance(...before), middleOf(now))
  })
  for (const type of ['pointerup', 'pointercancel']) {
    element.addEventListener(type, (event) => {
      if (!pointers.delete(event.pointerId)) return
      if (type === 'pointerup' && isClick) actions.select(pointOf(event))
      isClick = false
    })
  }
  element.addEventListener('pointerleave', () => pointers.size === 0 && actions.hover(undefined))
  element.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault()
      // Firefox counts lines.
      const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 20 : 1)
      // Pinches on a touchpad have the Control key, and small steps.
      actions.zoom(Math.exp(-pixels * WHEEL * (event.ctrlKey ? 6 : 1)), pointOf(event))
    },
    { passive: false },
  )
}

function listenToKeys(element, actions) {
  const middle = () => [element.clientWidth / 2, element.clientHeight / 2]
  element.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return
    const arrow = ARROWS[event.key]
    const turn = event.shiftKey ? KEY_TURN.fine : KEY_TURN.usual
    if (arrow !== undefined) actions.turn(...arrow.map((sign) => sign * turn))
    else if (['+', '='].includes(event.key)) actions.zoom(KEY_ZOOM, middle())
    else if (['-', '_'].includes(event.key)) actions.zoom(1 / KEY_ZOOM, middle())
    else if (['0', 'Home'].includes(event.key)) actions.home()
    else if (['Enter', ' '].includes(event.key)) actions.select(undefined)
    else return
    event.preventDefault()
    actions.showCursor(true)
  })
  element.addEventListener('focus', () => actions.showCursor(element.matches(':focus-visible')))
  element.addEventListener('blur', () => actions.showCursor(false))
}

function middleOf(points) {
  return [0, 1].map((k) => points.reduce((sum, point) => sum + point[k], 0) / points.length)
}

function distance([x, y], [u, v]) {
  return Math.hypot(u - x, v - y)
}
