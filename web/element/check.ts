// SPDX-License-Identifier: GPL-3.0-or-later
import type { CellFacts, Facts } from '../view/protocol.ts'
import type { CellCheck, Check, NumberCondition } from './check-types.ts'

const DEEPEST = 8
const MOST_PARTS = 200
const CELL_NUMBERS = ['edges', 'neighbors', 'area', 'x', 'y', 'r'] as const
const CELL_FLAGS = ['bounded', 'hidden'] as const
const DIAGRAM_NUMBERS = ['circles', 'hidden', 'vertices', 'edges'] as const

/**
 * The check that a text in JSON says.
 *
 * @throws Error with one sentence that says what is wrong with it
 */
export function parseCheck(text: string): Check {
  let given: unknown
  try {
    given = JSON.parse(text)
  } catch {
    refuse('it is no JSON')
  }
  checkCheck(given, DEEPEST, { left: MOST_PARTS })
  return given as Check
}

/** The same check, which calls circles otherwise. */
export function withIds(check: Check, idOf: (number: number) => number): Check {
  const partsWithIds = (parts: readonly Check[]) => parts.map((part) => withIds(part, idOf))
  if ('all' in check) return { all: partsWithIds(check.all) }
  if ('any' in check) return { any: partsWithIds(check.any) }
  if ('not' in check) return { not: withIds(check.not, idOf) }
  if (!('cell' in check)) return check
  return {
    ...check,
    cell: idOf(check.cell),
    ...(check.neighbor !== undefined && { neighbor: idOf(check.neighbor) }),
  }
}

/** The circles that a check is about. */
export function idsOf(check: Check): number[] {
  if ('all' in check) return check.all.flatMap(idsOf)
  if ('any' in check) return check.any.flatMap(idsOf)
  if ('not' in check) return idsOf(check.not)
  return 'cell' in check ? [check.cell] : []
}

/** Whether it is so. */
export function holds(check: Check, facts: Facts): boolean {
  if ('all' in check) return check.all.every((part) => holds(part, facts))
  if ('any' in check) return check.any.some((part) => holds(part, facts))
  if ('not' in check) return !holds(check.not, facts)
  if ('cell' in check) return holdsOfCell(check, facts.cells.get(check.cell))
  return DIAGRAM_NUMBERS.every((name) => isMet(check[name], facts[name]))
}

function holdsOfCell(check: CellCheck, cell: CellFacts | undefined): boolean {
  if (cell === undefined) return false
  return (
    CELL_FLAGS.every((name) => check[name] === undefined || check[name] === cell[name]) &&
    (check.neighbor === undefined || cell.neighbors.includes(check.neighbor)) &&
    CELL_NUMBERS.every((name) => isMet(check[name], name === 'neighbors' ? cell.neighbors.length : cell[name]))
  )
}

function isMet(condition: NumberCondition | undefined, value: number): boolean {
  if (condition === undefined) return true
  if (typeof condition === 'number') return value === condition
  const { min = Number.NEGATIVE_INFINITY, max = Number.POSITIVE_INFINITY } = condition
  return value >= min && value <= max
}

function checkCheck(given: unknown, depth: number, parts: { left: number }): void {
  parts.left -= 1
  if (depth === 0 || parts.left < 0) refuse('it has too many parts')
  if (!isRecord(given)) refuse('each part is an object')
  const names = Object.keys(given)
  const [name] = names
  if (name === undefined) refuse('a part says nothing')
  if (name === 'all' || name === 'any' || name === 'not') {
    if (names.length > 1) refuse(`${name} stands alone`)
    const inner = name === 'not' ? [given.not] : given[name]
    if (!Array.isArray(inner) || inner.length === 0) refuse(`${name} has a list`)
    for (const part of inner) checkCheck(part, depth - 1, parts)
    return
  }
  const isOfCell = 'cell' in given
  if (isOfCell && names.length === 1) refuse('it says nothing of the cell')
  for (const [name, value] of Object.entries(given)) {
    if (isOfCell && (name === 'cell' || name === 'neighbor')) {
      if (!(Number.isInteger(value) && (value as number) >= 0)) refuse(`${name} is the number of a circle`)
    } else if (isOfCell && isOneOf(CELL_FLAGS, name)) {
      if (typeof value !== 'boolean') refuse(`${name} is true or false`)
    } else if (isOneOf(isOfCell ? CELL_NUMBERS : DIAGRAM_NUMBERS, name)) {
      if (!isCondition(value)) refuse(`${name} is a number, or an object with min and max`)
    } else {
      refuse(`${isOfCell ? 'a cell' : 'a diagram'} has no ${name}`)
    }
  }
}

function isCondition(value: unknown): boolean {
  if (Number.isFinite(value)) return true
  if (!isRecord(value)) return false
  const bounds = Object.entries(value)
  return bounds.length > 0 && bounds.every(([name, bound]) => isOneOf(['min', 'max'], name) && Number.isFinite(bound))
}

function isOneOf(names: readonly string[], name: string): boolean {
  return names.includes(name)
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value)
}

function refuse(reason: string): never {
  throw new Error(`The check cannot be read: ${reason}.`)
}
