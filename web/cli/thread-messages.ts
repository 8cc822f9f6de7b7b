// SPDX-License-Identifier: GPL-3.0-or-later

/** The data that the thread starts with. `ended` becomes 1 when the line has been erased. */
export interface Start {
  readonly args: readonly string[]
  readonly ended: Int32Array
}

/**
 * The messages of the thread: the incomplete output file, if any; the start of the progress line, with its delay in
 * milliseconds; the stage and, if known, the percentage; the end of the line.
 */
export type Told =
  | { readonly made: string | undefined }
  | { readonly line: number }
  | { readonly stage: string; readonly percent: number | undefined }
  | { readonly ends: true }
