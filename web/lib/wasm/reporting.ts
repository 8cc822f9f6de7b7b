// SPDX-License-Identifier: GPL-3.0-or-later
import type { Progress } from './options.ts'

/** Tells the progress of a module. `tell` does not throw; the module ends the computation if `isStopped` is set. */
export interface Reporter {
  readonly tell: Progress
  readonly isStopped: boolean
}

/**
 * Runs a computation of a module that reports to `progress`. If that throws, the computation ends. The error is kept
 * and thrown afterwards, because no JavaScript exception may pass through the core.
 */
export function reporting<Value>(
  progress: Progress | undefined,
  run: (reporter: Reporter | undefined) => Value,
): Value {
  if (progress === undefined) return run(undefined)
  let error: unknown
  const reporter = {
    isStopped: false,
    tell(...told: Parameters<Progress>) {
      try {
        progress(...told)
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
