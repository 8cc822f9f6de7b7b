// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../view/painter-file.ts in the one file: its thread runs the same file, and knows by its name what it is.

export const PAINTER_NAME = 'circle-voronoi/painter'

/** All of this file as a function of its address (scripts/bundle.mjs). */
declare function wholeFile(address: string): unknown

/** The file itself: where a page takes no workers from its address, it has no need to load it once more. */
export function painterFile(): string {
  const here = import.meta.url
  return `'use strict';(${wholeFile})(${JSON.stringify(here)})`
}

export function newPainterWorker(): Worker {
  const here = import.meta.url
  // Pasted into a page, it has the page's address.
  if (here === document.baseURI) throw new DOMException('This script has no file.', 'SecurityError')
  return new Worker(here, { type: 'module', name: PAINTER_NAME })
}
