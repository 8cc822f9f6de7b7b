// SPDX-License-Identifier: GPL-3.0-or-later
import { circleRadius, circleX, circleY } from '../lib/base/coordinates.ts'
import { at } from '../lib/base/diagram-data.ts'
import type { Circle, Edit, Float64s } from '../lib/index.ts'
import type { CircleTable } from '../view/circle-table.ts'
import type { Areas } from '../view/domain.ts'

/** The circles after edits, and the shares of their cells. */
interface Fitting {
  readonly circles: Float64s
  /** NaN for circles without a share. */
  readonly shares: readonly number[]
  /** Extends the edits so that the circles get these radii. */
  withRadii(fitted: Float64s): Edit[]
}

/** Prepares edits after which cells have areas, which are by id. */
export function fittingAfter(edits: readonly Edit[], table: CircleTable, areas: Areas): Fitting {
  // The table is by ascending id, so that results do not depend on the history of edits.
  const before = new Map(Array.from(table.ids(), (id) => [id, table.get(id) as Circle]))
  const sites = new Map(before)
  const added: Circle[] = []
  const shareOf = (id: number | undefined) =>
    (areas === 'equal' || id === undefined ? undefined : areas[id]) ?? Number.NaN
  for (const edit of edits) {
    if (edit.kind === 'remove') sites.delete(edit.id)
    else {
      const { circle } = edit
      const site = { x: circleX(circle), y: circleY(circle), r: circleRadius(circle) }
      if (edit.kind === 'insert') added.push(site)
      else if (sites.has(edit.id)) sites.set(edit.id, site)
    }
  }
  const all = [...sites.values(), ...added]
  const addedIds = edits.flatMap((edit) => (edit.kind === 'insert' ? [edit.id] : []))
  return {
    circles: Float64Array.from(all.flatMap(({ x, y, r }) => [x, y, r])),
    shares: [...sites.keys(), ...addedIds].map(shareOf),
    withRadii(fitted) {
      const fittedCircle = (k: number) => ({ ...(all[k] as Circle), r: at(fitted, 3 * k + 2) })
      const changed = [...sites.keys()].flatMap((id, k): Edit[] => {
        const circle = fittedCircle(k)
        const { x, y, r } = before.get(id) as Circle
        return x === circle.x && y === circle.y && r === circle.r ? [] : [{ kind: 'replace', id, circle }]
      })
      let k = sites.size
      return [
        ...changed,
        ...edits.flatMap((edit): Edit[] => {
          if (edit.kind === 'insert') return [{ ...edit, circle: fittedCircle(k++) }]
          // The editor reports edits of missing circles.
          return edit.kind === 'remove' || !before.has(edit.id) ? [edit] : []
        }),
      ]
    },
  }
}
