// SPDX-License-Identifier: GPL-3.0-or-later
// The goals of a check: each number that it asks for, as it is now, in words and at the circle that has it.
import type { Check } from '../lib/check-types.ts'
import type { Facts } from '../view/protocol.ts'
import type { Ring } from '../view/rings.ts'
import { short } from '../view/short.ts'
import { holds, numbersIn } from './check.ts'
import type { CellGoalName, DiagramGoalName, Goal } from './goal-types.ts'

const DIGITS = 3
const OF_CELLS = [
  'area',
  'neighbors',
  'edges',
  'bounded',
  'hidden',
  'neighbor',
  'r',
  'x',
  'y',
] as const satisfies readonly CellGoalName[]
const OF_DIAGRAM = ['circles', 'hidden', 'vertices', 'edges'] as const satisfies readonly DiagramGoalName[]
/** The numbers that a reader sets. Exact ones are told only while they are not met. */
const GIVEN: readonly string[] = ['r', 'x', 'y']

/** Returns the goals of a check. Conditions inside `not` do not count as goals. */
export function goalsOf(check: Check, facts: Facts): Goal[] {
  if ('all' in check) return check.all.flatMap((part) => goalsOf(part, facts))
  if ('any' in check) return check.any.flatMap((part) => goalsOf(part, facts))
  if ('not' in check) return []
  if (!('cell' in check)) {
    return OF_DIAGRAM.flatMap((name) => {
      const goal = check[name]
      return goal === undefined
        ? []
        : [{ name, cell: undefined, value: facts[name], goal, isMet: holds({ [name]: goal }, facts) }]
    })
  }
  const { cell } = check
  const now = facts.cells.get(cell)
  if (now === undefined) return []
  return OF_CELLS.flatMap((name): Goal[] => {
    const goal = check[name]
    if (goal === undefined) return []
    const isMet = holds({ cell, [name]: goal }, facts)
    if (name === 'neighbor') return [{ name, cell, value: isMet, goal: true, isMet }]
    return [{ name, cell, value: name === 'neighbors' ? now.neighbors.length : now[name], goal, isMet }]
  })
}

/** Describes goals and their values in one sentence. Goals with the same condition share a clause. */
export function goalSentence(goals: readonly Goal[], words: GoalWords): string {
  const values = new Map<string, { readonly goal: Goal; readonly now: string[] }>()
  for (const goal of goals) {
    if (!isMentioned(goal)) continue
    const key = JSON.stringify([goal.name, goal.cell === undefined, goal.goal])
    const same = values.get(key) ?? { goal, now: [] }
    values.set(key, same)
    same.now.push(valueText(goal.value, words))
  }
  const text = Array.from(values.values(), ({ goal, now }) => {
    const { name, cell } = goal
    const isHiddenCircles = cell === undefined && name === 'hidden'
    return words.is(isHiddenCircles ? words.hiddenCircles : words.names[name], now.join(', '), goalText(goal, words))
  }).join('; ')
  return text.charAt(0).toUpperCase() + text.slice(1)
}

/** The rings around the circles that a check names, with their numbers and values. */
export function goalRings(check: Check, goals: readonly Goal[], isMet: boolean, words: GoalWords): Ring[] {
  return [...new Set(numbersIn(check))].map((id) => {
    const own = goals.filter(({ cell }) => cell === id)
    const values = own
      .filter((goal) => isMentioned(goal) && typeof goal.value === 'number')
      .map(({ name, value }) => words.counted(name, valueText(value, words)))
    return {
      id,
      number: String(id),
      text: values.join(', '),
      isClosed: isMet || (own.length > 0 && own.every(({ isMet }) => isMet)),
    }
  })
}

function isMentioned({ name, goal, isMet }: Goal): boolean {
  return typeof goal !== 'number' || !GIVEN.includes(name) || !isMet
}

function goalText({ goal }: Goal, words: GoalWords): string {
  if (typeof goal !== 'object') return valueText(goal, words)
  const { min, max } = goal
  if (min !== undefined && max !== undefined) return words.between(valueText(min, words), valueText(max, words))
  return min === undefined ? words.atMost(valueText(max as number, words)) : words.atLeast(valueText(min, words))
}

function valueText(value: number | boolean, { yes, no }: GoalWords): string {
  if (typeof value === 'boolean') return value ? yes : no
  return Number.isFinite(value) ? short(value, DIGITS) : '∞'
}

/** The words for goals. */
export const ENGLISH_GOALS = {
  /** The names of goals, as headings of their values. */
  names: {
    area: 'area',
    neighbors: 'neighbors',
    edges: 'edges',
    bounded: 'cell is bounded',
    hidden: 'hidden',
    neighbor: 'cells share an edge',
    r: 'radius',
    x: 'x',
    y: 'y',
    circles: 'circles',
    vertices: 'vertices',
  } satisfies Record<Goal['name'], string>,
  hiddenCircles: 'hidden circles',
  /** A value with its unit, such as `7 edges`. */
  counted: (name: Goal['name'], value: string): string => {
    if (name === 'edges' || name === 'neighbors') return `${value} ${value === '1' ? name.slice(0, -1) : name}`
    return `${ENGLISH_GOALS.names[name]} ${value}`
  },
  yes: 'yes',
  no: 'no',
  is: (name: string, now: string, goal: string) => `${name}: now ${now}, goal ${goal}`,
  atLeast: (least: string) => `at least ${least}`,
  atMost: (most: string) => `at most ${most}`,
  between: (least: string, most: string) => `${least} to ${most}`,
}

export type GoalWords = typeof ENGLISH_GOALS
