// SPDX-License-Identifier: GPL-3.0-or-later
import { NO_ATTRIBUTES } from '../editing/attributes.ts'
import type { Float64s } from '../lib/index.ts'
import { LINK_LIMITS } from '../lib/link.ts'
import { namedCirclesOfText } from '../view/circle-text.ts'
import type { Domain } from '../view/domain.ts'
import { readRegion } from '../view/region-text.ts'
import { wholeNumber } from '../view/whole-number.ts'
import type { NamedCircles } from './files/files-protocol.ts'
import type { Recipe } from './generators/generators.ts'

/** An entry of the menu. */
export interface DataSet {
  readonly id: string
  readonly label: string
  /** A description in one line. */
  readonly about: string
  /** The owner of the data. */
  readonly credit?: string
  /** Whether the data set has a region: `ID.region.json`, a list of rings. */
  readonly hasRegion?: boolean
  /** The recipe of random circles, which get a new seed each time. */
  readonly random?: { readonly family: string; readonly count: number }
}

/** The first data set is shown at the start. */
export const DATA_SETS: readonly DataSet[] = [
  { id: 'start', label: 'Eight circles', about: 'Every point is colored by its nearest circle. Drag one.' },
  {
    id: 'introduction',
    label: 'Introduction',
    about: 'Circles that overlap, and one that lies hidden inside another.',
  },
  {
    id: 'bronzefilter',
    label: 'Bronze filter',
    about: 'Particles in a section of a bronze filter, 18 mm by 7 mm.',
    credit: 'Image by R. Bernhardt, measured by H. Wendrock; R package spatstat.data',
  },
  {
    id: 'spruces',
    label: 'Spruces',
    about: 'Trunks of Norway spruces in a plot of Saxony, 56 m by 38 m.',
    credit: 'Stoyan et al., 1987; R package spatstat.data',
  },
  {
    id: 'waka',
    label: 'Waka trees',
    about: 'Trunks of trees in the Waka national park, Gabon, 100 m by 100 m.',
    credit: 'R package spatstat.data',
  },
  {
    id: 'cities',
    label: 'Cities of Europe',
    about: 'Cities of 100,000 inhabitants or more; the area of a circle grows with them.',
    credit: 'GeoNames, CC BY 4.0; coasts and borders by Natural Earth',
    hasRegion: true,
  },
  {
    id: 'random',
    label: 'Random',
    about: 'Three hundred random circles, other ones each time.',
    random: { family: 'dense', count: 300 },
  },
  {
    id: 'random-large',
    label: 'Random, 10,000',
    about: 'Ten thousand random circles, other ones each time.',
    random: { family: 'dense', count: 10_000 },
  },
]

/** Largest number of circles of a family. */
export const MOST_CIRCLES = 1_000_000
/** All seeds are below this number. Random seeds are much smaller, so that people can type them. */
const SEEDS = 2 ** 53
const RANDOM_SEEDS = 1_000_000

/** The source of named circles. */
export type Source = { readonly kind: 'file'; readonly id: string } | Recipe

/** The source that a name stands for, always with the same circles; `undefined` if the name is unknown. */
export function sourceOf(name: string): Source | undefined {
  const file = DATA_SETS.find(({ id, random }) => id === name && random === undefined)
  if (file !== undefined) return { kind: 'file', id: name }
  const figure = /^figure-([0-9a-z]{1,9})$/.exec(name)?.[1]
  if (figure !== undefined) return { kind: 'figure', figure }
  const [, family, seed, count] = /^([a-z][a-z-]{0,40}):(\d{1,16}):([1-9]\d{0,6})$/.exec(name) ?? []
  if (family === undefined || Number(seed) >= SEEDS || Number(count) > MOST_CIRCLES) return undefined
  return { kind: 'family', family, seed: Number(seed), count: Number(count) }
}

/** The name of a recipe's circles. */
export function nameOf(recipe: Recipe): string {
  return recipe.kind === 'figure' ? `figure-${recipe.figure}` : `${recipe.family}:${recipe.seed}:${recipe.count}`
}

/** The name of a menu entry's circles. Random circles get a new name each time. */
export function nameFrom({ id, random }: DataSet): string {
  return random === undefined ? id : nameOf({ kind: 'family', ...random, seed: randomSeed() })
}

export function randomSeed(): number {
  return Math.floor(RANDOM_SEEDS * Math.random())
}

/** The label of a name; empty if the name is unknown. */
export function labelOf(name: string): string {
  const source = sourceOf(name)
  switch (source?.kind) {
    case 'file':
      return dataSetOf(name)?.label ?? ''
    case 'figure':
      return `Figure ${source.figure}`
    case 'family':
      return `${source.family}, ${wholeNumber(source.count)}`
    case undefined:
      return ''
  }
}

/** The menu entry of a name. */
export function dataSetOf(name: string): DataSet | undefined {
  const source = sourceOf(name)
  if (source?.kind === 'file') return DATA_SETS.find(({ id }) => id === name)
  if (source?.kind !== 'family') return undefined
  return DATA_SETS.find(({ random }) => random?.family === source.family && random.count === source.count)
}

/** Circles with their clipping region. */
export interface Loaded extends NamedCircles {
  readonly domain?: Domain | undefined
}

/** @throws Error if the name is unknown, or the circles cannot be fetched or generated */
export async function loadDataSet(name: string, make: (recipe: Recipe) => Promise<Float64s>): Promise<Loaded> {
  const source = sourceOf(name)
  switch (source?.kind) {
    case 'file':
      return fetched(name)
    case 'figure':
    case 'family':
      return { circles: await make(source) }
    case undefined:
      throw new Error('There is no data set of this name.')
  }
}

/**
 * Loads the circles that a link names. Links may come from anyone, so that recipes that take minutes are refused.
 * @throws Error as `loadDataSet`, and if there are too many circles
 */
export async function loadLinked(name: string, make: (recipe: Recipe) => Promise<Float64s>): Promise<Loaded> {
  const source = sourceOf(name)
  if (source?.kind === 'family' && source.count > LINK_LIMITS.circles) {
    throw new Error('The link is for too many circles.')
  }
  return loadDataSet(name, make)
}

/** Requests that have started before they are needed. */
const ahead = new Map<string, Promise<Response>>()

/** Starts the request for a file that will probably be opened first, while the page is still loading. */
export function askAhead(name: string): void {
  const asked = request(`${name}.csv`)
  // The error is reported when the file is opened.
  asked.catch(() => {})
  ahead.set(name, asked)
}

function request(file: string): Promise<Response> {
  return fetch(new URL(`data/${file}`, document.baseURI))
}

async function fetched(name: string): Promise<Loaded> {
  const asked = ahead.get(name)
  ahead.delete(name)
  const { hasRegion = false } = dataSetOf(name) ?? {}
  const files = [asked ?? request(`${name}.csv`), ...(hasRegion ? [request(`${name}.region.json`)] : [])]
  const [table = '', region] = await Promise.all(files.map(async (file) => textOf(await file, name)))
  const { circles: numbers, columns } = namedCirclesOfText(table)
  const circles = { circles: numbers, ...(columns.length > 0 && { attributes: { ...NO_ATTRIBUTES, columns } }) }
  return region === undefined ? circles : { ...circles, domain: { region: readRegion(region), areas: undefined } }
}

function textOf(response: Response, name: string): Promise<string> {
  if (!response.ok) throw new Error(`The data set ${labelOf(name)} could not be loaded (${response.status}).`)
  return response.text()
}
