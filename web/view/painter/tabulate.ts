// SPDX-License-Identifier: GPL-3.0-or-later
import type { Column, Tabulated } from '../protocol.ts'
import { idOf } from './cell-boxes.ts'
import type { Picture } from './picture.ts'

/** Number of cells measured before the generator yields. */
const CELLS_AT_ONCE = 64

/** Measures the cells of circles. Missing ids are left out. */
export function tabulated(picture: Picture, columns: readonly Column[], ids: Int32Array): Tabulated {
  const { diagram } = picture
  const there = ids.filter((id) => diagram.indexOf(id) >= 0)
  return {
    ids: there,
    columns: columns.map((column) => Float64Array.from(there, (id) => numberOf(picture, column, id))),
  }
}

/** Measures the cells of all circles in steps. The circles may change between steps. */
export function* tabulatedAll(picture: Picture, columns: readonly Column[]): Generator<void, Tabulated> {
  const { diagram } = picture
  for (let i = 0; i < picture.count; i++) {
    for (const column of columns) numberOf(picture, column, idOf(diagram, i))
    if (i % CELLS_AT_ONCE === 0) yield
  }
  // Measures only the cells again that have changed since.
  const ids = Int32Array.from({ length: picture.count }, (_, i) => idOf(diagram, i))
  return tabulated(picture, columns, ids)
}

function numberOf(picture: Picture, column: Column, id: number): number {
  const { diagram } = picture
  const i = diagram.indexOf(id)
  if (!diagram.cells.exists(i)) return Number.NaN
  if (column === 'area') return picture.areas().valueOf(i)
  if (column === 'gap') return picture.gaps().valueOf(i)
  return new Set(diagram.neighbors(i)).size
}
