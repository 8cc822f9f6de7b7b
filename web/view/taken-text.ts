// SPDX-License-Identifier: GPL-3.0-or-later
import type { Taken, Trial } from './protocol.ts'
import { short } from './short.ts'

/** Number of circles named in a text, the greatest losses first. */
const MOST_NAMED = 8

export function namedOf({ taken }: Trial): readonly Taken[] {
  return taken.slice(0, MOST_NAMED)
}

/** An area that is taken; a part that has no end is not measured. */
export function areaText(area: number): string {
  if (Number.isNaN(area)) return 'a part'
  return area === Number.POSITIVE_INFINITY ? '∞' : short(area, 3)
}
