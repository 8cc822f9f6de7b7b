// SPDX-License-Identifier: GPL-3.0-or-later
import type { Edit, Float64s } from '../lib/index.ts'
import type { KeptIds } from '../view/circle-table.ts'
import type { Domain } from '../view/domain.ts'
import { type Attributes, bytesOfAttributes, NO_ATTRIBUTES } from './attributes.ts'
import { PackedSteps } from './packed-steps.ts'

/** A file whose circles have longitudes and latitudes as centers. */
export interface Degrees {
  readonly file: string
  /** The unit of the radii: by the name of their column, or else by their size. */
  readonly unit: 'km' | 'm'
}

/** The names of x, y and r in a file. */
export type Headings = readonly [x: string, y: string, r: string]

/** A set of circles that are opened together. */
export interface CircleSet {
  readonly circles: Float64s
  /** The ids of the circles. Default: circle i gets id i. */
  readonly kept?: KeptIds | undefined
  /** The name of a data set, or an empty text. */
  readonly dataSet: string
  /** Whether the circles differ from those of the data set. */
  readonly isEdited: boolean
  /** The names and other attributes, by id. */
  readonly attributes?: Attributes | undefined
  /** The clipping region and the areas in the order of the circles, if any. */
  readonly domain?: Domain | undefined
  /** The colors of the circles, if they are not to be chosen anew (`LinkState.colors`). */
  readonly colors?: string | undefined
  /** Set if the centers are longitudes and latitudes. */
  readonly degrees?: Degrees | undefined
  /** The name of the file, for saving. */
  readonly file?: string | undefined
  /** The file's names of x, y and r, for saving. Default: `x`, `y` and `r`. */
  readonly headings?: Headings | undefined
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
  steps: readonly Edit[],
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
  const { circles, kept, attributes = NO_ATTRIBUTES } = entry.scene
  return ENTRY_BYTES + circles.byteLength + (kept?.ids.byteLength ?? 0) + bytesOfAttributes(attributes)
}
