// SPDX-License-Identifier: GPL-3.0-or-later

/** Longest wait for an idle browser, in milliseconds. */
const LATEST = 3000

const waiting = new Set<() => void>()
let isWaiting = false

/**
 * Calls a function once the page has loaded and the browser is idle. Functions run one at a time, in order. Returns a
 * function that cancels the call.
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
  // WebKit has no idle callback.
  if ('requestIdleCallback' in globalThis) requestIdleCallback(run, { timeout: LATEST })
  else setTimeout(run, LATEST / 10)
}
