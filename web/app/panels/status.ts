// SPDX-License-Identifier: GPL-3.0-or-later
import type { Remedy, State } from '../../editing/state.ts'
import type { Store } from '../../view/store.ts'
import type { View } from '../../view/view.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import { byId } from './by-id.ts'

/** The times of fewer circles say more about what else the machine does. */
const TIMED = 1000

/** The status line: counts, computing time, and problems. */
export function mountStatus(store: Store<State>, view: View): void {
  const status = byId('status', HTMLParagraphElement)
  const problem = byId('problem', HTMLParagraphElement)

  let edited: State['edited']
  let { circles } = view
  let shown = ''
  let offered: Remedy | undefined

  store.subscribe((state) => {
    if (state.edited !== edited && state.edited !== undefined) {
      status.replaceChildren(statusOf(state.edited, state.scene?.degrees !== undefined))
      edited = state.edited
      // Edits are announced in other words.
      if (view.circles !== circles) store.update((state) => ({ ...state, said: { text: status.textContent } }))
      circles = view.circles
    }
    problem.hidden = state.problem === ''
    const remedy = state.problem !== '' && state.remedy?.problem === state.problem ? state.remedy : undefined
    if (state.problem === shown && remedy === offered) return
    shown = state.problem
    offered = remedy
    problem.replaceChildren(state.problem, ...(remedy === undefined ? [] : [' ', buttonOf(remedy)]))
  })
}

function buttonOf({ label, act }: Remedy): HTMLButtonElement {
  const button = document.createElement('button')
  button.type = 'button'
  button.textContent = label
  button.addEventListener('click', () => act())
  return button
}

/**
 * A part of the status line. Phones hide minor parts; small phones also hide second ones, as do lines with rare ones.
 */
type Part = readonly [content: readonly (string | Node)[], rank?: 'minor' | 'second' | 'rare']

function statusOf({ counts, fitted, seconds }: NonNullable<State['edited']>, areDegrees: boolean): Node {
  const proven = document.createElement('span')
  proven.className = 'good'
  proven.title = 'A judge has proven this diagram with exact signs, independently of how it was made.'
  proven.textContent = areDegrees ? '✓ proven for a plane' : '✓ proven'
  const parts: Part[] = [
    [count(counts.circles, 'circle')],
    [count(counts.vertices, 'vertex', 'vertices'), 'second'],
    [count(counts.edges, 'edge'), 'minor'],
    ...(counts.hidden > 0 ? [[[bold(counts.hidden), ' hidden'], 'rare'] as Part] : []),
    ...(fitted === undefined ? [] : [[['areas within ', bold(fitted.error.toExponential(0))], 'second'] as Part]),
    [[proven]],
    ...(counts.circles < TIMED ? [] : [[['computed in ', ...duration(seconds)], 'minor'] as Part]),
  ]
  const line = document.createElement('span')
  for (const [k, [content, rank]] of parts.entries()) {
    // Isolates the text direction of each part.
    const part = document.createElement('bdi')
    part.dir = 'ltr'
    part.append(...content)
    const item = document.createElement('span')
    if (rank !== undefined) item.className = rank
    if (k > 0) item.append(' · ')
    item.append(part)
    line.append(item)
  }
  return line
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
  return [bold((1000 * seconds).toFixed(0)), ' ms']
}
