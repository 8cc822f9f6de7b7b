// SPDX-License-Identifier: GPL-3.0-or-later

/** A tab that is shown draws far sooner than in so many milliseconds. */
const LATEST = 1000

/** Calls a function with the next frame; where a tab is hidden, which draws none, soon. */
export function nextFrame(act: () => void): void {
  let isDone = false
  const once = () => {
    clearTimeout(timer)
    if (!isDone) act()
    isDone = true
  }
  const timer = setTimeout(once, globalThis.document?.hidden === true ? 0 : LATEST)
  requestAnimationFrame(once)
}
