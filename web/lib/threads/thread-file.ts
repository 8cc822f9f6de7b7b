// SPDX-License-Identifier: GPL-3.0-or-later

/** Starts a worker that runs `worker-thread.js`. Bundlers look for exactly this expression. */
export function newWorker(): Worker {
  return new Worker(new URL('../worker-thread.js', import.meta.url), { type: 'module' })
}

/**
 * Returns the address of `worker-thread.js`, or its text. It avoids the expression above, for which bundlers would copy
 * the file for every page.
 */
export function threadFile(): URL | string {
  const here = import.meta.url
  return new URL('../worker-thread.js', here)
}

/** The name of workers started from `threadFile`. */
export const THREAD_NAME = 'circle-voronoi'
