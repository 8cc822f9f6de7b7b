// SPDX-License-Identifier: GPL-3.0-or-later
// Converts areas between the order of the circles and ids, and makes the message to the backend about a changed domain.
import type { CircleTable } from '../view/circle-table.ts'
import { type Areas, type Domain, NO_DOMAIN } from '../view/domain.ts'
import type { DomainChange } from '../view/protocol.ts'
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
  const list = areasFor(circles.count, areas)
  if (list === undefined) return undefined
  const byId: number[] = []
  circles.ids().forEach((id, k) => {
    byId[id] = list[k] as number
  })
  return { areas: byId }
}

/**
 * The change of domain for the backend. It contains the region and the periods only if they differ.
 * @throws Refusal if there is a region as well as periods
 */
export function domainChange(before: Domain, domain: Domain, colors?: string): DomainChange | undefined {
  const { region, lattice, areas } = domain
  if (domain === NO_DOMAIN && before === NO_DOMAIN) return colors === undefined ? undefined : { colors }
  if (region !== undefined && lattice !== undefined)
    throw new Refusal(ENGLISH_REFUSALS, (words) => words.latticeWithRegion)
  return {
    region: region === before.region ? undefined : (region ?? null),
    lattice: lattice === before.lattice ? undefined : (lattice ?? null),
    areSites: areas !== undefined,
    colors,
  }
}

/**
 * The areas of circles in their order, if they are a list.
 * @throws Refusal if there is not one area for each circle
 */
export function areasFor(circles: number, areas: Areas | undefined): readonly number[] | undefined {
  if (areas === undefined || areas === 'equal') return undefined
  const { length } = areas
  if (length !== circles) throw new Refusal(ENGLISH_REFUSALS, (words) => words.areasForCircles(length, circles))
  return areas
}
