// SPDX-License-Identifier: GPL-3.0-or-later
// In place of web/lib/threads/thread.ts: a test says what its threads are.
import type { ThreadEvents } from '../../web/lib/threads/thread.ts'

let start: (events: ThreadEvents) => unknown

/** Has `startThread` start these threads from now on. */
export function useThreads(starts: (events: ThreadEvents) => unknown): void {
  start = starts
}

export function startThread(events: ThreadEvents): unknown {
  return start(events)
}
