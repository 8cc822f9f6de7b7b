// SPDX-License-Identifier: GPL-3.0-or-later
// The algorithms as lines of pseudocode, highlighted during playback.

import type { PlayerWords, PseudocodeLine } from './words.ts'

/** Lines of pseudocode with a title. The numbers are indentation levels. */
export interface Algorithm {
  readonly title: keyof PlayerWords['titles']
  readonly lines: readonly (readonly [line: PseudocodeLine, depth: number])[]
}

/** The paper's Algorithms 1 to 4, as corrected (cpp/src/README.md). */
const TOUCHING: readonly Algorithm[] = [
  {
    title: 'prepare',
    lines: [
      ['begin', 0],
      ['centers', 0],
      ['angles', 0],
      ['samples', 0],
      ['sampleGraph', 0],
      ['pairs', 0],
    ],
  },
  { title: 'loop', lines: [['take', 0]] },
  {
    title: 'antipodal',
    lines: [
      ['used', 1],
      ['notEmpty', 1],
      ['place', 1],
      ['form', 2],
    ],
  },
  {
    title: 'threeTouch',
    lines: [
      ['stale', 1],
      ['branch', 1],
      ['finish', 2],
      ['placeThird', 2],
      ['formThird', 3],
    ],
  },
  {
    title: 'end',
    lines: [
      ['ties', 0],
      ['hull', 0],
    ],
  },
]

const FLIPS: readonly Algorithm[] = [
  {
    title: 'flips',
    lines: [
      ['begin', 0],
      ['flipCenters', 0],
      ['flipDiscs', 0],
      ['flipTest', 0],
      ['flip', 1],
      ['flipDone', 0],
    ],
  },
]

const EDITS: readonly Algorithm[] = [
  {
    title: 'edit',
    lines: [
      ['begin', 0],
      ['editBegin', 0],
      ['edit', 0],
      ['editTest', 1],
      ['editFlip', 2],
      ['editDone', 0],
    ],
  },
]

export type Program = 'touching' | 'flips' | 'edits'

export const PROGRAMS: Readonly<Record<Program, readonly Algorithm[]>> = {
  touching: TOUCHING,
  flips: FLIPS,
  edits: EDITS,
}
