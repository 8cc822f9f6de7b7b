// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Returns a function that calls another one at once, or where a pointer is pressed once the press is a click: what moves
 * below the pointer before that would lose it.
 */
export function listenToPresses(around: Document): (act: () => void) => void {
  let isPressed = false
  let waiting: (() => void)[] = []
  const listen = (name: string, act: () => void) => around.addEventListener(name, act, { capture: true })
  const end = () => {
    isPressed = false
    // The click comes right after it.
    for (const act of waiting) setTimeout(act)
    waiting = []
  }
  listen('pointerdown', () => {
    isPressed = true
  })
  listen('pointerup', end)
  listen('pointercancel', end)
  return (act) => {
    if (isPressed) waiting.push(act)
    else act()
  }
}
