// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError } from '../../lib/base/errors.ts'
import type { Edit, Lattice, Options } from '../../lib/index.ts'
import type { CircleVoronoi } from '../../lib/wasm/library.ts'
import type { TraceOptions } from '../../lib/wasm/trace.ts'
import { checkPlayed } from '../layers.ts'
import type { Computed, Traced } from '../protocol.ts'

/**
 * Traces a method on circles in ascending order of their ids.
 * @throws CircleVoronoiError as `trace` and `checkPlayed`
 */
export function traced(library: CircleVoronoi, circles: Float64Array, ids: Int32Array, options: TraceOptions): Traced {
  checkPlayed(ids.length)
  const names = [...ids]
  const edits = options.edits && byIndex(options.edits, names)
  const { diagram, kinds, discs, vertices, ...trace } = library.trace(circles, { ...options, edits })
  const named = trace.circles.map((i) => (i < 0 ? i : (names[i] as number)))
  return { circles, ids, diagram, events: { kinds, discs, vertices, circles: named, numbers: trace.numbers } }
}

/** Computes the diagram of circles from scratch, and of their images if they repeat. */
export function computed(
  library: CircleVoronoi,
  circles: Float64Array,
  lattice: Lattice | undefined,
  options: Options,
): Computed {
  try {
    const all = lattice === undefined ? circles : library.computePeriodic(circles, lattice).diagram.circles
    const { stats, certificate } = library.compute(all, options)
    return { stats, certificate }
  } catch (error) {
    if (!(error instanceof CircleVoronoiError)) throw error
    return { problem: error.message }
  }
}

/** Translates edits by id into edits by index. Inserted circles get the next indices and are added to `names`. */
function byIndex(edits: Iterable<Edit>, names: number[]): Edit[] {
  let next = (names.at(-1) ?? -1) + 1
  return Array.from(edits, (edit) => {
    if (edit.kind === 'insert') {
      names.push(edit.id ?? next++)
      return { kind: 'insert', circle: edit.circle }
    }
    const { id } = edit
    const place = names.indexOf(id)
    if (place < 0) throw new CircleVoronoiError('unknownCircle', `There is no circle with id ${id}.`, { circle: id })
    return { ...edit, id: place }
  })
}
