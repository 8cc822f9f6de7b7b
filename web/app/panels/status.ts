// SPDX-License-Identifier: GPL-3.0-or-later
import type { State } from '../../editing/state.ts'
import type { Store } from '../../editing/store.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import { byId } from './by-id.ts'

/** How much there is and how long it took to compute; and what was refused. */
export function mountStatus(store: Store<State>): void {
  const status = byId('status', HTMLParagraphElement)
  const problem = byId('problem', HTMLParagraphElement)

  const hint = byId('hint', HTMLParagraphElement)
  let edited: State['edited']
  status.replaceChildren(...statusParts(edited))

  store.subscribe((state) => {
    // Whoever has done something knows.
    hint.hidden =
      state.edited === undefined || state.history.done.length > 0 || state.selection.length > 0 || state.problem !== ''
    // It is read out each time.
    if (state.edited !== edited) status.replaceChildren(...statusParts(state.edited))
    edited = state.edited
    problem.hidden = state.problem === ''
    if (problem.textContent !== state.problem) problem.textContent = state.problem
  })
}

function statusParts(edited: State['edited']): (string | Node)[] {
  if (edited === undefined) return ['Loading …']
  const { counts, seconds } = edited
  const parts = [
    count(counts.circles, 'circle'),
    count(counts.vertices, 'vertex', 'vertices'),
    count(counts.edges, 'edge'),
    ...(counts.hidden > 0 ? [[bold(counts.hidden), ' hidden']] : []),
    duration(seconds),
  ]
  // Each part keeps its direction where that of the page is another.
  return parts.flatMap((part, i) => (i === 0 ? [isolated(part)] : [' · ', isolated(part)]))
}

function isolated(part: (string | Node)[]): Node {
  const element = document.createElement('bdi')
  element.dir = 'ltr'
  element.append(...part)
  return element
}

function count(value: number, one: string, many = `${one}s`): (string | Node)[] {
  return [bold(value), ` ${value === 1 ? one : many}`]
}

function bold(value: number | string): Node {
  const element = document.createElement('b')
  element.textContent = typeof value === 'number' ? wholeNumber(value) : value
  return element
}

function duration(seconds: number): (string | Node)[] {
  if (seconds >= 1) return [bold(seconds.toFixed(1)), ' s']
  return [bold((1000 * seconds).toFixed(seconds < 0.01 ? 1 : 0)), ' ms']
}
