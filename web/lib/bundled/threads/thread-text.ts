// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces ../../../view/painter-file.ts in the element's one-file build. The text of the thread is a string, so no compiler or
// bundler changes it.
import text from './painter.thread'

export const THREAD_NAME = 'circle-voronoi/painter'

/** Returns the text of the thread's script. */
export function threadFile(): string {
  return text
}

/** Throws, because there is no file for a worker. */
export function newWorker(): Worker {
  throw new DOMException('The thread has no file.', 'SecurityError')
}
