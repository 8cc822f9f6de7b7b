// SPDX-License-Identifier: GPL-3.0-or-later
// What a bundle needs that is one file, to have its threads run that file, too. scripts/bundle.mjs makes a function of all of it.

/** All of this file as a function of its address. */
declare function wholeFile(address: string): unknown

const here = import.meta.url
/** A script that is pasted into a page has the page's address. */
const isPasted = here === globalThis.document?.baseURI

/** The text of a script that does what this file does. */
export function scriptOfFile(): string {
  return `'use strict';(${wholeFile})(${JSON.stringify(here)})`
}

/** A worker that runs this file: where a page may take it from there, it need not be copied. */
export function workerOfFile(name: string): Worker {
  if (isPasted) throw new DOMException('This script has no file.', 'SecurityError')
  return new Worker(here, { type: 'module', name })
}
