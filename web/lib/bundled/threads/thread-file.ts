// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../threads/thread-file.ts in the bundle: its threads run the same file, and know by their name what they are.

export const THREAD_NAME = 'circle-voronoi/bundle'

export function threadFile(): URL {
  return new URL(import.meta.url)
}

export function newWorker(): Worker {
  return new Worker(threadFile(), { type: 'module', name: THREAD_NAME })
}
