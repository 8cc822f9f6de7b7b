// SPDX-License-Identifier: GPL-3.0-or-later
// Says how far an exercise is: the numbers of its goal as they are now, below the figure, and at the circles they are of.
import { holds, idsOf } from '../element/check.ts'
import type { CircleVoronoiElement } from '../element/index.ts'
import type { Check, NumberCondition } from '../lib/check-types.ts'
import type { CircleVoronoi } from '../lib/index.ts'
import { loadLibrary } from '../lib/wasm/loader.ts'
import { factsOf } from '../view/painter/facts.ts'
import type { Facts } from '../view/protocol.ts'
import { short } from '../view/short.ts'
import { numberCircles } from './numbers.ts'

const DIGITS = 3
/** The numbers that a reader is told, of circles and of the whole diagram. */
const OF_CELLS = { area: 'area', neighbors: 'neighbors', edges: 'edges', r: 'radius', x: 'x', y: 'y' } as const
const OF_DIAGRAM = { circles: 'circles', hidden: 'hidden circles', vertices: 'vertices', edges: 'edges' } as const
/** The numbers that a reader sets. Exact ones are told only while they are not met. */
const GIVEN: readonly string[] = ['r', 'x', 'y']

/** One number of a goal. */
interface Goal {
  readonly name: string
  readonly condition: NumberCondition
  readonly value: number
  /** The circle whose number it is, if it is of one. */
  readonly id: number | undefined
  readonly isTold: boolean
}

/** The numbers of a check, as they are now. */
export function goalsOf(check: Check, facts: Facts): readonly Goal[] {
  if ('all' in check) return check.all.flatMap((part) => goalsOf(part, facts))
  if ('any' in check) return check.any.flatMap((part) => goalsOf(part, facts))
  if ('not' in check) return []
  if (!('cell' in check)) {
    return Object.entries(OF_DIAGRAM).flatMap(([key, name]) => {
      const condition = check[key as keyof typeof OF_DIAGRAM]
      const value = facts[key as keyof typeof OF_DIAGRAM]
      return condition === undefined ? [] : [{ name, condition, value, id: undefined, isTold: true }]
    })
  }
  const { cell: id } = check
  const cell = facts.cells.get(id)
  return Object.entries(OF_CELLS).flatMap(([name, text]) => {
    const key = name as keyof typeof OF_CELLS
    const condition = check[key]
    if (condition === undefined || cell === undefined) return []
    const value = key === 'neighbors' ? cell.neighbors.length : cell[key]
    const isTold =
      typeof condition !== 'number' || !GIVEN.includes(key) || !holds({ cell: id, [key]: condition } as Check, facts)
    return [{ name: text, condition, value, id, isTold }]
  })
}

/** A sentence about the goals: equal ones together. */
export function goalSentence(goals: readonly Goal[]): string {
  const values = new Map<string, string[]>()
  for (const { name, condition, value, isTold } of goals) {
    if (!isTold) continue
    const key = `${name} now # (goal: ${goalText(condition)})`
    values.set(key, [...(values.get(key) ?? []), valueText(value)])
  }
  const text = Array.from(values, ([key, list]) => key.replace('#', list.join(', '))).join('; ')
  return text.charAt(0).toUpperCase() + text.slice(1)
}

function goalText(condition: NumberCondition): string {
  if (typeof condition === 'number') return valueText(condition)
  const { min, max } = condition
  if (min !== undefined && max !== undefined) return `${valueText(min)} to ${valueText(max)}`
  return min === undefined ? `at most ${valueText(max as number)}` : `at least ${valueText(min)}`
}

function valueText(value: number): string {
  return Number.isFinite(value) ? short(value, DIGITS) : '∞'
}

/** Follows the goals of all exercises of a page. */
export async function tellGoals(page: ParentNode): Promise<void> {
  let library: Promise<CircleVoronoi> | undefined
  for (const section of page.querySelectorAll<HTMLElement>('.try')) {
    const figure = section.querySelector('circle-voronoi') as CircleVoronoiElement
    const place = section.querySelector('.now') as HTMLElement
    const check: Check = JSON.parse(figure.getAttribute('check') as string)
    void figure.ready.then(async () => {
      library ??= loadLibrary()
      const { edit } = await library
      let goals: readonly Goal[] = []
      const tell = () => {
        const { ids } = figure
        const editor = edit(figure.circles, { ids, nextId: ids.reduce((most, id) => Math.max(most, id + 1), 0) })
        const diagram = editor.snapshot()
        const { circles, hidden, vertices, edges } = diagram
        const counts = {
          circles: circles.length / 3,
          hidden: hidden.length / 2,
          vertices: vertices.length / 3,
          edges: edges.length / 4,
        }
        goals = goalsOf(check, factsOf({ diagram, limits: {} }, counts, idsOf(check)))
        editor.dispose()
        place.textContent = goalSentence(goals)
      }
      figure.addEventListener('circleschange', tell)
      tell()
      numberCircles(figure, (i) => {
        const goal = goals.find(({ id, isTold }) => isTold && id === figure.ids[i])
        return goal === undefined ? '' : valueText(goal.value)
      })
    })
  }
}
