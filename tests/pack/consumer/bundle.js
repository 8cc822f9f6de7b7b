// SPDX-License-Identifier: GPL-3.0-or-later
// Uses the bundle in the same way in Node and in a page.
export const CIRCLES = [
  [0, 0, 1],
  [6, 0, 1],
  [0, 8, 1],
]

/** Returns the results of the library and of its worker as text. */
export async function useBundle({ createWorker, loadCircleVoronoi }) {
  const library = await loadCircleVoronoi()
  const worker = createWorker()
  const there = await worker.compute(CIRCLES)
  worker.dispose()
  return `${library.compute(CIRCLES).vertices.join()} ${there.vertices.join()}`
}
