// SPDX-License-Identifier: GPL-3.0-or-later

/** A browser that is never idle acts after so many milliseconds. */
const LATEST = 3000

const waiting = new Set<() => void>()
let isWaiting = false

/**
 * Calls a function once the page has loaded and the browser has nothing else to do, after all that wait already: one at a time. Returns
 * what takes it back.
 */
export function whenIdle(act: () => void): () => void {
  waiting.add(act)
  if (!isWaiting) {
    isWaiting = true
    if (document.readyState === 'complete') next()
    else addEventListener('load', next, { once: true })
  }
  return () => waiting.delete(act)
}

function next(): void {
  const run = () => {
    const [act] = waiting
    isWaiting = waiting.size > 1
    if (act !== undefined) waiting.delete(act)
    if (isWaiting) next()
    act?.()
  }
  // WebKit does not tell when it is idle.
  if ('requestIdleCallback' in globalThis) requestIdleCallback(run, { timeout: LATEST })
  else setTimeout(run, LATEST / 10)
}
