// SPDX-License-Identifier: GPL-3.0-or-later
// Waits of tests.
import { vi } from 'vitest'

/** Waits for the next turn of the event loop. */
export const aTurn = () => new Promise<unknown>((resolve) => setTimeout(resolve))

/** Waits until a check passes, however busy the machine is. */
export const eventually = <Value>(check: () => Value | Promise<Value>) => vi.waitFor(check, { timeout: 40_000 })

/** Lets promises pass that wait for no event, also while timers are faked. */
export async function settled(): Promise<void> {
  for (let k = 0; k < 30; k++) await Promise.resolve()
}

/** Lets the clock go on by some milliseconds whenever it is read. Returns a function that ends this. */
export function tickingClock(step: number): () => void {
  let now = performance.now()
  const clock = vi.spyOn(performance, 'now').mockImplementation(() => {
    now += step
    return now
  })
  return () => clock.mockRestore()
}
