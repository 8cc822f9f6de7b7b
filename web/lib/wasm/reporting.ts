// SPDX-License-Identifier: GPL-3.0-or-later
import type { Progress } from './options.ts'

/** Tells the progress of a module. `tell` does not throw; the module ends the computation if `isStopped` is set. */
export interface Reporter<Told extends unknown[] = Parameters<Progress>> {
  tell(...told: Told): void
  readonly isStopped: boolean
}

/**
 * Runs a computation of a module that reports to a listener. If that throws, the computation ends. The error is kept
 * and thrown afterwards, because no JavaScript exception may pass through the core.
 */
export function reporting<Told extends unknown[], Value>(
  listener: ((...told: Told) => void) | undefined,
  run: (reporter: Reporter<Told> | undefined) => Value,
): Value {
  if (listener === undefined) return run(undefined)
  let error: unknown
  const reporter = {
    isStopped: false,
    tell(...told: Told) {
      try {
        listener(...told)
      } catch (thrown) {
        error = thrown
        reporter.isStopped = true
      }
    },
  }
  const result = run(reporter)
  if (reporter.isStopped) throw error
  return result
}

/** Returns a function that tells, and returns whether to go on, for modules that ask for that. */
export function goingOn<Told extends unknown[]>(reporter: Reporter<Told>): (...told: Told) => boolean {
  return (...told) => {
    reporter.tell(...told)
    return !reporter.isStopped
  }
}
