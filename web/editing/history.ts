// SPDX-License-Identifier: GPL-3.0-or-later
import type { Float64s } from '../lib/index.ts'
import type { UndoEdit } from '../view/circle-table.ts'
import type { Domain } from '../view/domain.ts'
import { type Attributes, bytesOfAttributes, NO_ATTRIBUTES } from './attributes.ts'
import type { Numbering } from './circle-numbers.ts'
import { PackedSteps } from './packed-steps.ts'

/** A set of circles that are opened together. */
export interface CircleSet {
  readonly circles: Float64s
  /** The name of a data set, or an empty text. */
  readonly dataSet: string
  /** Whether the circles differ from those of the data set. */
  readonly isEdited: boolean
  /** The names and other attributes. */
  readonly attributes?: Attributes | undefined
  /** The clipping region and the areas, if any. */
  readonly domain?: Domain | undefined
  /** The colors of the circles, if they are not to be chosen anew (`LinkState.colors`). */
  readonly colors?: string | undefined
}

/** The edits that undo one gesture. */
interface Edits {
  readonly kind: 'edits'
  readonly steps: PackedSteps
  /** The former domain; `undefined` if the gesture did not change it. */
  readonly domain?: Domain | undefined
  /** The former attributes; `undefined` if the gesture did not change them. */
  readonly attributes?: Attributes | undefined
  readonly gesture: number
}

/** The entry that restores circles replaced by an opening. */
export interface Opening {
  readonly kind: 'opening'
  readonly scene: CircleSet
  /** The former ids of the circles, in ascending order. */
  readonly ids: Int32Array
  /** The numbers of circles by their ids. Attributes, areas and older entries refer to these numbers. */
  readonly numbering: Numbering
}

/** The entries that undo and redo apply, newest last. */
export interface History {
  readonly done: readonly (Edits | Opening)[]
  readonly undone: readonly (Edits | Opening)[]
}

export const EMPTY_HISTORY: History = { done: [], undone: [] }

/** Records the entry that reverts an edit. Edits of one gesture, such as a drag, share an entry. */
export function record(
  { done }: History,
  steps: readonly UndoEdit[],
  gesture: number,
  { domain, attributes }: Partial<Pick<Edits, 'domain' | 'attributes'>> = {},
): History {
  const last = done.at(-1)
  if (last?.kind !== 'edits' || last.gesture !== gesture) {
    const entry: Edits = { kind: 'edits', steps: PackedSteps.of(steps), gesture, domain, attributes }
    return { done: [...done, entry], undone: [] }
  }
  // Circles that the gesture has already changed or inserted keep their first recorded state.
  const known = last.steps.known()
  const more = steps.filter((step) => step.kind !== 'replace' || !known.has(step.id))
  const entry = {
    ...last,
    steps: last.steps.after(more),
    domain: last.domain ?? domain,
    attributes: last.attributes ?? attributes,
  }
  return { done: [...done.slice(0, -1), entry], undone: [] }
}

/** Translates the history to new ids of circles. Entries before an opening refer to other circles and stay. */
export function renamed({ done, undone }: History, idOf: (id: number) => number): History {
  const rename = (entries: History['done']): History['done'] => {
    const from = entries.findLastIndex(({ kind }) => kind === 'opening') + 1
    return [...entries.slice(0, from), ...(entries.slice(from) as Edits[]).map(renameEdits)]
  }
  const renameEdits = (entry: Edits): Edits => ({ ...entry, steps: entry.steps.renamed(idOf) })
  return { done: rename(done), undone: rename(undone) }
}

/** Memory limit of a history in bytes: 46 moves of 100,000 circles. */
export const MOST_BYTES = 2 ** 27
/** Overhead of an entry, in bytes. */
const ENTRY_BYTES = 200

/**
 * Limits the memory of a history by removing the entries farthest from the present, on both sides. The nearest entry of
 * each side stays.
 */
export function limited({ done, undone }: History, most: number): History {
  let bytes = [...done, ...undone].reduce((sum, entry) => sum + bytesOf(entry), 0)
  const withoutFarthest = (side: History['done']): History['done'] => {
    let from = 0
    for (; bytes > most && from < side.length - 1; from++) bytes -= bytesOf(side[from] as Edits | Opening)
    return from === 0 ? side : side.slice(from)
  }
  return { done: withoutFarthest(done), undone: withoutFarthest(undone) }
}

function bytesOf(entry: Edits | Opening): number {
  // Changed attributes usually differ in one column, and share most texts with the current ones.
  if (entry.kind === 'edits') {
    return ENTRY_BYTES + entry.steps.bytes + 8 * (entry.attributes?.columns[0]?.values.length ?? 0)
  }
  const { circles, attributes = NO_ATTRIBUTES } = entry.scene
  return ENTRY_BYTES + circles.byteLength + entry.ids.byteLength + bytesOfAttributes(attributes)
}

/**
 * Maps former ids to ids after the circles are opened again: the k-th circle gets k. Removed circles that undo may
 * restore get negative ids, which no circle has.
 */
export function idsOnceOpened(ids: Int32Array, nextAbsent: () => number): (id: number) => number {
  const absent = new Map<number, number>()
  return (id) => {
    const k = placeOf(ids, id)
    if (k !== undefined) return k
    const other = absent.get(id) ?? nextAbsent()
    absent.set(id, other)
    return other
  }
}

/** The index of a number in an ascending list. */
function placeOf(ids: Int32Array, id: number): number | undefined {
  let [from, to] = [0, ids.length]
  while (from < to) {
    const middle = (from + to) >> 1
    if ((ids[middle] as number) < id) from = middle + 1
    else to = middle
  }
  return ids[from] === id ? from : undefined
}
