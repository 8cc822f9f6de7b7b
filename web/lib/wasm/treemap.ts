// SPDX-License-Identifier: GPL-3.0-or-later
// The tree and the cells of a treemap, in this thread and in a worker.
import { checkOptionNames, isRecord, refuseInput, refuseOption, shown } from '../base/check.ts'
import { at } from '../base/diagram-data.ts'
import { CircleVoronoiError } from '../base/errors.ts'
import type { Float64s, Int32s } from '../base/types.ts'
import { type ClippedPolygons, Region } from '../regions/region.ts'
import { checkSignal } from './fit.ts'

/**
 * A node of a tree, as `d3.hierarchy(data).sum(...)` returns it, or any object with these properties.
 *
 * @category Regions
 */
export interface TreeNode {
  /** The nodes below. A node without any is a leaf. */
  readonly children?: readonly TreeNode[] | null | undefined
  /** The value of a leaf. The value of another node is the sum of those of its leaves. */
  readonly value?: number | undefined
}

/**
 * The properties that `treemap` sets on each node.
 *
 * @category Regions
 */
export interface TreemapCell {
  /** The corners of the cell, counter-clockwise. Empty if the value is 0. */
  polygon: [x: number, y: number][]
  /**
   * All parts of the cell with their holes, as the coordinates of a MultiPolygon in GeoJSON, but without repeated
   * points. In a convex region it is `[[polygon]]`.
   */
  polygons: [x: number, y: number][][][]
  /** The area of the cell. */
  area: number
  /** The site of the cell, and its weight among its siblings. Undefined if the value is 0. */
  site: { readonly x: number; readonly y: number; readonly weight: number } | undefined
}

/**
 * A tree with cells.
 *
 * @category Regions
 */
export type TreeWithCells<Node> = Node &
  TreemapCell &
  (Node extends { readonly children?: infer Children }
    ? { children?: Children extends readonly (infer Child)[] ? TreeWithCells<Child>[] : Children }
    : unknown)

/**
 * Options of `treemap`.
 *
 * @category Regions
 */
export interface TreemapOptions {
  /** The region that the tree divides. */
  readonly region: Region
  /**
   * Whether borders between leaves are straight (`power`) or curved (`circles`). Other borders are straight. Default:
   * `power`.
   */
  readonly metric?: 'power' | 'circles' | undefined
  /**
   * The number of times that sites move to the centroids of their cells, which makes cells rounder. Default: 8, or 0 for
   * cells that `previous` has.
   */
  readonly relax?: number | undefined
  /** The largest relative error of an area. Default: 1e-9. */
  readonly tolerance?: number | undefined
  /**
   * The root of an earlier treemap. The children of a node stay where they were, so the treemap changes little if values
   * do. If one of them is new or lies outside now, all of them begin anew. Earlier nodes are found by their keys, from
   * the root down.
   */
  readonly previous?: TreeNode | undefined
  /**
   * The key of a node among its siblings. Default: its `id` or `name`, those of its `data`, or its place among its
   * siblings.
   */
  // biome-ignore lint/suspicious/noExplicitAny: a caller knows its nodes
  readonly key?: ((node: any, place: number) => unknown) | undefined
  /**
   * Called with the number of nodes that have been divided, and of all that are to be, after each step. If it throws,
   * the computation stops and the error is passed on.
   */
  readonly progress?: ((done: number, count: number) => void) | undefined
  /** A signal that cancels the computation with its reason: in a worker at once, elsewhere where `progress` aborts it. */
  readonly signal?: AbortSignal | undefined
}

/** The input of a treemap, with checked types. The core checks the values. */
export interface TreemapInput {
  readonly parents: Int32s
  readonly values: Float64s
  readonly metric: 'power' | 'circles'
  readonly relax: number | undefined
  readonly tolerance: number
  /** x, y and weight of the earlier site of each node, NaN for a new one; empty without an earlier treemap. */
  readonly previous: Float64s
}

/** The cells of all nodes, as the core returns them. */
export interface TreemapArrays extends ClippedPolygons {
  readonly values: Float64Array
  readonly areas: Float64Array
  /** x, y and weight of each. */
  readonly sites: Float64Array
}

/** The nodes of a tree in an order in which parents come first. */
export interface Tree<Node> {
  readonly input: TreemapInput
  /** Sets the cells on the nodes, and returns the root. */
  finish(cells: TreemapArrays): TreeWithCells<Node>
  /** Returns the same error with the names of the node, instead of its number. */
  named(error: unknown): unknown
}

type Mutable = TreeNode & Partial<TreemapCell>

/** @throws CircleVoronoiError `badInput`, `badOption` */
export function treeOf<Node extends TreeNode>(root: Node, options: TreemapOptions): Tree<Node> {
  checkOptionNames(options, 'treemap', NAMES)
  const { region, metric = 'power', relax, tolerance = 1e-9, previous, key = defaultKey, progress, signal } = options
  if (!(region instanceof Region)) {
    refuseOption('treemap needs a region, which `region` of `loadRegions` makes, as its option region.')
  }
  if (metric !== 'power' && metric !== 'circles') refuseOption(`metric is power or circles, not ${shown(metric)}.`)
  if (relax !== undefined && !(Number.isInteger(relax) && Math.abs(relax) < 2 ** 31)) {
    refuseOption(`relax is a whole number, not ${shown(relax)}.`)
  }
  if (typeof tolerance !== 'number') refuseOption(`tolerance is a number, not ${shown(tolerance)}.`)
  if (typeof key !== 'function') refuseOption('The option key is a function.')
  if (progress !== undefined && typeof progress !== 'function') refuseOption('The option progress is a function.')
  checkSignal(signal)
  const { nodes, parents, keys } = flattened(root, key)
  const nameOf = (node: number) => {
    const names: unknown[] = []
    for (let i = node; i > 0; i = at(parents, i)) names.unshift(keys[i])
    return names.length === 0 ? 'the root' : `the node ${names.join(', ')}`
  }
  const values = nodes.map((node, i) => {
    if (childrenOf(node).length > 0) return 0
    if (typeof node.value !== 'number') {
      refuseInput(`The value of ${nameOf(i)} is a number, not ${shown(node.value)}.`)
    }
    return node.value
  })
  const input = { parents, values: Float64Array.from(values), metric, relax, tolerance }
  return {
    input: { ...input, previous: previous === undefined ? new Float64Array(0) : sitesIn(previous, key, parents, keys) },
    finish(cells) {
      for (const [i, node] of nodes.entries()) Object.assign(node, cellAt(cells, i))
      return root as TreeWithCells<Node>
    },
    named(error) {
      if (!(error instanceof CircleVoronoiError) || error.circle === undefined) return error
      const name = nameOf(error.circle)
      const capital = name.charAt(0).toUpperCase() + name.slice(1)
      const message = error.message
        .replace(`Node ${error.circle} `, `${capital} `)
        .replace(`node ${error.circle} `, `${name} `)
      return new CircleVoronoiError(error.code, message)
    },
  }
}

const NAMES = ['region', 'metric', 'relax', 'tolerance', 'previous', 'key', 'progress', 'signal']

function defaultKey(node: unknown, place: number): unknown {
  const of = (object: unknown) => (isRecord(object) ? (object.id ?? object.name) : undefined)
  return of(node) ?? of((node as { readonly data?: unknown }).data) ?? place
}

function childrenOf({ children }: TreeNode): readonly TreeNode[] {
  if (children === undefined || children === null) return []
  if (!Array.isArray(children)) refuseInput(`The children of a node are a list, not ${shown(children)}.`)
  return children
}

function flattened(root: unknown, key: NonNullable<TreemapOptions['key']>) {
  const nodes: Mutable[] = []
  const parents: number[] = []
  const keys: unknown[] = []
  const add = (node: unknown, parent: number, place: number) => {
    if (!isRecord(node)) refuseInput(`A node of the tree is an object, not ${shown(node)}.`)
    if (nodes.length >= 2 ** 31 - 1) refuseInput('The tree has too many nodes.')
    nodes.push(node as Mutable)
    parents.push(parent)
    keys.push(parent < 0 ? undefined : key(node, place))
  }
  add(root, -1, 0)
  const seen = new Set(nodes)
  for (let i = 0; i < nodes.length; i++) {
    for (const [place, child] of childrenOf(nodes[i] as Mutable).entries()) {
      if (seen.has(child as Mutable)) refuseInput('The tree has a node twice.')
      add(child, i, place)
      seen.add(child as Mutable)
    }
  }
  return { nodes, parents: Int32Array.from(parents), keys }
}

/** Returns the sites that the nodes of a tree have in an earlier one. */
function sitesIn(
  previous: TreeNode,
  key: NonNullable<TreemapOptions['key']>,
  parents: Int32Array,
  keys: readonly unknown[],
): Float64s {
  const earlier = flattened(previous, key)
  const childrenByKey = earlier.nodes.map(() => new Map<unknown, number>())
  for (let i = 1; i < earlier.nodes.length; i++) childrenByKey[at(earlier.parents, i)]?.set(earlier.keys[i], i)
  const found: (number | undefined)[] = [0]
  const sites = new Float64Array(3 * keys.length).fill(Number.NaN)
  for (let i = 0; i < keys.length; i++) {
    if (i > 0) {
      const parent = found[at(parents, i)]
      found[i] = parent === undefined ? undefined : childrenByKey[parent]?.get(keys[i])
    }
    const site = found[i] === undefined ? undefined : earlier.nodes[found[i] as number]?.site
    if (site !== undefined) sites.set([site.x, site.y, site.weight], 3 * i)
  }
  return sites
}

function cellAt(cells: TreemapArrays, node: number): TreemapCell {
  const { polygonOffsets, ringOffsets, pointOffsets, points, areas, sites, values } = cells
  const range = (offsets: Int32Array, k: number) =>
    Array.from({ length: at(offsets, k + 1) - at(offsets, k) }, (_, i) => at(offsets, k) + i)
  const polygons = range(polygonOffsets, node).map((polygon) =>
    range(ringOffsets, polygon).map((ring) =>
      range(pointOffsets, ring).map((p): [number, number] => [at(points, 2 * p), at(points, 2 * p + 1)]),
    ),
  )
  const [x, y, weight] = sites.subarray(3 * node) as unknown as [number, number, number]
  return {
    polygon: polygons[0]?.[0] ?? [],
    polygons,
    area: at(areas, node),
    site: at(values, node) > 0 ? { x, y, weight } : undefined,
  }
}
