// SPDX-License-Identifier: GPL-3.0-or-later

/** Starts the worker of `painter/start-thread.ts`. Bundlers recognize exactly this expression. */
export function newWorker(): Worker {
  return new Worker(new URL('./painter/start-thread.ts', import.meta.url), { type: 'module' })
}

/** The address of that worker's file, for pages of another origin. */
export function threadFile(): URL {
  const here = import.meta.url
  return new URL('./painter/start-thread.ts', here)
}

/** The name of a worker started from `threadFile`. */
export const THREAD_NAME = 'circle-voronoi/painter'
