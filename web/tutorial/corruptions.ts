// SPDX-License-Identifier: GPL-3.0-or-later
// Corruptions of a figure's diagram, one for each check of the judge.
import { type CircleVoronoi, Diagram, type Float64s } from '../lib/index.ts'

/** One kind of corruption. */
export interface Corruption {
  readonly name: string
  /** Names the check that detects the corruption, and the reason. */
  readonly about: string
  /** Corrupts the right diagram of some circles; `undefined` if these circles leave nothing to corrupt. */
  make(right: Diagram, library: CircleVoronoi): Diagram | undefined
}

/** Distance by which a vertex moves, relative to the radius of its disc. */
const NUDGE = 0.1
/**
 * The number of attempts at moving or resizing a circle until the structure changes, within a fraction of the distance
 * between the first two circles.
 */
const MOST_TRIED = 3000
const REACH = 2

const changed = (right: Diagram, change: Partial<Diagram>) => new Diagram({ ...dataOf(right), ...change })

/** Claims the structure of another diagram for these circles. The judge has to find exactly this flaw. */
const structureWith =
  (flaw: string): Corruption['make'] =>
  (right, library) => {
    const { circles } = right
    const unit = Math.hypot((circles[3] ?? 0) - (circles[0] ?? 0), (circles[4] ?? 0) - (circles[1] ?? 0))
    const claim = (moved: Float64Array<ArrayBuffer>) => {
      const other = library.compute(moved)
      if (`${other.hidden}` !== `${right.hidden}`) return undefined
      const claimed = changed(other, { circles })
      return library.certify(claimed).flaw === flaw ? claimed : undefined
    }
    // A fixed seed, so that the same circles always give the same corruption.
    let seed = 1
    const random = () => {
      seed = (seed * 1_103_515_245 + 12_345) % 2_147_483_648
      return seed / 2_147_483_648
    }
    for (let tried = 0; tried < MOST_TRIED; tried++) {
      const k = 3 * Math.floor((random() * circles.length) / 3)
      const moved = Float64Array.from(circles)
      moved[k] = (moved[k] as number) + REACH * unit * (random() - 0.5)
      moved[k + 1] = (moved[k + 1] as number) + REACH * unit * (random() - 0.5)
      moved[k + 2] = (moved[k + 2] as number) * Math.exp(4 * random() - 2)
      const found = claim(moved)
      if (found !== undefined) return found
    }
    return undefined
  }

export const CORRUPTIONS: readonly Corruption[] = [
  {
    name: 'Move a vertex a little',
    about: 'Vertices: a vertex has to be the center of the disc that touches its three circles.',
    make: (right) => {
      if (right.vertices.length === 0) return undefined
      const vertices = Float64Array.from(right.vertices)
      vertices[0] = (vertices[0] as number) + NUDGE * (vertices[2] as number)
      return changed(right, { vertices })
    },
  },
  {
    name: 'Claim a vertex where no disc touches its circles',
    about: 'Vertices: a disc has to touch the three circles of each vertex.',
    make: structureWith('vertexWithoutDisc'),
  },
  {
    name: 'Keep an edge that should have been flipped',
    about: 'Edges: the two ends of an edge have to come in the right order along the hyperbola.',
    make: structureWith('edgeOutOfOrder'),
  },
  {
    name: 'Let a cell miss its circle',
    about: 'Cells: the corners of a cell have to go around its circle exactly once.',
    make: structureWith('cellNotClosed'),
  },
  {
    name: 'Give a vertex another circle',
    about: 'Counts: the parts no longer fit together, because an edge and its vertex name different circles.',
    make: (right) => {
      const { vertexCircles } = right
      const visible = Array.from({ length: right.circles.length / 3 }, (_, i) => i).filter((i) => right.cells.exists(i))
      const other = visible.find((i) => !vertexCircles.subarray(0, 3).includes(i))
      if (vertexCircles.length === 0 || other === undefined) return undefined
      const given = Int32Array.from(vertexCircles)
      given[0] = other
      return changed(right, { vertexCircles: given })
    },
  },
  {
    name: 'Leave out the cell of a circle',
    about: 'Counts: Euler’s formula says how many vertices and edges there must be for so many circles with cells.',
    make: (right, library) => {
      const { circles, hidden } = right
      const count = circles.length / 3
      const visible = Array.from({ length: count }, (_, i) => i).filter((i) => right.cells.exists(i))
      const [largest, left] = [visible[0], visible.at(-1)]
      if (largest === undefined || left === undefined || visible.length < 4) return undefined
      // A circle inside another one has no cell.
      const without = Float64Array.from(circles)
      without.set([circles[3 * largest] as number, circles[3 * largest + 1] as number], 3 * left)
      without[3 * left + 2] = (circles[3 * largest + 2] as number) / 2
      return changed(library.compute(without), { circles, hidden })
    },
  },
  {
    name: 'Name the wrong hider of a hidden circle',
    about: 'Hidden circles: the circle that is named has to contain the hidden one.',
    make: (right) => {
      const [circle, by] = right.hidden
      const other = Array.from({ length: right.circles.length / 3 }, (_, i) => i).find((i) => i !== circle && i !== by)
      if (circle === undefined || other === undefined) return undefined
      const hidden = Int32Array.from(right.hidden)
      hidden[1] = other
      return changed(right, { hidden })
    },
  },
]

/** Copies a diagram into plain data from which a modified diagram can be made. */
function dataOf(diagram: Diagram) {
  const { metric, circles, vertices, vertexCircles, edges, hidden, hull, nextSide, vertexSides, firstSide } = diagram
  const { weights, certificate, stats } = diagram
  return {
    ...{ metric, circles: circles as Float64s, vertices, vertexCircles, edges, hidden, hull },
    ...{ nextSide, vertexSides, firstSide, weights, certificate, stats },
  }
}
