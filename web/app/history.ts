// SPDX-License-Identifier: GPL-3.0-or-later
import { type Edit, reverse } from './edits.ts'

/** A step back and forth: an edit, and the gesture that it belongs to. */
interface Step {
  readonly edit: Edit
  readonly gesture: number
}

/** What was done, and what was undone; the newest last. */
export interface History {
  readonly done: readonly Step[]
  readonly undone: readonly Step[]
}

export const EMPTY_HISTORY: History = { done: [], undone: [] }

const LONGEST_HISTORY = 500

/** Adds an edit. Successive edits of one gesture, a drag for instance, become one step. */
export function record({ done }: History, edit: Edit, gesture: number): History {
  const last = done.at(-1)
  if (last !== undefined && last.gesture === gesture) {
    const merged = mergeEdits(last.edit, edit)
    if (merged !== undefined) return { done: [...done.slice(0, -1), { edit: merged, gesture }], undone: [] }
  }
  return { done: [...done, { edit, gesture }].slice(-LONGEST_HISTORY), undone: [] }
}

/** The history after one step back, and the edit that goes back; nothing if there is no step. */
export function stepBack({ done, undone }: History): { history: History; edit: Edit } | undefined {
  const step = done.at(-1)
  if (step === undefined) return undefined
  return { history: { done: done.slice(0, -1), undone: [...undone, step] }, edit: reverse(step.edit) }
}

/** The history after one undone step is done again, and its edit; nothing if there is none. */
export function stepForth({ done, undone }: History): { history: History; edit: Edit } | undefined {
  const step = undone.at(-1)
  if (step === undefined) return undefined
  return { history: { done: [...done, step], undone: undone.slice(0, -1) }, edit: step.edit }
}

/** One edit that does both, where the second replaces just what the first put in. */
function mergeEdits(first: Edit, second: Edit): Edit | undefined {
  if (first.at !== second.at || first.inserted.length !== second.removed.length) return undefined
  return { at: first.at, removed: first.removed, inserted: second.inserted }
}
