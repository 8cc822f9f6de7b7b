// SPDX-License-Identifier: GPL-3.0-or-later

/** A worker that runs `painter/start-thread.ts`. Bundlers look for exactly this expression. */
export function newPainterWorker(): Worker {
  return new Worker(new URL('./painter/start-thread.ts', import.meta.url), { type: 'module' })
}

/** Where that file is, for pages of another origin. */
export function painterFile(): URL {
  const here = import.meta.url
  return new URL('./painter/start-thread.ts', here)
}

/** What a worker that is made of `painterFile` is called. */
export const PAINTER_NAME = 'circle-voronoi/painter'
