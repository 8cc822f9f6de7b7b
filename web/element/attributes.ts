// SPDX-License-Identifier: GPL-3.0-or-later
// Parsers of attributes that hold more than one word.
import { reasonOf } from '../lib/base/errors.ts'
import { METHODS, type Method } from '../lib/base/types.ts'
import type { Lattice } from '../lib/index.ts'
import type { LinkView } from '../lib/link.ts'
import type { RegionShape } from '../lib/regions/region-shape.ts'
import type { Areas } from '../view/domain.ts'
import { checkedLayers, DEFAULT_LAYERS, type Layers } from '../view/layers.ts'
import { shownValue } from '../view/refusal.ts'
import { isRegionText, readRegion } from '../view/region-text.ts'
import { type ElementRefusals, refuse } from './refusals.ts'

/** The layers with a numeric value. */
const NUMBERS = ['nearZero', 'maxDistance']
/** The words for all values of layers. */
const WORDS = Object.entries(DEFAULT_LAYERS).flatMap(([name, value]) =>
  typeof value === 'boolean' || name === 'cells' || NUMBERS.includes(name)
    ? [name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)]
    : [],
)

/**
 * Parses layers: words, such as `hull` for a visible layer, `no-edges` for a hidden one, `cells=degree` and
 * `max-distance=2`; or an object in JSON.
 * @throws Refusal that names the unknown word and lists the known ones
 */
export function parseLayers(text: string): Layers {
  if (text.trim().startsWith('{')) return checkedLayers(parseJson(text, (words) => words.layers))
  const given: Record<string, unknown> = {}
  for (const word of wordsIn(text)) {
    const [name, value] = word.split('=') as [string, string | undefined]
    const isOff = name.startsWith('no-')
    const layer = camelCase(isOff ? name.slice(3) : name)
    const known = Object.hasOwn(DEFAULT_LAYERS, layer) ? DEFAULT_LAYERS[layer as keyof Layers] : undefined
    if (typeof known === 'boolean' && value === undefined) given[layer] = !isOff
    else if (layer === 'cells' && isOff) given.cells = 'none'
    else if (layer === 'cells' && value !== undefined) given.cells = value
    // An invalid number stays text, so that the error quotes it.
    else if (NUMBERS.includes(layer) && value) given[layer] = Number.isFinite(Number(value)) ? Number(value) : value
    else refuse((words) => words.noLayer(word, WORDS))
  }
  return checkedLayers(given)
}

/** Checks that a view is visible at all. */
export function checkedView(view: unknown): LinkView {
  const { x, y, span } = Object(view) as LinkView
  if (![x, y, span].every(Number.isFinite) || !(span > 0)) refuse((words) => words.view)
  return { x, y, span }
}

/**
 * Parses a view: x and y of its center, and the number of units that are visible at least in both directions.
 * @throws Refusal
 */
export function parseView(text: string): LinkView {
  const [x, y, span, ...more] = wordsIn(text).map(Number) as [number, number, number]
  if (more.length > 0) refuse((words) => words.view)
  return checkedView({ x, y, span })
}

/**
 * Parses a step.
 * @throws Refusal
 */
export function parseStep(text: string): number {
  return wholeNumberOf(text) ?? refuse((words) => words.step(text))
}

/**
 * Parses a number of samples.
 * @throws Refusal
 */
export function parseSamples(text: string): number {
  return wholeNumberOf(text) ?? refuse((words) => words.must(words.samples, words.wholeNumber(0), shownValue(text)))
}

/** @throws Refusal */
export function parseMethod(text: string): Method {
  const method = METHODS.find((name) => name === text)
  return method ?? refuse((words) => words.must(words.method, words.oneOf(METHODS), shownValue(text)))
}

/**
 * Parses areas: `equal`, or numbers.
 * @throws Refusal
 */
export function parseAreas(text: string): Areas {
  return checkedAreas(text.trim() === 'equal' ? 'equal' : wordsIn(text).map(Number), text)
}

/**
 * Parses periods: x and y of each.
 * @throws Refusal
 */
export function parseLattice(text: string): Lattice {
  const [ax, ay, bx, by, ...more] = wordsIn(text).map(Number) as [number, number, number, number]
  return checkedLattice(more.length > 0 ? undefined : { a: [ax, ay], b: [bx, by] }, text)
}

/** @throws Refusal */
export function checkedLattice(lattice: unknown, got = lattice): Lattice {
  const { a, b }: Partial<Record<'a' | 'b', unknown>> = Object(lattice)
  const isPeriod = (period: unknown): period is Lattice['a'] =>
    Array.isArray(period) && period.length === 2 && period.every(Number.isFinite)
  if (isPeriod(a) && isPeriod(b)) return { a, b }
  refuse((words) => words.must(words.lattice, words.twoPeriods, shownValue(got)))
}

/** @throws Refusal */
export function checkedAreas(areas: unknown, got = areas): Areas {
  const isList = Array.isArray(areas) && areas.length > 0
  if (areas === 'equal' || (isList && areas.every((area) => Number.isFinite(area) && area > 0))) {
    return isList ? areas.slice() : areas
  }
  refuse((words) => words.must(words.areas, words.sharesOrEqual, shownValue(got)))
}

/**
 * Parses a region. Any other text is the address of a file, and an empty text is no region.
 * @throws CircleVoronoiError
 */
export function parseRegion(text: string): RegionShape | string | undefined {
  return isRegionText(text) ? readRegion(text) : text || undefined
}

const CONTROLS = ['buttons', 'player']
/** Values that frameworks give to boolean attributes. */
const BARE = ['controls', 'true']

/**
 * Parses the visible controls. An empty value shows buttons.
 * @throws Refusal
 */
export function parseControls(text: string): { readonly hasButtons: boolean; readonly hasPlayer: boolean } {
  const words = wordsIn(text)
  const isWrong =
    words.some((word) => !CONTROLS.includes(word)) && !(words.length === 1 && BARE.includes(words[0] as string))
  if (isWrong) refuse((said) => said.must(said.controls, said.someOf(CONTROLS), shownValue(text)))
  const hasPlayer = words.includes('player')
  return { hasButtons: !hasPlayer || words.length > 1, hasPlayer }
}

/** @throws Refusal */
export function parseJson(text: string, what: (words: ElementRefusals) => string): unknown {
  try {
    return JSON.parse(text)
  } catch (error) {
    return refuse((words) => words.notJson(what(words), reasonOf(error)))
  }
}

function wholeNumberOf(text: string): number | undefined {
  const number = text.trim() === '' ? Number.NaN : Number(text)
  return Number.isSafeInteger(number) && number >= 0 ? number : undefined
}

function wordsIn(text: string): string[] {
  return text.split(/[\s,]+/).filter((word) => word !== '')
}

function camelCase(name: string): string {
  return name.replace(/-([a-z])/g, (_, letter: string) => letter.toUpperCase())
}
