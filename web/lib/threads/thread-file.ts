// SPDX-License-Identifier: GPL-3.0-or-later

/** A worker that runs `worker-thread.js`. Bundlers look for exactly this expression. */
export function newWorker(): Worker {
  return new Worker(new URL('../worker-thread.js', import.meta.url), { type: 'module' })
}

/** Where that file is, or its text. Not the expression above, for which bundlers would copy the file for every page. */
export function threadFile(): URL | string {
  const here = import.meta.url
  return new URL('../worker-thread.js', here)
}

/** The name of a worker started from `threadFile`. */
export const THREAD_NAME = 'circle-voronoi'
