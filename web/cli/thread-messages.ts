// SPDX-License-Identifier: GPL-3.0-or-later

/** What the thread is started with. `ended` becomes 1 when the line has been erased. */
export interface Start {
  readonly args: readonly string[]
  readonly ended: Int32Array
}

/**
 * What it tells: a file that was made and is not yet whole, or none any more; that there is a line, which is first shown
 * after so many milliseconds; what is being done, and how many percent of it are, if that is known; that the line ends.
 */
export type Told =
  | { readonly made: string | undefined }
  | { readonly line: number }
  | { readonly stage: string; readonly percent: number | undefined }
  | { readonly ends: true }
