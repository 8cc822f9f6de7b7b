// SPDX-License-Identifier: GPL-3.0-or-later
// What is done, line by line, as a reader follows it.

/** A line of a program by its name. */
export type Line = keyof typeof TEXTS

const TEXTS = {
  begin: 'Given: circles; those inside others are left out',
  centers: 'T ← Delaunay graph of the centers',
  angles: 'divide the angle of each triangle at each center',
  samples: 'put a sample where each edge and each dividing ray leaves its circle',
  sampleGraph: 'D ← Delaunay graph of the samples',
  pairs: 'L ← an antipodal disc for every two circles with an edge in D, by radius',
  take: 'while L is not empty: take its smallest disc',
  used: 'if a foot point lies on a used arc: drop the disc',
  notEmpty: 'if it meets a circle next to a foot point: drop the disc',
  place: 'else it is empty: place directed edges a→b and b→a',
  form: 'put the three-touch discs with the next directed edges into L',
  stale: 'if a→b or b→c is gone, or they are no longer next to each other: drop the disc',
  branch: 'else it is empty: its center is a vertex',
  finish: 'finish the segments of a→b, b→c, and c→a if it closes the triangle; delete these edges',
  placeThird: 'if c→a was not there: place a→c where they were',
  formThird: 'put its three-touch discs into L',
  again: 'the judge found an edge wrong: begin again with more samples',
  ties: 'settle ties: where more than three circles touch one disc',
  hull: 'the directed edges that are left are the hull',
  flipCenters: 'T ← Delaunay triangulation of the centers',
  flipDiscs: 'for each triangle of T: the disc that touches its circles',
  flipTest: 'while the disc beside an edge a–b meets the circle opposite, or there is none:',
  flip: 'replace a–b by the edge of the two circles opposite',
  flipDone: 'no edge is wrong: T is the dual of the Voronoi diagram',
  editBegin: 'the diagram as it is: its triangles and their discs',
  edit: 'a circle comes, goes or changes',
  editTest: 'while the disc beside an edge meets the circle (or it shrinks until it touches one):',
  editFlip: 'replace that edge',
  editDone: 'all that changed is judged: it is the diagram again',
} as const

/** Lines under a title; a number says how far one is set in. */
export interface Algorithm {
  readonly title: string
  readonly lines: readonly (readonly [line: Line, depth: number])[]
}

/** The paper's Algorithms 1 to 4, as corrected (ARCHITECTURE.md). */
const TOUCHING: readonly Algorithm[] = [
  {
    title: '1 Prepare',
    lines: [
      ['begin', 0],
      ['centers', 0],
      ['angles', 0],
      ['samples', 0],
      ['sampleGraph', 0],
      ['pairs', 0],
    ],
  },
  { title: '4 Loop', lines: [['take', 0]] },
  {
    title: '2 Antipodal disc of a and b',
    lines: [
      ['used', 1],
      ['notEmpty', 1],
      ['place', 1],
      ['form', 2],
    ],
  },
  {
    title: '3 Three-touch disc of a→b→c',
    lines: [
      ['stale', 1],
      ['branch', 1],
      ['finish', 2],
      ['placeThird', 2],
      ['formThird', 3],
    ],
  },
  {
    title: 'End',
    lines: [
      ['ties', 0],
      ['hull', 0],
    ],
  },
]

const FLIPS: readonly Algorithm[] = [
  {
    title: 'Flips',
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
    title: 'An edit',
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

export function textOf(line: Line): string {
  return TEXTS[line]
}
