// SPDX-License-Identifier: GPL-3.0-or-later

/** A worker that runs `painter/start-thread.ts`. Bundlers look for exactly this expression. */
export function newWorker(): Worker {
  return new Worker(new URL('./painter/start-thread.ts', import.meta.url), { type: 'module' })
}

/** Where that file is, for pages of another origin. */
export function threadFile(): URL {
  const here = import.meta.url
  return new URL('./painter/start-thread.ts', here)
}

/** What a worker that is made of `threadFile` is called. */
export const THREAD_NAME = 'circle-voronoi/painter'
