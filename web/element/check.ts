// SPDX-License-Identifier: GPL-3.0-or-later
import { isRecord } from '../lib/base/check.ts'
import type { CellCheck, Check, NumberCondition } from '../lib/check-types.ts'
import type { CellFacts, Facts } from '../view/protocol.ts'
import { type ElementRefusals, refuse } from './refusals.ts'

const DEEPEST = 8
const MOST_PARTS = 200
const CELL_NUMBERS = ['edges', 'neighbors', 'area', 'x', 'y', 'r'] as const
const CELL_FLAGS = ['bounded', 'hidden'] as const
const CELL_NAMES = [...CELL_NUMBERS, 'neighbor', ...CELL_FLAGS]
const DIAGRAM_NUMBERS = ['circles', 'hidden', 'vertices', 'edges'] as const

/**
 * Parses a check in JSON.
 * @throws Refusal that names the problem
 */
export function parseCheck(text: string): Check {
  let given: unknown
  try {
    given = JSON.parse(text)
  } catch {
    refuseCheck((words) => words.checkNotJson)
  }
  checkCheck(given, DEEPEST, { left: MOST_PARTS })
  return given as Check
}

/** Translates a check to other ids of circles. */
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

/**
 * Checks that all circles of a check exist or have existed. `count` is the number of ids ever assigned.
 * @throws Refusal
 */
export function checkCircles(check: Check, count: number): void {
  const missing = numbersIn(check).find((number) => number >= count)
  if (missing !== undefined) refuseCheck((words) => words.checkMissing(missing, count))
}

/** All circles that a check names. */
export function numbersIn(check: Check): number[] {
  if ('all' in check) return check.all.flatMap(numbersIn)
  if ('any' in check) return check.any.flatMap(numbersIn)
  if ('not' in check) return numbersIn(check.not)
  if (!('cell' in check)) return []
  return check.neighbor === undefined ? [check.cell] : [check.cell, check.neighbor]
}

/** The circles whose cells a check is about. */
export function idsOf(check: Check): number[] {
  if ('all' in check) return check.all.flatMap(idsOf)
  if ('any' in check) return check.any.flatMap(idsOf)
  if ('not' in check) return idsOf(check.not)
  return 'cell' in check ? [check.cell] : []
}

/** Whether the facts meet the check. */
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
  if (depth === 0 || parts.left < 0) refuseCheck((words) => words.checkParts)
  if (!isRecord(given)) refuseCheck((words) => words.checkObject)
  const names = Object.keys(given)
  const [name] = names
  if (name === undefined) refuseCheck((words) => words.checkNothing)
  if (name === 'all' || name === 'any' || name === 'not') {
    if (names.length > 1) refuseCheck((words) => words.checkAlone(name))
    const inner = name === 'not' ? [given.not] : given[name]
    if (!Array.isArray(inner) || inner.length === 0) refuseCheck((words) => words.checkList(name))
    for (const part of inner) checkCheck(part, depth - 1, parts)
    return
  }
  const isOfCell = 'cell' in given
  if (isOfCell && names.length === 1) refuseCheck((words) => words.checkNoCell)
  for (const [name, value] of Object.entries(given)) {
    if (isOfCell && (name === 'cell' || name === 'neighbor')) {
      if (!(Number.isInteger(value) && (value as number) >= 0)) refuseCheck((words) => words.checkCircle(name))
    } else if (isOfCell && isOneOf(CELL_FLAGS, name)) {
      if (typeof value !== 'boolean') refuseCheck((words) => words.checkFlag(name))
    } else if (isOneOf(isOfCell ? CELL_NUMBERS : DIAGRAM_NUMBERS, name)) {
      if (!isCondition(value)) refuseCheck((words) => words.checkCondition(name))
    } else {
      refuseCheck((words) => words.checkName(isOfCell, name, isOfCell ? CELL_NAMES : DIAGRAM_NUMBERS))
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

function refuseCheck(reason: (words: ElementRefusals) => string): never {
  refuse((words) => words.check(reason(words)))
}
