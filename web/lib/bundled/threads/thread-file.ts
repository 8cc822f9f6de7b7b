// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../threads/thread-file.ts and ../../../view/painter-file.ts in the one-file builds, of which
// scripts/bundle.mjs makes a function: their threads run the same file, and know by their name what they are.

/** All of this file as a function of its address. */
declare function wholeFile(address: string): unknown

const here = import.meta.url
/** A script that is pasted into a page has the page's address. */
const isPasted = here === globalThis.document?.baseURI

export const THREAD_NAME = 'circle-voronoi/bundle'

/** The text of a script that does what this file does. */
export function threadFile(): string {
  return `'use strict';(${wholeFile})(${JSON.stringify(here)})`
}

/** A worker that runs this file: where a page may take it from there, it need not be copied. */
export function newWorker(): Worker {
  if (isPasted) throw new DOMException('This script has no file.', 'SecurityError')
  return new Worker(here, { type: 'module', name: THREAD_NAME })
}
