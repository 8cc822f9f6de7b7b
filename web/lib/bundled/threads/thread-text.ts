// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../../view/painter-file.ts in the element's script. The text of its thread is a string, which no compiler and no
// bundler changes, wherever the script becomes a part of something else.
import text from './painter.thread'

export const THREAD_NAME = 'circle-voronoi/painter'

/** The text of a script that is the thread. */
export function threadFile(): string {
  return text
}

/** There is no file that a worker could be made of. */
export function newWorker(): Worker {
  throw new DOMException('The thread has no file.', 'SecurityError')
}
