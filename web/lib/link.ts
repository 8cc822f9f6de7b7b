// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The part after the `#` of a link to the page: circles or a data set, edits, and the view. It is compressed. Decoding
 * any text gives a `LinkState` or a `CircleVoronoiError`.
 *
 * @module circle-voronoi/link
 */
import { isRecord, refuseInput, shown } from './base/check.ts'
import { compressText, decompressText, storeText } from './base/compressed-text.ts'
import { COORDINATE_LIMIT, COORDINATE_LIMIT_TEXT } from './base/coordinate-limits.ts'
import { type CircleLike, type Circles, circleRadius, circleX, circleY, coordinatesOf } from './base/coordinates.ts'
import { CircleVoronoiError } from './base/errors.ts'
import type { Float64s } from './base/types.ts'
import { type Lattice, latticeNumbers } from './diagram/lattice.ts'
import type { LinkFrame } from './link-frame.ts'
import { plainRegion, type RegionShape, ringArraysOf } from './regions/region-shape.ts'
import type { Edit } from './wasm/editor.ts'

export type { CellCheck, Check, DiagramCheck, NumberCondition } from './check-types.ts'
export type { LinkFrame } from './link-frame.ts'

/**
 * The limits of links: letters, bytes of unpacked JSON, circles, edits, and values of layers.
 *
 * @category Links
 * @example
 * LINK_LIMITS.circles // 100000
 */
export const LINK_LIMITS = {
  letters: 4_194_304,
  bytes: 16_777_216,
  circles: 100_000,
  edits: 100_000,
  layerValues: 1000,
} as const

/**
 * The setting of a layer, or its settings.
 *
 * @category Links
 */
export type LayerValue =
  | boolean
  | number
  | string
  | null
  | readonly LayerValue[]
  | { readonly [name: string]: LayerValue }

/**
 * The part of the plane that a link shows.
 *
 * @category Links
 */
export interface LinkView {
  /** The center of the view. */
  readonly x: number
  readonly y: number
  /** The smallest visible width or height in units of the input, above 0. */
  readonly span: number
}

/**
 * The data of a file about its circles beyond x, y and r. Each list is empty or has an entry for each circle. Entries
 * are the texts of JSON values, at most 10,000 letters long.
 *
 * @category Links
 */
export interface LinkAttributes {
  /** The other columns or properties of each circle: a JSON object. */
  readonly properties: readonly string[]
  /** The id of each circle, or an empty text. */
  readonly ids: readonly string[]
  /** The height of each circle, or an empty text. */
  readonly heights: readonly string[]
  /** The members of a GeoJSON collection beside its features: a JSON object, or an empty text. */
  readonly collection: string
}

/**
 * The content of a link. Fields that are missing are left to the page that opens it.
 *
 * @category Links
 */
export interface LinkState extends LinkFrame {
  /** The circles: x, y and r of each. */
  readonly circles?: Float64s | undefined
  /**
   * The name of each circle in `circles`, at most 200 letters long. An empty text means that the circle has no name.
   */
  readonly names?: readonly string[] | undefined
  /** The data of a file about each circle in `circles`, as `CircleAttributes` of circle-voronoi/files. */
  readonly attributes?: LinkAttributes | undefined
  /** The names of x, y and r in the file that `circles` come from, at most 200 letters each. */
  readonly headings?: readonly [x: string, y: string, r: string] | undefined
  /** The name of a data set, instead of circles. */
  readonly dataSet?: string | undefined
  /**
   * The colors in which the playground shows the circles: a digit from 0 to 7 for each, by ascending id. Others are
   * chosen so that neighbors differ.
   */
  readonly colors?: string | undefined
  /** The edits in order, with the ids of `DiagramEditor`. */
  readonly edits?: readonly Edit[] | undefined
  readonly view?: LinkView | undefined
  /** The settings of layers by name. */
  readonly layers?: Readonly<Record<string, LayerValue>> | undefined
  /** The step at which the method is shown, a whole number from 0. */
  readonly step?: number | undefined
  /** The method that is shown step by step, as in the option of `trace`. */
  readonly method?: string | undefined
  /** The region to which cells are clipped. `null` removes the region of the data set.*/
  readonly region?: RegionShape | null | undefined
  /** The periods with which the circles repeat. `null` means that they do not repeat. */
  readonly lattice?: Lattice | null | undefined
  /**
   * The areas of the cells: `equal`, or a number above 0 for each circle in order. The areas are proportional to them.
   */
  readonly areas?: 'equal' | readonly number[] | undefined
}

/**
 * The content of a link to encode; circles may be given in any form.
 *
 * @category Links
 */
export interface LinkInput extends Omit<LinkState, 'circles'> {
  readonly circles?: Circles | undefined
}

const VERSION = 'v1'
const LONGEST_NAME = 200
const LONGEST_ATTRIBUTE = 10_000
const LONGEST_QUESTION = 2000
const DEEPEST_LAYER = 8
/** The largest nesting depth of a check. Each level is an object and may contain a list. */
const DEEPEST_CHECK = 20

/**
 * Encodes a state as the text of a link. All numbers are exact, except that -0 becomes 0.
 *
 * @throws CircleVoronoiError `badInput`, also for circles that `compute` refuses; `linkTooLong`, if a state exceeds
 *   `LINK_LIMITS`; `notLoaded`, if `CompressionStream` does not exist
 *
 * @category Links
 * @example
 * const link = await encodeLink({ circles: [[0, 0, 1], [6, 0, 1]], view: { x: 3, y: 4, span: 12 } })
 * link.slice(0, 3) // 'v1.'
 * const { circles, view } = await decodeLink(`#${link}`)
 * circles // Float64Array(6) [ 0, 0, 1, 6, 0, 1 ]
 * view // { x: 3, y: 4, span: 12 }
 */
export async function encodeLink(state: LinkInput): Promise<string> {
  return linkFrom(await compressText(jsonOf(state)))
}

/**
 * Encodes a state immediately, for a page that is about to close. The text is not compressed and several times as long.
 *
 * @throws CircleVoronoiError as `encodeLink`, except `notLoaded`
 *
 * @category Links
 * @example
 * const { circles } = await decodeLink(encodeLinkAtOnce({ circles: [[0, 0, 1]] }))
 * circles // Float64Array(3) [ 0, 0, 1 ]
 */
export function encodeLinkAtOnce(state: LinkInput): string {
  return linkFrom(storeText(jsonOf(state)))
}

function linkFrom(letters: string): string {
  if (letters.length > LINK_LIMITS.letters - VERSION.length - 1) tooMuch()
  return `${VERSION}.${letters}`
}

function jsonOf(state: LinkInput): string {
  if (typeof state !== 'object' || state === null)
    refuseInput(`The state of a link must be an object, not ${shown(state)}.`)
  const said = mapped(state, (value, { encode }) => (encode && value ? encode(value as never) : value))
  const problem = problemOf(said)
  if (problem !== undefined) refuseInput(`The state cannot be written as a link: ${problem}.`)
  const json = JSON.stringify(said)
  if (json.length > LINK_LIMITS.bytes) tooMuch()
  return json
}

/**
 * Decodes the text of a link. The circles of the state and of its edits are valid input for `compute`. An editor checks
 * whether the edits fit the circles.
 *
 * @param text the part of an address after the `#`, with or without the `#`
 * @throws CircleVoronoiError `badInput`; `linkTooLong`, if the link exceeds `LINK_LIMITS`; `notLoaded`, if
 *   `DecompressionStream` does not exist
 *
 * @category Links
 * @example
 * const { dataSet, edits } = await decodeLink(await encodeLink({ dataSet: 'spruces', edits: [{ kind: 'remove', id: 3 }]
 * }))
 * dataSet // 'spruces'
 * edits // [ { kind: 'remove', id: 3 } ]
 */
export async function decodeLink(text: string): Promise<LinkState> {
  if (typeof text !== 'string') refuseInput(`decodeLink takes a text, not ${shown(text)}.`)
  if (text.length > LINK_LIMITS.letters) tooMuch()
  const [, version, letters] = /^#?v(\d{1,9})\.([\w-]*)$/.exec(text) ?? refuse('it is not a link of this page')
  if (`v${version}` !== VERSION) refuse(`it has version ${version}, and this library reads version ${VERSION.slice(1)}`)
  let said: unknown
  try {
    const json = await decompressText(letters as string, LINK_LIMITS.bytes)
    if (json === undefined) tooMuch()
    said = JSON.parse(json)
  } catch (error) {
    if (error instanceof CircleVoronoiError) throw error
    refuse('a part of it is missing or wrong')
  }
  const problem = problemOf(said)
  if (problem !== undefined) refuse(problem)
  return mapped(said as object, (json, { decode }) => (decode && json ? decode(json as never) : json))
}

/** An edit as JSON: the ids and numbers of an insertion, a removal or a replacement. */
type EncodedEdit = readonly [kind: '+' | '-' | '=', ...numbers: number[]]

/** A field of a link. */
interface Field {
  /** Converts a value to JSON. Default: the value is JSON. */
  encode?(value: never): unknown
  /** Converts JSON without a problem to a value. */
  decode?(json: never): unknown
  /** Returns the reason why a value is not JSON of this field. `said` is the JSON of all fields. */
  problem(json: unknown, said: Readonly<Record<string, unknown>>): string | undefined
}

const unless = (
  isRight: (json: unknown, said: Readonly<Record<string, unknown>>) => boolean,
  reason: string,
): Field => ({
  problem: (json, said) => (isRight(json, said) ? undefined : reason),
})
const name = (field: string): Field =>
  unless(isName, `the field ${field} is not a text of at most ${LONGEST_NAME} letters`)

/** The fields in the order of their JSON. */
const FIELDS: { readonly [Name in keyof LinkState]-?: Field } = {
  circles: {
    encode: (circles: Circles) => [...coordinatesOf(circles)],
    decode: (numbers: readonly number[]) => Float64Array.from(numbers),
    problem: problemOfCircles,
  },
  names: unless(
    (names, said) => Array.isArray(names) && names.length === countIn(said) && names.every(isName),
    'there is not one name for each circle',
  ),
  attributes: unless(
    (attributes, said) => areAttributes(attributes, countIn(said)),
    'the attributes are not those of the circles',
  ),
  headings: unless(
    (headings) => Array.isArray(headings) && headings.length === 3 && headings.every(isName),
    'the headings are not three names',
  ),
  colors: unless(
    (colors) => typeof colors === 'string' && /^[0-7]*$/.test(colors),
    'the colors are not digits from 0 to 7',
  ),
  dataSet: {
    problem: (dataSet, { circles }) => {
      if (!isName(dataSet)) return 'the data set is not a name'
      return circles === undefined ? undefined : 'it has circles and a data set'
    },
  },
  edits: {
    encode: (edits: readonly Edit[]) => {
      if (!Array.isArray(edits)) refuseInput(`The edits of a link must be a list of edits, not ${shown(edits)}.`)
      return Array.from(edits, listOf)
    },
    decode: (edits: readonly EncodedEdit[]) => edits.map(editOf),
    problem: problemOfEdits,
  },
  view: {
    encode: ({ x, y, span }: LinkView) => [x, y, span],
    decode: ([x, y, span]: readonly [number, number, number]) => ({ x, y, span }),
    ...unless((view) => isListOfNumbers(view) && view.length === 3 && (view[2] as number) > 0, 'the view is invalid'),
  },
  layers: unless((layers) => isPlain(layers, DEEPEST_LAYER), 'the layers are invalid'),
  step: unless((step) => Number.isSafeInteger(step) && (step as number) >= 0, 'the step is not a whole number from 0'),
  method: unless(isName, 'the method is not a name'),
  region: {
    encode: (region: RegionShape) => (isRegion(region) ? plainRegion(region) : region),
    decode: (region: RegionShape) => plainRegion(region),
    ...unless((region) => region === null || isRegion(region), 'the region is invalid'),
  },
  lattice: {
    encode: (lattice: Lattice) => [...latticeNumbers(lattice, 'encodeLink')],
    decode: ([ax, ay, bx, by]: readonly number[]) => ({ a: [ax, ay], b: [bx, by] }),
    ...unless(
      (lattice) => lattice === null || (isListOfNumbers(lattice) && lattice.length === 4),
      'the lattice does not have four finite numbers',
    ),
  },
  areas: unless(
    (areas) => areas === 'equal' || (isListOfNumbers(areas) && areas.every((share) => share > 0)),
    'the areas are neither "equal" nor numbers above 0',
  ),
  title: name('title'),
  question: unless(
    (question) => typeof question === 'string' && question.length <= LONGEST_QUESTION,
    `the field question is not a text of at most ${LONGEST_QUESTION} letters`,
  ),
  // The element judges the conditions of a check.
  check: unless((check) => isPlain(check, DEEPEST_CHECK), 'the field check is invalid'),
  readonly: unless((readonly) => typeof readonly === 'boolean', 'the field readonly is neither true nor false'),
  alt: name('alt'),
  lang: name('lang'),
}

/** Converts each field that a state has. */
function mapped(state: object, convert: (value: unknown, field: Field) => unknown): Record<string, unknown> {
  const given = state as Readonly<Record<string, unknown>>
  const fields = Object.entries(FIELDS).filter(([name]) => given[name] !== undefined)
  return Object.fromEntries(fields.map(([name, field]) => [name, convert(given[name], field)]))
}

/** Returns the reason why a value is not the JSON of a link, or `undefined` if it is. */
function problemOf(said: unknown): string | undefined {
  if (!isRecord(said)) return 'it has no content'
  for (const [name, field] of Object.entries(FIELDS)) {
    const problem = said[name] === undefined ? undefined : field.problem(said[name], said)
    if (problem !== undefined) return problem
  }
  return undefined
}

function listOf(edit: Edit): EncodedEdit {
  const circle = (circle: CircleLike) => [circleX(circle), circleY(circle), circleRadius(circle)]
  switch (edit?.kind) {
    case 'insert':
      return ['+', ...circle(edit.circle)]
    case 'remove':
      return ['-', edit.id]
    case 'replace':
      return ['=', edit.id, ...circle(edit.circle)]
    default:
      refuseInput(`An edit of a link must be an insertion, a removal or a replacement, not ${shown(edit)}.`)
  }
}

function editOf([kind, ...numbers]: EncodedEdit): Edit {
  const [x, y, r] = numbers.slice(-3) as [number, number, number]
  if (kind === '+') return { kind: 'insert', circle: { x, y, r } }
  const id = numbers[0] as number
  return kind === '-' ? { kind: 'remove', id } : { kind: 'replace', id, circle: { x, y, r } }
}

/** The number of values of an edit, and whether the first one is an id. */
const EDITS: Readonly<Record<string, readonly [count: number, hasId: boolean]>> = {
  '+': [3, false],
  '-': [1, true],
  '=': [4, true],
}

/** The number of circles in the JSON of a link. */
function countIn({ circles }: Readonly<Record<string, unknown>>): number {
  return Array.isArray(circles) ? circles.length / 3 : 0
}

function problemOfCircles(circles: unknown): string | undefined {
  if (!isListOfNumbers(circles) || circles.length % 3 !== 0) return 'the circles do not have three finite numbers each'
  if (circles.length > 3 * LINK_LIMITS.circles) tooMuch()
  for (let i = 0; i < circles.length / 3; i++) {
    const problem = problemOfCircle(circles, 3 * i)
    if (problem !== undefined) return `circle ${i} ${problem}`
  }
  return undefined
}

function problemOfEdits(edits: unknown): string | undefined {
  if (!Array.isArray(edits) || !edits.every(isEdit)) return 'the edits are invalid'
  if (edits.length > LINK_LIMITS.edits) tooMuch()
  for (const [i, [kind, ...numbers]] of edits.entries()) {
    const problem = kind === '-' ? undefined : problemOfCircle(numbers, numbers.length - 3)
    if (problem !== undefined) return `the circle of edit ${i} ${problem}`
  }
  return undefined
}

/** Whether a value consists of rings of finite numbers. The shape of the rings is not checked. */
function isRegion(value: unknown): boolean {
  try {
    return ringArraysOf(value as RegionShape).points.every(Number.isFinite)
  } catch {
    return false
  }
}

/** Whether these are the attributes of `count` circles, with valid texts of JSON. */
function areAttributes(value: unknown, count: number): boolean {
  if (!isRecord(value)) return false
  const { properties, ids, heights, collection } = value
  const isList = (list: unknown, isRight: (json: unknown) => boolean) =>
    Array.isArray(list) && (list.length === 0 || list.length === count) && list.every((text) => isJson(text, isRight))
  const isId = (id: unknown) => typeof id === 'string' || typeof id === 'number'
  return (
    isList(properties, isRecord) &&
    isList(ids, isId) &&
    isList(heights, Number.isFinite) &&
    isJson(collection, isRecord)
  )
}

/** Whether a text is empty, or is JSON whose value passes `isRight`. */
function isJson(text: unknown, isRight: (value: unknown) => boolean): boolean {
  if (typeof text !== 'string' || text.length > LONGEST_ATTRIBUTE) return false
  try {
    return text === '' || isRight(JSON.parse(text))
  } catch {
    return false
  }
}

function isName(value: unknown): boolean {
  return typeof value === 'string' && value.length <= LONGEST_NAME
}

/**
 * Returns the core's reason for refusing the circle whose x, y and r begin at index `first`, or `undefined` if it is
 * valid.
 */
function problemOfCircle(numbers: readonly number[], first: number): string | undefined {
  const [x, y, r] = [numbers[first] as number, numbers[first + 1] as number, numbers[first + 2] as number]
  if (r < 0) return 'has a negative radius'
  const isTooLarge = Math.max(Math.abs(x), Math.abs(y), r) > COORDINATE_LIMIT
  return isTooLarge ? `has a coordinate or a radius beyond ${COORDINATE_LIMIT_TEXT}` : undefined
}

function isEdit(edit: unknown): edit is EncodedEdit {
  if (!Array.isArray(edit) || typeof edit[0] !== 'string' || !Object.hasOwn(EDITS, edit[0])) return false
  const [count, hasId] = EDITS[edit[0]] as readonly [number, boolean]
  const numbers = edit.slice(1)
  if (numbers.length !== count || !isListOfNumbers(numbers)) return false
  return !hasId || (Number.isInteger(numbers[0]) && (numbers[0] as number) >= 0 && (numbers[0] as number) < 2 ** 31)
}

/** Whether a value is a record of plain values that are nested at most `depth` deep. */
function isPlain(value: unknown, depth: number): boolean {
  return isRecord(value) && isLayer(value, depth, { left: LINK_LIMITS.layerValues })
}

function isLayer(value: unknown, depth: number, count: { left: number }): value is LayerValue {
  count.left -= 1
  if (depth === 0 || count.left < 0) tooMuch()
  if (Array.isArray(value)) return value.every((item) => isLayer(item, depth - 1, count))
  // Copying a member of such a name to another object would change its prototype.
  if (isRecord(value)) {
    return Object.entries(value).every(([name, item]) => name !== '__proto__' && isLayer(item, depth - 1, count))
  }
  return value === null || ['boolean', 'string'].includes(typeof value) || Number.isFinite(value)
}

function isListOfNumbers(value: unknown): value is number[] {
  return Array.isArray(value) && value.every(Number.isFinite)
}

function refuse(reason: string): never {
  throw new CircleVoronoiError('badInput', `The link cannot be read: ${reason}.`)
}

function tooMuch(): never {
  throw new CircleVoronoiError('linkTooLong', 'Too large for a link.')
}
