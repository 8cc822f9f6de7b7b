// SPDX-License-Identifier: GPL-3.0-or-later
// Waits of tests.
import { vi } from 'vitest'

/** Waits for the next turn of the event loop. */
export const aTurn = () => new Promise<unknown>((resolve) => setTimeout(resolve))

/** Waits until a check passes, however busy the machine is. */
export const eventually = <Value>(check: () => Value | Promise<Value>) => vi.waitFor(check, { timeout: 40_000 })
