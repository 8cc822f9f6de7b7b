// SPDX-License-Identifier: GPL-3.0-or-later
// The conditions of a question in the form of the page, converted to a check and a sentence.
import type { CellCheck, Check, DiagramCheck, NumberCondition } from '../../lib/check-types.ts'

type CellName = Exclude<keyof CellCheck, 'cell'>

/** A quantity that a condition is about. */
export type Kind =
  | { readonly key: string; readonly of: 'cell'; readonly name: CellName; readonly label: string; readonly type: Type }
  | {
      readonly key: string
      readonly of: 'diagram'
      readonly name: keyof DiagramCheck
      readonly label: string
      readonly type: 'count'
    }
/** Counts can be compared exactly; measures are numbers that no reader would match exactly. */
type Type = 'count' | 'measure' | 'flag' | 'circle'

const cell = (name: CellName, label: string, type: Type): Kind => ({
  key: `cell.${name}`,
  of: 'cell',
  name,
  label,
  type,
})
const diagram = (name: keyof DiagramCheck, label: string): Kind => ({
  key: name,
  of: 'diagram',
  name,
  label,
  type: 'count',
})

export const KINDS: readonly Kind[] = [
  cell('edges', 'edges of the cell', 'count'),
  cell('neighbors', 'number of neighbors', 'count'),
  cell('neighbor', 'one of the neighbors', 'circle'),
  cell('area', 'area of the cell', 'measure'),
  cell('bounded', 'cell is bounded', 'flag'),
  cell('hidden', 'inside another circle', 'flag'),
  cell('x', 'x of the center', 'measure'),
  cell('y', 'y of the center', 'measure'),
  cell('r', 'radius', 'measure'),
  diagram('circles', 'number of circles'),
  diagram('hidden', 'number of hidden circles'),
  diagram('vertices', 'number of vertices'),
  diagram('edges', 'number of edges'),
]

/** The comparison operators. */
const COMPARISONS = ['is', 'min', 'max', 'between'] as const
export type Comparison = (typeof COMPARISONS)[number]

export interface Condition {
  /** The key of a kind. */
  readonly kind: string
  /** The number of the circle, which stays the same when undo brings the circle back. */
  readonly circle: number
  readonly comparison: Comparison
  readonly value: number
  /** The upper end of `between`. */
  readonly most: number
  readonly flag: boolean
  /** The number of the neighbor. */
  readonly other: number
}

export function kindOf({ kind }: Pick<Condition, 'kind'>): Kind {
  return KINDS.find(({ key }) => key === kind) as Kind
}

/** The comparisons that make sense for a kind. */
export function comparisonsOf({ type }: Kind): readonly Comparison[] {
  return type === 'measure' ? COMPARISONS.filter((name) => name !== 'is') : COMPARISONS
}

/** The check that conditions, and maybe a check of another form, make; `undefined` if there are none. */
export function checkOf(conditions: readonly Condition[], isAny: boolean, ownCheck?: Check): Check | undefined {
  const parts = [...(ownCheck === undefined ? [] : [ownCheck]), ...conditions.map(partOf)]
  if (parts.length <= 1) return parts[0]
  return isAny ? { any: parts } : { all: parts }
}

function partOf(condition: Condition): Check {
  const kind = kindOf(condition)
  const { circle, flag, other } = condition
  if (kind.of === 'diagram') return { [kind.name]: numberOf(condition) }
  const value = kind.type === 'flag' ? flag : kind.type === 'circle' ? other : numberOf(condition)
  return { cell: circle, [kind.name]: value }
}

function numberOf({ comparison, value, most }: Condition): NumberCondition {
  switch (comparison) {
    case 'is':
      return value
    case 'min':
      return { min: value }
    case 'max':
      return { max: value }
    case 'between':
      return { min: Math.min(value, most), max: Math.max(value, most) }
  }
}

/** Converts a check to conditions, and whether a single one suffices; `undefined` if the form cannot express the check. */
export function conditionsOf(check: Check): { conditions: Condition[]; isAny: boolean } | undefined {
  const isAny = 'any' in check
  const parts = 'any' in check ? check.any : 'all' in check ? check.all : [check]
  const conditions = parts.map(conditionsOfPart)
  // Conditions within a part are always joined by `all`.
  if (conditions.includes(undefined) || (isAny && conditions.some((list) => list?.length !== 1))) return undefined
  return { conditions: conditions.flatMap((list) => list as Condition[]), isAny }
}

function conditionsOfPart(part: Check): Condition[] | undefined {
  if ('any' in part || 'all' in part || 'not' in part) return undefined
  const of = 'cell' in part ? 'cell' : 'diagram'
  const circle = 'cell' in part ? part.cell : 0
  const values = Object.entries(part).filter(([name, value]) => name !== 'cell' && value !== undefined)
  const conditions = values.map(([name, value]): Condition => {
    const { key, type } = KINDS.find((kind) => kind.of === of && kind.name === name) as Kind
    const condition = { ...newCondition(circle), kind: key }
    if (type === 'flag') return { ...condition, flag: value as boolean }
    if (type === 'circle') return { ...condition, other: value as number }
    if (typeof value === 'number') return { ...condition, comparison: 'is', value, most: value }
    const { min, max } = value as { min?: number; max?: number }
    const comparison = min === undefined ? 'max' : max === undefined ? 'min' : 'between'
    return { ...condition, comparison, value: min ?? (max as number), most: max ?? (min as number) }
  })
  return conditions
}

export function newCondition(circle: number): Condition {
  return { kind: 'cell.edges', circle, comparison: 'is', value: 3, most: 5, flag: true, other: 0 }
}

/**
 * A question that asks for the conditions, which a teacher may put into better words. On paper nothing moves, so readers
 * draw.
 */
export function sentenceOf(conditions: readonly Condition[], isAny: boolean, lang: string, isOnPaper = false): string {
  const isGerman = lang === 'de'
  if (conditions.length === 0) return ''
  const parts = conditions.map(isGerman ? german : english)
  const and = isGerman ? [' und ', ' oder '] : [' and ', ' or ']
  const all = parts.join(isAny ? and[1] : and[0])
  if (isOnPaper)
    return isGerman
      ? `Zeichne die Kreise dann noch einmal, und zwar so, dass ${all}.`
      : `Then draw the circles again, so that ${all}.`
  return isGerman ? `Bewege die Kreise, bis ${all}.` : `Move the circles until ${all}.`
}

function english(condition: Condition): string {
  const kind = kindOf(condition)
  const { circle, flag, other } = condition
  const number = numberInWords(condition, ['', 'at least ', 'at most ', ' to '])
  const many = (one: string, several = `${one}s`) => `${number} ${number === '1' ? one : several}`
  switch (kind.key) {
    case 'cell.edges':
      return `the cell of circle ${circle} has ${many('edge')}`
    case 'cell.neighbors':
      return `circle ${circle} has ${many('neighbor')}`
    case 'cell.neighbor':
      return `the cells of circles ${circle} and ${other} share an edge`
    case 'cell.area':
      return `the area of the cell of circle ${circle} is ${number}`
    case 'cell.bounded':
      return flag ? `the cell of circle ${circle} is bounded` : `the cell of circle ${circle} goes to infinity`
    case 'cell.hidden':
      return flag ? `circle ${circle} lies inside another circle` : `circle ${circle} lies inside no other circle`
    case 'cell.r':
      return `the radius of circle ${circle} is ${number}`
    case 'cell.x':
    case 'cell.y':
      return `${kind.name} of circle ${circle} is ${number}`
    case 'hidden':
      return `${many('circle')} ${number === '1' ? 'lies' : 'lie'} inside others`
    case 'circles':
      return number === '1' ? 'there is 1 circle' : `there are ${number} circles`
    default:
      return `the diagram has ${many(kind.name === 'vertices' ? 'vertex' : 'edge', kind.name)}`
  }
}

function german(condition: Condition): string {
  const kind = kindOf(condition)
  const { circle, flag, other } = condition
  const number = numberInWords(condition, ['', 'mindestens ', 'höchstens ', ' bis '])
  const many = (one: string, several: string) => `${number} ${number === '1' ? one : several}`
  switch (kind.key) {
    case 'cell.edges':
      return `die Zelle von Kreis ${circle} ${many('Kante', 'Kanten')} hat`
    case 'cell.neighbors':
      return `Kreis ${circle} ${many('Nachbarn', 'Nachbarn')} hat`
    case 'cell.neighbor':
      return `die Zellen der Kreise ${circle} und ${other} eine gemeinsame Kante haben`
    case 'cell.area':
      return `die Fläche der Zelle von Kreis ${circle} ${number} ist`
    case 'cell.bounded':
      return `die Zelle von Kreis ${circle} ${flag ? 'beschränkt ist' : 'bis ins Unendliche reicht'}`
    case 'cell.hidden':
      return `Kreis ${circle} in ${flag ? 'einem' : 'keinem'} anderen Kreis liegt`
    case 'cell.r':
      return `der Radius von Kreis ${circle} ${number} ist`
    case 'cell.x':
    case 'cell.y':
      return `${kind.name} von Kreis ${circle} ${number} ist`
    case 'hidden':
      return `${many('Kreis', 'Kreise')} in anderen ${number === '1' ? 'liegt' : 'liegen'}`
    case 'circles':
      return `es ${many('Kreis', 'Kreise')} gibt`
    default:
      return `das Diagramm ${kind.name === 'vertices' ? many('Ecke', 'Ecken') : many('Kante', 'Kanten')} hat`
  }
}

function numberInWords({ comparison, value, most }: Condition, words: readonly string[]): string {
  const [least, largest] = [Math.min(value, most), Math.max(value, most)]
  if (comparison === 'between') return `${least}${words[3]}${largest}`
  return `${words[COMPARISONS.indexOf(comparison)]}${value}`
}
