// SPDX-License-Identifier: GPL-3.0-or-later
import type { Distribution } from '../protocol.ts'
import type { Picture } from './picture.ts'

const CLASSES = 32
/** Share of the areas below the last class. The last class contains all larger ones. */
const LARGEST_SHARE = 0.92
/** Number of cells measured before the generator yields. */
const CELLS_AT_ONCE = 64

/** Computes the distribution of cells in steps. The picture may change between steps. */
export function* distributionOf(picture: Picture): Generator<void, Distribution> {
  const { diagram } = picture
  const measures = picture.areas()
  for (let i = 0; i < picture.count; i++) {
    measures.valueOf(i)
    if (i % CELLS_AT_ONCE === 0) yield
  }
  // Measures cells again that have changed since.
  const { cells } = diagram
  const degrees: number[] = []
  const areas: number[] = []
  for (let i = 0; i < picture.count; i++) {
    if (!cells.exists(i)) continue
    const degree = new Set(diagram.neighbors(i)).size
    while (degrees.length <= degree) degrees.push(0)
    degrees[degree] = (degrees[degree] as number) + 1
    const area = measures.valueOf(i)
    if (Number.isFinite(area)) areas.push(area)
  }
  const sorted = Float64Array.from(areas).sort()
  const most = sorted[Math.floor(LARGEST_SHARE * sorted.length)] ?? 0
  const areaStep = most / (CLASSES - 1)
  const classes = new Int32Array(CLASSES)
  for (const area of sorted) {
    const own = areaStep > 0 ? Math.min(Math.floor(area / areaStep), CLASSES - 1) : 0
    classes[own] = (classes[own] as number) + 1
  }
  return {
    degrees: Int32Array.from(degrees),
    areas: classes,
    areaStep,
    medianArea: sorted[sorted.length >> 1] ?? 0,
    certificate: picture.editor.certificate(),
  }
}
