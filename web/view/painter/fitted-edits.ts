// SPDX-License-Identifier: GPL-3.0-or-later

import { circleRadius, circleX, circleY } from '../../lib/base/coordinates.ts'
import { at, circleOf } from '../../lib/base/diagram-data.ts'
import type { Diagram, Edit } from '../../lib/index.ts'
import type { Region } from '../../lib/regions/region.ts'
import type { AreaFit } from '../../lib/wasm/fit.ts'
import type { Regions } from '../../lib/wasm/regions.ts'
import type { Shares } from '../protocol.ts'
import { ENGLISH_REFUSALS, Refusal } from '../refusal.ts'
import { idOf } from './cell-boxes.ts'

/** Smaller errors are invisible. If a region has distant parts, rounding of weights alone causes errors of 1e-8. */
const TOLERANCE = 1e-6
/** More circles would take too long to fit. */
const MOST_FITTED = 10_000

/** A region, and the function that fits areas to it. */
export interface Fitting extends Pick<Regions, 'fitAreas'> {
  readonly region: Region
}

/**
 * The radii for which each circle's cell has its share of a region. In `shares`, NaN stands for the mean.
 * @throws CircleVoronoiError as `fitAreas`
 */
export function fitted({ region, fitAreas }: Fitting, circles: Float64Array, shares: readonly number[]): AreaFit {
  if (shares.length > MOST_FITTED) throw new Refusal(ENGLISH_REFUSALS, (words) => words.tooManyForAreas(MOST_FITTED))
  const named = shares.filter((share) => share > 0)
  const mean = named.length === 0 ? 1 : named.reduce((sum, share) => sum + share, 0) / named.length
  const all = shares.map((share) => (share > 0 ? share : mean))
  return fitAreas(circles, all, { region, shares: true, tolerance: TOLERANCE })
}

/**
 * Extends edits so that all circles get the radii for which their cells have their shares.
 * @throws CircleVoronoiError as `fitAreas`
 */
export function fittedEdits(
  fitting: Fitting,
  diagram: Diagram,
  edits: readonly Edit[],
  { known, inserted }: Shares,
): { readonly edits: readonly Edit[]; readonly fit: AreaFit | undefined } {
  const sites = new Map<number, readonly [x: number, y: number, r: number]>()
  for (let i = 0; i < diagram.circles.length / 3; i++) {
    const { x, y, r } = circleOf(diagram.circles, i)
    sites.set(idOf(diagram, i), [x, y, r])
  }
  const before = new Map(sites)
  const added: (readonly [x: number, y: number, r: number])[] = []
  for (const edit of edits) {
    if (edit.kind === 'remove') sites.delete(edit.id)
    else {
      const { circle } = edit
      const site = [circleX(circle), circleY(circle), circleRadius(circle)] as const
      if (edit.kind === 'insert') added.push(site)
      else if (sites.has(edit.id)) sites.set(edit.id, site)
    }
  }
  // Sorts sites by id, so that results do not depend on the history of edits.
  const ids = [...sites.keys()].sort((one, other) => one - other)
  const all = [...ids.map((id) => sites.get(id) as readonly [number, number, number]), ...added]
  if (all.length === 0) return { edits, fit: undefined }
  const shares = [...ids.map((id) => known?.get(id) ?? Number.NaN), ...added.map((_, k) => inserted[k] ?? Number.NaN)]
  const fit = fitted(fitting, Float64Array.from(all.flat()), shares)
  const fittedCircle = (k: number) => {
    const [x, y] = all[k] as readonly [number, number, number]
    return { x, y, r: at(fit.weights, k) }
  }
  const changed = ids.flatMap((id, k): Edit[] => {
    const circle = fittedCircle(k)
    const [x, y, r] = before.get(id) as readonly [number, number, number]
    return x === circle.x && y === circle.y && r === circle.r ? [] : [{ kind: 'replace', id, circle }]
  })
  let k = ids.length
  return {
    edits: [
      ...changed,
      ...edits.flatMap((edit): Edit[] => {
        if (edit.kind === 'insert') return [{ ...edit, circle: fittedCircle(k++) }]
        // The editor reports edits of missing circles.
        return edit.kind === 'remove' || !before.has(edit.id) ? [edit] : []
      }),
    ],
    fit,
  }
}
