// SPDX-License-Identifier: GPL-3.0-or-later
import type { Step } from './circle-table.ts'

/** What goes back to before one gesture. */
interface Entry {
  readonly steps: readonly Step[]
  readonly gesture: number
}

/** What was done, and what was undone; the newest last. */
export interface History {
  readonly done: readonly Entry[]
  readonly undone: readonly Entry[]
}

export const EMPTY_HISTORY: History = { done: [], undone: [] }

/** Adds what goes back to before an edit. Edits of one gesture, a drag for instance, become one entry. */
export function record({ done }: History, steps: readonly Step[], gesture: number): History {
  const last = done.at(-1)
  if (last?.gesture !== gesture) return { done: [...done, { steps, gesture }], undone: [] }
  // What the gesture has replaced or brought goes back to where it was at first.
  const known = new Set(last.steps.flatMap((step) => (step.kind === 'insert' ? [] : [step.id])))
  const more = steps.filter((step) => step.kind !== 'replace' || !known.has(step.id))
  return { done: [...done.slice(0, -1), { steps: [...more, ...last.steps], gesture }], undone: [] }
}

/** The history where circles that came back have other ids than they had. */
export function renamed({ done, undone }: History, ids: ReadonlyMap<number, number>): History {
  if (ids.size === 0) return { done, undone }
  const idOf = (id: number) => ids.get(id) ?? id
  const rename = (entry: Entry): Entry => ({
    ...entry,
    steps: entry.steps.map((step) => {
      if (step.kind !== 'insert') return { ...step, id: idOf(step.id) }
      return step.formerId === undefined ? step : { ...step, formerId: idOf(step.formerId) }
    }),
  })
  return { done: done.map(rename), undone: undone.map(rename) }
}
