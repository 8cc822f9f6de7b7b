// SPDX-License-Identifier: GPL-3.0-or-later
import type { Float64s } from '../lib/index.ts'
import type { Step } from '../view/circle-table.ts'
import type { Domain } from '../view/domain.ts'
import { type Attributes, bytesOfAttributes, NO_ATTRIBUTES } from './attributes.ts'
import { PackedSteps } from './packed-steps.ts'

/** Circles that are opened at once. */
export interface Scene {
  readonly circles: Float64s
  /** The name of a data set, or empty. */
  readonly dataSet: string
  /** Whether the circles are no longer those of the data set. */
  readonly isEdited: boolean
  /** What each circle is called; empty: nothing. */
  readonly names?: readonly string[] | undefined
  /** What else a file says of the circles. */
  readonly attributes?: Attributes | undefined
  /** What cells are cut to, and their areas. `undefined`: neither. */
  readonly domain?: Domain | undefined
}

/** What goes back to before one gesture. */
interface Edits {
  readonly kind: 'edits'
  readonly steps: PackedSteps
  /** The domain before; `undefined`: it stays. */
  readonly domain?: Domain | undefined
  /** The attributes before, likewise. */
  readonly attributes?: Attributes | undefined
  readonly gesture: number
}

/** What goes back to other circles. */
export interface Opening {
  readonly kind: 'opening'
  readonly scene: Scene
  /** The ids that the circles had, in ascending order. */
  readonly ids: Int32Array
  /** The numbers of circles by their ids: those of attributes and areas in older entries, too. */
  readonly numbering: Numbering
}

/** Which number a circle has. It keeps its number when it comes back by undo, with another id. */
export interface Numbering {
  /** Where it is not `shift` more than the id. */
  readonly numbers: ReadonlyMap<number, number>
  readonly shift: number
  /** All numbers are below. */
  readonly end: number
}

/** What was done, and what was undone; the newest last. */
export interface History {
  readonly done: readonly (Edits | Opening)[]
  readonly undone: readonly (Edits | Opening)[]
}

export const EMPTY_HISTORY: History = { done: [], undone: [] }

/** Adds what goes back to before an edit. Edits of one gesture, a drag for instance, become one entry. */
export function record(
  { done }: History,
  steps: readonly Step[],
  gesture: number,
  { domain, attributes }: Partial<Pick<Edits, 'domain' | 'attributes'>> = {},
): History {
  const last = done.at(-1)
  if (last?.kind !== 'edits' || last.gesture !== gesture) {
    const entry: Edits = { kind: 'edits', steps: PackedSteps.of(steps), gesture, domain, attributes }
    return { done: [...done, entry], undone: [] }
  }
  // What the gesture has replaced or brought goes back to where it was at first.
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

/** The history where circles have other ids than they had. What lies behind an opening is about other circles. */
export function renamed({ done, undone }: History, idOf: (id: number) => number): History {
  const rename = (entries: History['done']): History['done'] => {
    const from = entries.findLastIndex(({ kind }) => kind === 'opening') + 1
    return [...entries.slice(0, from), ...(entries.slice(from) as Edits[]).map(renameEdits)]
  }
  const renameEdits = (entry: Edits): Edits => ({ ...entry, steps: entry.steps.renamed(idOf) })
  return { done: rename(done), undone: rename(undone) }
}

/** The memory that a history may take: 46 moves of 100,000 circles. */
export const MOST_BYTES = 2 ** 27
/** What an entry takes beside its numbers. */
const ENTRY_BYTES = 200

/**
 * A history that takes no more than so many bytes. What goes is farthest from the circles as they are: the oldest of what was
 * done, or of what was undone. The last step of each side stays.
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
  // Of other attributes, one column is another one, and its texts are mostly the same.
  if (entry.kind === 'edits') {
    return ENTRY_BYTES + entry.steps.bytes + 8 * (entry.attributes?.columns[0]?.values.length ?? 0)
  }
  const { circles, names = [], attributes = NO_ATTRIBUTES } = entry.scene
  const texts = names.reduce((sum, name) => sum + 2 * name.length + 16, 0)
  return ENTRY_BYTES + circles.byteLength + entry.ids.byteLength + texts + bytesOfAttributes(attributes)
}

/**
 * The ids of circles once they are opened: the k-th one gets k. Those of circles that are not there any more, but may come
 * back, get ids that no circle has: below zero, each another one.
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

/** Where a number is among ascending ones. */
function placeOf(ids: Int32Array, id: number): number | undefined {
  let [from, to] = [0, ids.length]
  while (from < to) {
    const middle = (from + to) >> 1
    if ((ids[middle] as number) < id) from = middle + 1
    else to = middle
  }
  return ids[from] === id ? from : undefined
}
