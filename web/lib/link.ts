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
import { frameOf, type LinkFrame } from './link-frame.ts'
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
const FIELDS = [
  'circles',
  'names',
  'attributes',
  'headings',
  'colors',
  'dataSet',
  'edits',
  'view',
  'layers',
  'step',
  'method',
  'region',
  'lattice',
  'areas',
] as const

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
  const {
    circles,
    names,
    attributes,
    headings,
    colors,
    dataSet,
    edits,
    view,
    layers,
    step,
    method,
    region,
    lattice,
    areas,
  } = state
  if (edits !== undefined && !Array.isArray(edits))
    refuseInput(`The edits of a link must be a list of edits, not ${shown(edits)}.`)
  const said: Record<(typeof FIELDS)[number], unknown> & LinkFrame = {
    circles: circles && [...coordinatesOf(circles)],
    names,
    attributes,
    headings,
    colors,
    dataSet,
    edits: edits && Array.from(edits, listOf),
    view: view && [view.x, view.y, view.span],
    layers,
    step,
    method,
    region,
    lattice: lattice && [...latticeNumbers(lattice, 'encodeLink')],
    areas,
    ...frameOf(state),
  }
  const problem = problemOf(said)
  if (problem !== undefined) refuseInput(`The state cannot be written as a link: ${problem}.`)
  const json = JSON.stringify({ ...said, region: region && plainRegion(region) })
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
  return stateOf(said as EncodedLink)
}

/** The encoded form of a link, with lists of numbers. */
interface EncodedLink extends LinkFrame {
  readonly circles?: readonly number[] | undefined
  readonly names?: readonly string[] | undefined
  readonly attributes?: LinkAttributes | undefined
  readonly headings?: LinkState['headings']
  readonly colors?: string | undefined
  readonly dataSet?: string | undefined
  readonly edits?: readonly (readonly [kind: '+' | '-' | '=', ...numbers: number[]])[] | undefined
  readonly view?: readonly [number, number, number] | undefined
  readonly layers?: Readonly<Record<string, LayerValue>> | undefined
  readonly step?: number | undefined
  readonly method?: string | undefined
  readonly region?: RegionShape | null | undefined
  readonly lattice?: readonly [ax: number, ay: number, bx: number, by: number] | null | undefined
  readonly areas?: 'equal' | readonly number[] | undefined
}

function stateOf(said: EncodedLink): LinkState {
  const {
    circles,
    names,
    attributes,
    headings,
    colors,
    dataSet,
    edits,
    view,
    layers,
    step,
    method,
    region,
    lattice,
    areas,
  } = said
  return {
    ...(circles && { circles: Float64Array.from(circles) }),
    ...(names && { names }),
    ...(attributes && { attributes }),
    ...(headings && { headings }),
    ...(colors !== undefined && { colors }),
    ...(dataSet !== undefined && { dataSet }),
    ...(edits && { edits: edits.map(editOf) }),
    ...(view && { view: { x: view[0], y: view[1], span: view[2] } }),
    ...(layers && { layers }),
    ...(step !== undefined && { step }),
    ...(method !== undefined && { method }),
    ...(region !== undefined && { region: region && plainRegion(region) }),
    ...(lattice !== undefined && { lattice: lattice && latticeOf(lattice) }),
    ...(areas !== undefined && { areas }),
    ...frameOf(said),
  }
}

function latticeOf([ax, ay, bx, by]: readonly [number, number, number, number]): Lattice {
  return { a: [ax, ay], b: [bx, by] }
}

function listOf(edit: Edit): Exclude<EncodedLink['edits'], undefined>[number] {
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

function editOf([kind, ...numbers]: Exclude<EncodedLink['edits'], undefined>[number]): Edit {
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

/** Returns the reason why a value is not an `EncodedLink`, or `undefined` if it is. */
function problemOf(said: unknown): string | undefined {
  if (!isRecord(said)) return 'it has no content'
  const {
    circles,
    names,
    attributes,
    headings,
    colors,
    dataSet,
    edits,
    view,
    layers,
    step,
    method,
    region,
    lattice,
    areas,
  } = said
  if (step !== undefined && !(Number.isSafeInteger(step) && (step as number) >= 0))
    return 'the step is not a whole number from 0'
  if (method !== undefined && !isName(method)) return 'the method is not a name'
  if (circles !== undefined) {
    if (!isListOfNumbers(circles) || circles.length % 3 !== 0)
      return 'the circles do not have three finite numbers each'
    if (circles.length > 3 * LINK_LIMITS.circles) tooMuch()
    for (let i = 0; i < circles.length / 3; i++) {
      const problem = problemOfCircle(circles, 3 * i)
      if (problem !== undefined) return `circle ${i} ${problem}`
    }
  }
  if (names !== undefined) {
    const count = Array.isArray(circles) ? circles.length / 3 : 0
    if (!Array.isArray(names) || names.length !== count || !names.every(isName))
      return 'there is not one name for each circle'
  }
  if (attributes !== undefined && !areAttributes(attributes, Array.isArray(circles) ? circles.length / 3 : 0))
    return 'the attributes are not those of the circles'
  if (headings !== undefined && !(Array.isArray(headings) && headings.length === 3 && headings.every(isName)))
    return 'the headings are not three names'
  if (colors !== undefined && !(typeof colors === 'string' && /^[0-7]*$/.test(colors)))
    return 'the colors are not digits from 0 to 7'
  if (dataSet !== undefined) {
    if (!isName(dataSet)) return 'the data set is not a name'
    if (circles !== undefined) return 'it has circles and a data set'
  }
  if (edits !== undefined) {
    if (!Array.isArray(edits) || !edits.every(isEdit)) return 'the edits are invalid'
    if (edits.length > LINK_LIMITS.edits) tooMuch()
    for (const [i, [kind, ...numbers]] of edits.entries()) {
      const problem = kind === '-' ? undefined : problemOfCircle(numbers, numbers.length - 3)
      if (problem !== undefined) return `the circle of edit ${i} ${problem}`
    }
  }
  if (region !== undefined && region !== null && !isRegion(region)) return 'the region is invalid'
  const isLattice = lattice === undefined || lattice === null || (isListOfNumbers(lattice) && lattice.length === 4)
  if (!isLattice) return 'the lattice does not have four finite numbers'
  const isShares = isListOfNumbers(areas) && areas.every((share) => share > 0)
  if (areas !== undefined && areas !== 'equal' && !isShares) return 'the areas are neither "equal" nor numbers above 0'
  if (view !== undefined) {
    if (!isListOfNumbers(view) || view.length !== 3 || !((view[2] as number) > 0)) return 'the view is invalid'
  }
  const problem = problemOfFrame(said)
  if (problem !== undefined) return problem
  const isRight =
    layers === undefined || (isRecord(layers) && isLayer(layers, DEEPEST_LAYER, { left: LINK_LIMITS.layerValues }))
  return isRight ? undefined : 'the layers are invalid'
}

/** Returns the reason why the fields of a frame are invalid. The element judges the conditions of a check. */
function problemOfFrame({ title, question, check, readonly, alt, lang }: Record<string, unknown>): string | undefined {
  for (const [name, text] of Object.entries({ title, alt, lang })) {
    if (text !== undefined && !isName(text)) return `the field ${name} is not a text of at most ${LONGEST_NAME} letters`
  }
  if (question !== undefined && !(typeof question === 'string' && question.length <= LONGEST_QUESTION))
    return `the field question is not a text of at most ${LONGEST_QUESTION} letters`
  if (readonly !== undefined && typeof readonly !== 'boolean') return 'the field readonly is neither true nor false'
  const isPlain =
    check === undefined || (isRecord(check) && isLayer(check, DEEPEST_CHECK, { left: LINK_LIMITS.layerValues }))
  return isPlain ? undefined : 'the field check is invalid'
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

function isEdit(edit: unknown): edit is NonNullable<EncodedLink['edits']>[number] {
  if (!Array.isArray(edit) || typeof edit[0] !== 'string' || !Object.hasOwn(EDITS, edit[0])) return false
  const [count, hasId] = EDITS[edit[0]] as readonly [number, boolean]
  const numbers = edit.slice(1)
  if (numbers.length !== count || !isListOfNumbers(numbers)) return false
  return !hasId || (Number.isInteger(numbers[0]) && (numbers[0] as number) >= 0 && (numbers[0] as number) < 2 ** 31)
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
