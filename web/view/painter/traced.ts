// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../../lib/base/diagram-data.ts'
import { CircleVoronoiError } from '../../lib/base/errors.ts'
import type { DiagramSnapshot, Edit } from '../../lib/index.ts'
import type { CircleVoronoi } from '../../lib/wasm/library.ts'
import type { TraceOptions } from '../../lib/wasm/trace.ts'
import { MOST_PLAYED } from '../layers.ts'
import type { Traced } from '../protocol.ts'
import { wholeNumber } from '../whole-number.ts'

/**
 * Traces a method on the circles of an editor's diagram, whose indices have no particular order.
 * @throws CircleVoronoiError as `trace`; `tooManyCircles`
 */
export function traced(library: CircleVoronoi, { circles, numbers }: DiagramSnapshot, options: TraceOptions): Traced {
  const count = circles.length / 3
  if (count > MOST_PLAYED) {
    const reason = `A method is played for ${wholeNumber(MOST_PLAYED)} circles at most; there are ${wholeNumber(count)}.`
    throw new CircleVoronoiError('tooManyCircles', reason)
  }
  const idOf = (i: number) => at(numbers?.circles as Int32Array, i)
  const order = Int32Array.from({ length: count }, (_, i) => i).sort((i, j) => idOf(i) - idOf(j))
  const sorted = new Float64Array(3 * count)
  for (const [k, i] of order.entries()) sorted.set(circles.subarray(3 * i, 3 * i + 3), 3 * k)
  const ids = order.map(idOf)
  const names = [...ids]
  const edits = options.edits && byIndex(options.edits, names)
  const { diagram, kinds, discs, vertices, ...trace } = library.trace(sorted, { ...options, edits })
  const named = trace.circles.map((i) => (i < 0 ? i : (names[i] as number)))
  return { circles: sorted, ids, diagram, events: { kinds, discs, vertices, circles: named, numbers: trace.numbers } }
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
