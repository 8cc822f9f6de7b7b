// SPDX-License-Identifier: GPL-3.0-or-later
// Converts areas between the order of the circles and ids, and makes the message to the backend about a changed domain.
import type { Edit } from '../lib/index.ts'
import type { CircleTable, KeptIds } from '../view/circle-table.ts'
import { type Areas, type Domain, NO_DOMAIN } from '../view/domain.ts'
import type { DomainChange, Shares } from '../view/protocol.ts'
import { ENGLISH_REFUSALS, Refusal } from '../view/refusal.ts'

/** The areas of a domain in the order of the circles. Circles without one get the mean. */
export function areasInOrder({ areas }: Domain, circles: CircleTable): Areas | undefined {
  if (areas === undefined || areas === 'equal') return areas
  const known = Array.from(circles.ids(), (id) => areas[id])
  const named = known.filter((share) => share !== undefined)
  const mean = named.reduce((sum, share) => sum + share, 0) / named.length
  return known.map((share) => share ?? mean)
}

/**
 * Converts areas from the order of the circles to ids. Returns `undefined` if there is no list.
 * @throws Refusal if there is not one area for each circle
 */
export function areasById(areas: Areas | undefined, circles: CircleTable): Pick<Domain, 'areas'> | undefined {
  const list = listIn(areas, circles.count)
  if (list === undefined) return undefined
  const byId: number[] = []
  circles.ids().forEach((id, k) => {
    byId[id] = list[k] as number
  })
  return { areas: byId }
}

/**
 * The change of domain for the backend. It contains the region and the periods only if they differ, and shares only if
 * there are areas.
 */
export function domainChange(
  before: Domain,
  domain: Domain,
  shares: () => Shares,
  colors?: string,
): DomainChange | undefined {
  const { region, lattice, areas } = domain
  if (domain === NO_DOMAIN && before === NO_DOMAIN) return colors === undefined ? undefined : { colors }
  return {
    region: region === before.region ? undefined : (region ?? null),
    lattice: lattice === before.lattice ? undefined : (lattice ?? null),
    areSites: areas !== undefined,
    fit: areas && shares(),
    colors,
  }
}

/**
 * The shares of circles to open, whose areas are in their order.
 * @throws Refusal if there is not one area for each circle
 */
export function sharesInOrder({ areas }: Domain, count: number, kept: KeptIds | undefined): Shares {
  const list = listIn(areas, count)
  return { known: list && new Map(list.map((share, k) => [kept?.ids[k] ?? k, share])), inserted: [] }
}

/** The shares of the current circles and of the circles that edits insert. The areas are by id. */
export function sharesOf({ areas }: Domain, circles: CircleTable, edits: readonly Edit[]): Shares {
  if (areas === undefined || areas === 'equal') return { known: undefined, inserted: [] }
  const shareOf = (id: number | undefined) => (id === undefined ? undefined : areas[id]) ?? Number.NaN
  return {
    known: new Map(Array.from(circles.ids(), (id) => [id, shareOf(id)])),
    inserted: edits.flatMap((edit) => (edit.kind === 'insert' ? [shareOf(edit.id)] : [])),
  }
}

/** @throws Refusal if the length of a list is not the number of circles */
function listIn(areas: Areas | undefined, circles: number): readonly number[] | undefined {
  if (areas === undefined || areas === 'equal') return undefined
  const { length } = areas
  if (length !== circles) throw new Refusal(ENGLISH_REFUSALS, (words) => words.areasForCircles(length, circles))
  return areas
}
