// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../lib/base/diagram-data.ts'
import { cross, dot } from '../lib/base/point.ts'
import { shortestPeriods } from '../lib/diagram/lattice.ts'
import type { Box, Lattice, Point } from '../lib/index.ts'
import { type RegionShape, ringArraysOf } from '../lib/regions/region-shape.ts'

/**
 * The areas of cells: shares of the region as numbers above 0, in the order of the circles, or `equal`.
 * @category Element
 */
export type Areas = 'equal' | readonly number[]

/** The clipping region of cells, their areas, and periods. */
export interface Domain {
  /** The clipping region. `undefined`: cells are not clipped. */
  readonly region: RegionShape | undefined
  /** The periods with which the circles repeat. `undefined`: circles do not repeat. */
  readonly lattice?: Lattice | undefined
  /** The areas, by id. `undefined`: circles keep their own radii. */
  readonly areas: Areas | undefined
  /** The radii before areas were prescribed, by id, if they are known. */
  readonly radii?: readonly number[] | undefined
}

export const NO_DOMAIN: Domain = { region: undefined, areas: undefined }

/**
 * The bounding box of circles and region or periods. With areas, it is the box of the region, because radii are
 * weights.
 */
export function boxOf(circles: Box, { region, areas, lattice }: Domain): Box {
  if (lattice !== undefined) return boxOfPeriods(lattice)
  if (region === undefined) return circles
  const box = boxes.get(region) ?? regionBox(region)
  boxes.set(region, box)
  if (areas !== undefined) return box
  return {
    minX: Math.min(circles.minX, box.minX),
    minY: Math.min(circles.minY, box.minY),
    maxX: Math.max(circles.maxX, box.maxX),
    maxY: Math.max(circles.maxY, box.maxY),
  }
}

function boxOfPeriods({ a, b }: Lattice): Box {
  const [x, y] = [0, 1].map((axis) => [
    0,
    a[axis] as number,
    b[axis] as number,
    (a[axis] as number) + (b[axis] as number),
  ])
  const [minX, minY, maxX, maxY] = [
    Math.min(...(x as number[])),
    Math.min(...(y as number[])),
    Math.max(...(x as number[])),
    Math.max(...(y as number[])),
  ]
  // Shows part of the neighboring images.
  const margin = 0.1 * Math.max(maxX - minX, maxY - minY)
  return { minX: minX - margin, minY: minY - margin, maxX: maxX + margin, maxY: maxY + margin }
}

/** Returns a function that makes vectors as short as possible by adding periods. */
export function shortestWith(lattice: Lattice): (x: number, y: number) => Point {
  // The shortest vector ends at a corner of the parallelogram of the shortest periods around a vector.
  const [u, v] = shortestPeriods(lattice).vectors
  const area = cross(u, v)
  return (x, y) => {
    const [k, l] = [Math.floor(cross({ x, y }, v) / area), Math.floor(cross(u, { x, y }) / area)]
    let shortest = { x, y }
    for (const [i, j] of CORNERS) {
      const image = { x: x - (k + i) * u.x - (l + j) * v.x, y: y - (k + i) * u.y - (l + j) * v.y }
      if (dot(image, image) < dot(shortest, shortest)) shortest = image
    }
    return shortest
  }
}

const CORNERS = [
  [0, 0],
  [0, 1],
  [1, 0],
  [1, 1],
] as const

const boxes = new WeakMap<RegionShape, Box>()

function regionBox(region: RegionShape): Box {
  const { points } = ringArraysOf(region)
  const box = { minX: Infinity, minY: Infinity, maxX: -Infinity, maxY: -Infinity }
  for (let k = 0; k < points.length; k += 2) {
    const [x, y] = [at(points, k), at(points, k + 1)]
    box.minX = Math.min(box.minX, x)
    box.minY = Math.min(box.minY, y)
    box.maxX = Math.max(box.maxX, x)
    box.maxY = Math.max(box.maxY, y)
  }
  return box
}

/** The rings of a region. A ring inside another one is a hole. */
export function ringsOf(region: RegionShape | undefined): [x: number, y: number][][] {
  if (region === undefined) return []
  const { points, ringOffsets } = ringArraysOf(region)
  return Array.from({ length: ringOffsets.length - 1 }, (_, ring) => {
    const [from, to] = [at(ringOffsets, ring), at(ringOffsets, ring + 1)]
    return Array.from({ length: to - from }, (_, k) => [at(points, 2 * (from + k)), at(points, 2 * (from + k) + 1)])
  })
}
