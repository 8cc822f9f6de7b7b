// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../view/painter-file.ts in dist/element, where the thread has a file of its own.

/** Bundlers look for exactly this expression. */
export function newPainterWorker(): Worker {
  return new Worker(new URL('./painter.js', import.meta.url), { type: 'module' })
}

export function painterFile(): URL {
  const here = import.meta.url
  return new URL('./painter.js', here)
}

export const PAINTER_NAME = 'circle-voronoi/painter'
