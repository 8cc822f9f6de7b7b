// SPDX-License-Identifier: GPL-3.0-or-later
import { isRecord } from '../lib/base/check.ts'
import { CircleVoronoiError } from '../lib/base/errors.ts'
import { CANDIDATES, type Candidates, type Point } from '../lib/base/types.ts'
import type { LayerValue } from '../lib/link.ts'
import { ENGLISH_REFUSALS, Refusal, type Refusals, shownValue } from './refusal.ts'
import { wholeNumber } from './whole-number.ts'

/**
 * The quantity that colors circles and cells. `different`: neighbors differ in color. `filled`: the area of the circle
 * divided by that of its cell. `gap`: the distance to the nearest other circle. `auto`: `different` for up to `MOST_MAPPED`
 * circles, `radius` for more.
 */
export const CELL_COLORS = ['auto', 'none', 'radius', 'area', 'filled', 'degree', 'gap', 'index', 'different'] as const
/** One of `CELL_COLORS`: the quantity that colors circles and cells. */
export type CellColors = (typeof CELL_COLORS)[number]

/** The largest number of circles for which `auto` gives neighbors different colors. */
export const MOST_MAPPED = 2000

/** The layers of the touching disc method, limited by the number of circles. */
const METHOD_LAYERS = ['samples', 'sampleGraph', 'antipodalDiscs', 'directedEdges'] as const
export type MethodLayer = (typeof METHOD_LAYERS)[number]
export const MOST_TRACED = 5000
/** Limit for `all-pairs`, whose number of candidates is quadratic. */
export const MOST_PAIRED = 1000

/** The least, the default and the largest number of samples for each kind of candidates. */
export const SAMPLES: Readonly<
  Record<Candidates, { readonly least: number; readonly usual: number; readonly most: number }>
> = {
  dynamic: { least: 0, usual: 1, most: 20 },
  uniform: { least: 1, usual: 50, most: 100 },
  'all-pairs': { least: 0, usual: 0, most: 0 },
}

/** Values by which cells are colored. */
export interface CellValues {
  readonly name: string
  /** The value of each circle by its id: a number, or the index of a category. A cell with NaN has no color. */
  readonly values: Float64Array
  /** The categories, the most frequent first. The first ones have a color each. `undefined`: the values are numbers. */
  readonly categories?: readonly string[] | undefined
}

/** Colors of single circles, which replace the automatic colors. */
export interface OwnColors {
  /** The index of each circle's color by its id, NaN for circles without one. */
  readonly values: Float64Array
  /** CSS colors. */
  readonly colors: readonly string[]
}

/** A layer of your own, in the units of the circles. */
export interface DataLayer {
  readonly id: string
  /** A CSS color. */
  readonly color: string
  /** Dots: x and y of each. */
  readonly points?: Float64Array
  /** Segments: x and y of one end and of the other end of each. */
  readonly segments?: Float64Array
  /** Outlines of circles: x, y and r of each. */
  readonly discs?: Float64Array
}

/** A layer that a client draws above the picture. */
export interface OverlayLayer extends DataLayer {
  /** Width of lines, in pixels. */
  readonly width?: number
  /** Radius of dots, in pixels. */
  readonly dot?: number
  /** Numbers written at the points in place of dots. */
  readonly numbers?: Int32Array
  readonly dash?: readonly number[]
  /** Opacity of the fill of discs, from 0 to 1. */
  readonly fill?: number
}

/** The layers that a figure draws, as plain data. */
export interface Layers {
  readonly circles: boolean
  /** The quantity by which cells are colored, or `none`. */
  readonly cells: CellColors
  /** Values by which cells are colored, in place of `cells`. */
  readonly column: CellValues | undefined
  /** Whether cells have the full color of their circles, as in a mosaic, in place of a tint. */
  readonly fullColor: boolean
  /** The names of circles. */
  readonly labels: boolean
  /** Axes and a grid with their coordinates. */
  readonly grid: boolean
  readonly edges: boolean
  readonly vertices: boolean
  /** Vertices that are joined by edges of at most this length are drawn as one. `undefined`: no vertices are merged. */
  readonly nearZero: number | undefined
  /** For each hidden circle, the circle that hides it. */
  readonly hidden: boolean
  /** The disc of the vertex or edge point under the pointer, and the points where it touches circles. */
  readonly disc: boolean
  /** The convex hull of the circles. */
  readonly hull: boolean
  /** The dual: a segment between the centers of circles whose cells share an edge. */
  readonly dual: boolean
  /** The Delaunay graph of the centers. */
  readonly delaunay: boolean
  /** The Voronoi diagram of the centers. */
  readonly ordinary: boolean
  /** The power diagram of the circles. */
  readonly power: boolean
  /** The largest empty disc whose center lies inside the hull. */
  readonly largestDisc: boolean
  /** The clearest path between two points, which keeps as far as possible from all circles. */
  readonly path: { readonly from: Point; readonly to: Point } | undefined
  /** The distance from their circles at which cells and edges are cut. `undefined`: no limit. */
  readonly maxDistance: number | undefined
  /** The samples of the touching disc method. */
  readonly samples: boolean
  /** The Delaunay graph of these samples. */
  readonly sampleGraph: boolean
  /** The empty antipodal discs of the touching disc method. */
  readonly antipodalDiscs: boolean
  /** The leftover directed edges of the touching disc method, which form the hull. */
  readonly directedEdges: boolean
  /** The edges of the diagram that the touching disc method misses. */
  readonly missedEdges: boolean
  /** The kind of candidates of the touching disc method. */
  readonly candidates: Candidates
  /**
   * The number of samples: inside each angle of a Delaunay face (`dynamic`), or on each circle (`uniform`). `undefined`:
   * the default of the library.
   */
  readonly sampleCount: number | undefined
  /** Layers of your own. */
  readonly data: readonly DataLayer[]
}

/** The painted layers: the visible layers and the circles' own colors. */
export interface PaintedLayers extends Layers {
  /** They are seen unless somebody chose a quantity for colors to show. */
  readonly ownColors?: OwnColors | undefined
}

export const DEFAULT_LAYERS: Layers = Object.freeze({
  circles: true,
  cells: 'auto',
  column: undefined,
  fullColor: false,
  labels: true,
  grid: false,
  edges: true,
  vertices: true,
  nearZero: undefined,
  hidden: false,
  disc: false,
  hull: false,
  dual: false,
  delaunay: false,
  ordinary: false,
  power: false,
  largestDisc: false,
  path: undefined,
  maxDistance: undefined,
  samples: false,
  sampleGraph: false,
  antipodalDiscs: false,
  directedEdges: false,
  missedEdges: false,
  candidates: 'dynamic',
  sampleCount: undefined,
  data: Object.freeze([]),
})

/** The largest number of circles whose method can be played step by step. */
export const MOST_PLAYED = 1000

/** @throws CircleVoronoiError `tooManyCircles` if a method is not played for this number of circles */
export function checkPlayed(count: number): void {
  if (count <= MOST_PLAYED) return
  const reason = `A method is played for ${wholeNumber(MOST_PLAYED)} circles at most; there are ${wholeNumber(count)}.`
  throw new CircleVoronoiError('tooManyCircles', reason)
}

/** Hides everything that reveals the diagram, for exercises. */
export function withoutDiagram({ circles, labels, grid, hidden, data }: Layers): Layers {
  return { ...DEFAULT_LAYERS, circles, labels, grid, hidden, data, cells: 'none', edges: false, vertices: false }
}

/** Hides the layers that are meaningless for repeating circles. */
export function repeatingLayers(layers: PaintedLayers): PaintedLayers {
  const { hull, delaunay, ordinary, power, largestDisc, path, missedEdges } = DEFAULT_LAYERS
  const method = Object.fromEntries(METHOD_LAYERS.map((name) => [name, false]))
  return { ...layers, ...method, hull, delaunay, ordinary, power, largestDisc, path, missedEdges }
}

/** Whether layers differ only in their path, which is not painted by the thread. */
export function isPathOnly(layers: Layers, before: Layers): boolean {
  return (Object.keys(layers) as (keyof Layers)[]).every((name) => name === 'path' || layers[name] === before[name])
}

/** Whether a layer of the touching disc method is visible. */
export function isMethodShown(layers: Layers): boolean {
  return layers.missedEdges || METHOD_LAYERS.some((name) => layers[name])
}

/** Whether a layer of the method is visible for this number of circles. */
export function isTraced(layers: Layers, circles: number): boolean {
  return circles <= (layers.candidates === 'all-pairs' ? MOST_PAIRED : MOST_TRACED) && isMethodShown(layers)
}

/** Whether a visible layer depends on all circles. */
export function isAnythingFound(layers: Layers): boolean {
  const { hull, largestDisc, path } = layers
  return hull || largestDisc || path !== undefined || isMethodShown(layers)
}

/** A quantity of a cell that can be measured. */
export type Measure = Exclude<CellColors, 'auto' | 'none' | 'different'>

export function isMeasure(colors: CellColors): colors is Measure {
  return colors !== 'auto' && colors !== 'none' && colors !== 'different'
}

/**
 * The settings that differ from the default, for storage. Layers of clients are left out, and values are stored by
 * name.
 */
export function keptLayers(layers: Layers): Readonly<Record<string, LayerValue>> {
  const known = DEFAULT_LAYERS as unknown as Record<string, unknown>
  const { column } = layers
  const kept = Object.entries(layers).filter(([name, value]) => name !== 'data' && value !== known[name])
  return { ...Object.fromEntries(kept), ...(column && { column: column.name }) }
}

/** Restores stored settings. Unknown and invalid ones become the default. */
export function layersFrom(kept: unknown): Layers {
  if (!isRecord(kept)) return DEFAULT_LAYERS
  const given = kept as Readonly<Record<string, unknown>>
  const layers: Record<string, unknown> = { ...DEFAULT_LAYERS }
  for (const [name, value] of Object.entries(DEFAULT_LAYERS)) {
    if (typeof value === 'boolean' && typeof given[name] === 'boolean') layers[name] = given[name]
  }
  const { cells, nearZero, maxDistance, path, candidates, sampleCount } = given
  const known = CANDIDATES.find((name) => name === candidates) ?? 'dynamic'
  layers.candidates = known
  const { least, most } = SAMPLES[known]
  const isCount = Number.isInteger(sampleCount) && (sampleCount as number) >= least && (sampleCount as number) <= most
  if (isCount) layers.sampleCount = sampleCount
  if ((CELL_COLORS as readonly unknown[]).includes(cells)) layers.cells = cells
  if (isNumber(nearZero) && nearZero >= 0) layers.nearZero = nearZero
  if (isNumber(maxDistance)) layers.maxDistance = maxDistance
  const { from, to } = (path ?? {}) as Readonly<Record<string, unknown>>
  if (isPoint(from) && isPoint(to)) layers.path = { from: { x: from.x, y: from.y }, to: { x: to.x, y: to.y } }
  return layers as unknown as Layers
}

/**
 * Checks layers of a client. Missing, `undefined` and `null` settings become the default.
 * @throws Refusal if a name or a value is invalid
 */
export function checkedLayers(given: unknown): Layers {
  if (!isRecord(given)) {
    refuse((words) => words.must(words.layers, words.object, shownValue(given)))
  }
  const set = Object.entries(given).filter(([, value]) => value !== undefined && value !== null)
  const layers = { ...DEFAULT_LAYERS, ...Object.fromEntries(set) } as Layers
  checkLayers(layers)
  // Copies the data, so that later changes have no effect and only plain data is sent to the thread.
  const { column, data } = layers
  return { ...layers, path: layersFrom(layers).path, column: column && plainColumn(column), data: data.map(plainData) }
}

/** @throws Refusal if a name is unknown, or a value would crash the painting thread */
export function checkLayers(layers: Layers): void {
  const known = layersFrom(layers)
  const refuseValue = (name: keyof Layers, allowed: (words: Refusals) => string) =>
    refuse((words) => words.must(words.layer(name), allowed(words), shownValue(layers[name])))
  const isOther = (name: keyof Layers) => layers[name] !== known[name]
  for (const name of Object.keys(layers) as (keyof Layers)[]) {
    if (!Object.hasOwn(DEFAULT_LAYERS, name)) refuse((words) => words.noLayer(name, Object.keys(DEFAULT_LAYERS)))
    if (typeof DEFAULT_LAYERS[name] === 'boolean' && isOther(name)) refuseValue(name, (words) => words.trueOrFalse)
  }
  if (isOther('cells')) refuseValue('cells', (words) => words.oneOf(CELL_COLORS))
  if (isOther('candidates')) refuseValue('candidates', (words) => words.oneOf(CANDIDATES))
  if (isOther('nearZero')) refuseValue('nearZero', (words) => words.numberFromZero)
  if (isOther('maxDistance')) refuseValue('maxDistance', (words) => words.number)
  const { least, most } = SAMPLES[layers.candidates]
  if (isOther('sampleCount')) refuseValue('sampleCount', (words) => words.wholeNumber(least, most))
  if (layers.path !== undefined && known.path === undefined) refuseValue('path', (words) => words.path)
  if (!isColumn(layers.column)) refuseValue('column', (words) => words.cellValues)
  if (!Array.isArray(layers.data) || !layers.data.every(isData)) refuseValue('data', (words) => words.data)
}

function refuse(say: (words: Refusals) => string): never {
  throw new Refusal(ENGLISH_REFUSALS, say)
}

function isColumn(column: unknown): boolean {
  if (column === undefined) return true
  if (!isRecord(column)) return false
  const { name, values, categories } = column
  const isList =
    categories === undefined || (Array.isArray(categories) && categories.every((text) => typeof text === 'string'))
  return typeof name === 'string' && values instanceof Float64Array && isList
}

function isData(layer: unknown): layer is DataLayer {
  if (!isRecord(layer)) return false
  const { id, color, points, segments, discs }: Partial<Record<keyof DataLayer, unknown>> = layer
  return typeof id === 'string' && typeof color === 'string' && [points, segments, discs].every(isNumbersOrNone)
}

/** BigInts would crash the painting thread. */
function isNumbersOrNone(list: unknown): boolean {
  if (list === undefined) return true
  const isList = Array.isArray(list) || (ArrayBuffer.isView(list) && !(list instanceof DataView))
  return isList && Array.prototype.every.call(list, (item: unknown) => typeof item === 'number')
}

function plainColumn({ name, values, categories }: CellValues): CellValues {
  return { name, values: values.slice(), ...(categories && { categories: [...categories] }) }
}

function plainData({ id, color, points, segments, discs }: DataLayer): DataLayer {
  const copied = (list: Float64Array | undefined) => list && Float64Array.from(list)
  const lists = { points: copied(points), segments: copied(segments), discs: copied(discs) }
  return { id, color, ...Object.fromEntries(Object.entries(lists).filter(([, list]) => list !== undefined)) }
}

function isNumber(value: unknown): value is number {
  return Number.isFinite(value)
}

function isPoint(value: unknown): value is Point {
  const { x, y } = (value ?? {}) as Readonly<Record<string, unknown>>
  return isNumber(x) && isNumber(y)
}
