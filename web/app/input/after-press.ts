// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Returns a function that runs an action at once, or after the current click if a pointer is pressed. Layout changes
 * during a press would make the click miss its target.
 */
export function listenToPresses(around: Document): (act: () => void) => void {
  let isPressed = false
  let waiting: (() => void)[] = []
  const listen = (name: string, act: () => void) => around.addEventListener(name, act, { capture: true })
  const end = () => {
    isPressed = false
    // The click event follows the release.
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
