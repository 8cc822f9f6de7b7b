// SPDX-License-Identifier: GPL-3.0-or-later
// What the bundle is for, the same in Node and in a page.
export const CIRCLES = [
  [0, 0, 1],
  [6, 0, 1],
  [0, 8, 1],
]

/** What comes out, as text, of a module that has the library and its worker. */
export async function useBundle({ createWorker, loadCircleVoronoi }) {
  const library = await loadCircleVoronoi()
  const worker = createWorker()
  const there = await worker.compute(CIRCLES)
  worker.dispose()
  return `${library.compute(CIRCLES).vertices.join()} ${there.vertices.join()}`
}
