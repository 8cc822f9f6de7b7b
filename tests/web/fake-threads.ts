// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces web/lib/threads/thread.ts, so that tests provide the threads.
import type { ThreadEvents } from '../../web/lib/threads/thread.ts'

let start: (events: ThreadEvents) => unknown

/** Makes `startThread` start these threads. */
export function useThreads(starts: (events: ThreadEvents) => unknown): void {
  start = starts
}

export function startThread(events: ThreadEvents): unknown {
  return start(events)
}
