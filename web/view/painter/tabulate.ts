// SPDX-License-Identifier: GPL-3.0-or-later
import type { Column, Tabulated } from '../protocol.ts'
import { idOf } from './cell-boxes.ts'
import type { Picture } from './picture.ts'

/** So many cells are measured before others may do something. */
const CELLS_AT_ONCE = 64

/** What the cells of circles measure; ids that no circle has are left out. */
export function tabulated(picture: Picture, columns: readonly Column[], ids: Int32Array): Tabulated {
  const { diagram } = picture
  const there = ids.filter((id) => diagram.indexOf(id) >= 0)
  return {
    ids: there,
    columns: columns.map((column) => Float64Array.from(there, (id) => numberOf(picture, column, id))),
  }
}

/** The same of all circles: in steps, between which they may change. */
export function* tabulatedAll(picture: Picture, columns: readonly Column[]): Generator<void, Tabulated> {
  const { diagram } = picture
  for (let i = 0; i < picture.count; i++) {
    for (const column of columns) numberOf(picture, column, idOf(diagram, i))
    if (i % CELLS_AT_ONCE === 0) yield
  }
  // What has changed meanwhile is measured once more; the rest is known.
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
