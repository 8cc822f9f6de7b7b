// SPDX-License-Identifier: GPL-3.0-or-later

/** Upper limit for the wait, in milliseconds. A visible tab draws far sooner. */
const LATEST = 1000

/** Calls a function at the next frame, or after a short timeout if the tab is hidden and draws no frames. */
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
