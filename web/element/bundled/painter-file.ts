// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../view/painter-file.ts in the one file: its thread runs the same file, and knows by its name what it is.

export const PAINTER_NAME = 'circle-voronoi/painter'

export function painterFile(): URL {
  return new URL(import.meta.url)
}

export function newPainterWorker(): Worker {
  return new Worker(painterFile(), { type: 'module', name: PAINTER_NAME })
}
