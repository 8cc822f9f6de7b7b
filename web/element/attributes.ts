// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in attributes that are more than a word.
import { reasonOf } from '../lib/base/errors.ts'
import { METHODS, type Method } from '../lib/base/types.ts'
import type { Lattice } from '../lib/index.ts'
import type { LinkView } from '../lib/link.ts'
import type { Areas } from '../view/domain.ts'
import { checkedLayers, DEFAULT_LAYERS, type Layers } from '../view/layers.ts'
import { shownValue } from '../view/refusal.ts'
import { type ElementRefusals, refuse } from './refusals.ts'

/** Layers that are a number. */
const NUMBERS = ['nearZero', 'maxDistance']
/** Those that a word may say. */
const WORDS = Object.entries(DEFAULT_LAYERS).flatMap(([name, value]) =>
  typeof value === 'boolean' || name === 'cells' || NUMBERS.includes(name)
    ? [name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)]
    : [],
)

/**
 * The layers that a text says: words, `hull` for a layer that is drawn, `no-edges` for one that is not, `cells=degree` and
 * `max-distance=2` for others; or an object in JSON.
 *
 * @throws Refusal that names the word which is none, and those that there are
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
    // What is no number is refused as it stands there.
    else if (NUMBERS.includes(layer) && value) given[layer] = Number.isFinite(Number(value)) ? Number(value) : value
    else refuse((words) => words.noLayer(word, WORDS))
  }
  return checkedLayers(given)
}

/** What can be looked at. */
export function checkedView({ x, y, span }: LinkView): LinkView {
  if (![x, y, span].every(Number.isFinite) || !(span > 0)) refuse((words) => words.view)
  return { x, y, span }
}

/**
 * The view that a text says: x and y of its middle, and how many units are seen at least in both directions.
 *
 * @throws Refusal
 */
export function parseView(text: string): LinkView {
  const [x, y, span, ...more] = wordsIn(text).map(Number) as [number, number, number]
  if (more.length > 0) refuse((words) => words.view)
  return checkedView({ x, y, span })
}

/**
 * The step that a text says.
 *
 * @throws Refusal
 */
export function parseStep(text: string): number {
  return wholeNumberOf(text) ?? refuse((words) => words.step(text))
}

/**
 * How many samples a text says.
 *
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
 * The areas that a text says: `equal`, or numbers.
 *
 * @throws Refusal
 */
export function parseAreas(text: string): Areas {
  return checkedAreas(text.trim() === 'equal' ? 'equal' : wordsIn(text).map(Number), text)
}

/**
 * The periods that a text says: x and y of each.
 *
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

const CONTROLS = ['buttons', 'player']
/** What HTML has for an attribute that is there. */
const BARE = ['controls', 'true']

/**
 * What of controls there is; `null`: none. Without words there are buttons.
 *
 * @throws Refusal
 */
export function parseControls(text: string | null): { readonly hasButtons: boolean; readonly hasPlayer: boolean } {
  const words = wordsIn(text ?? '')
  const isWrong =
    words.some((word) => !CONTROLS.includes(word)) && !(words.length === 1 && BARE.includes(words[0] as string))
  if (isWrong) refuse((said) => said.must(said.controls, said.someOf(CONTROLS), shownValue(text)))
  const hasPlayer = words.includes('player')
  return { hasButtons: text !== null && (!hasPlayer || words.length > 1), hasPlayer }
}

/** @throws Refusal */
export function parseJson(text: string, what: (words: ElementRefusals) => string): unknown {
  try {
    return JSON.parse(text)
  } catch (error) {
    return refuse((words) => words.notJson(what(words), reasonOf(error)), 'badInput')
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
