// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../threads/thread-file.ts in the bundle: its threads run the same file, and know by their name what they are.
import { scriptOfFile, workerOfFile } from '../one-file.ts'

export const THREAD_NAME = 'circle-voronoi/bundle'

export const threadFile = scriptOfFile

export function newWorker(): Worker {
  return workerOfFile(THREAD_NAME)
}
