// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces ../../threads/thread-file.ts in the library's one-file build. scripts/bundle.mjs wraps the build in a function.
// Its threads run the same file and tell by their name what to do.

/** The function that contains this whole file. Its argument is the address of the file. */
declare function wholeFile(address: string): unknown

const here = import.meta.url
/** Whether this script is pasted into a page: it then has the page's address. */
const isPasted = here === globalThis.document?.baseURI

export const THREAD_NAME = 'circle-voronoi/bundle'

/** Returns the text of a script that does the same as this file. */
export function threadFile(): string {
  return `'use strict';(${wholeFile})(${JSON.stringify(here)})`
}

/**
 * Returns a worker that runs this file. If the page may load the file from its address, the text need not be copied.
 */
export function newWorker(): Worker {
  if (isPasted) throw new DOMException('This script has no file.', 'SecurityError')
  return new Worker(here, { type: 'module', name: THREAD_NAME })
}
