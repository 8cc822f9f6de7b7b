// SPDX-License-Identifier: GPL-3.0-or-later
import type { View } from '../../web/view/view.ts'

/** The areas of the cells of the first circles, inside the region. */
export async function areasOf(view: View, count: number): Promise<number[]> {
  const ids = Array.from({ length: count }, (_, id) => id)
  const told = await view.scene.ask('tell', [ids])
  return ids.map((id) => told?.cells.get(id)?.area ?? Number.NaN)
}
