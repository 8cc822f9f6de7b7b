// SPDX-License-Identifier: GPL-3.0-or-later
// Shared code of the figures about prescribed areas: weighted sites in a box, the areas of their cells, and the concave
// function whose maximum has the prescribed areas.
import type { Circle, CircleVoronoi, Diagram } from '../../lib/index.ts'
import { colorsOf, type Pen } from './scene.ts'

export interface Frame {
  readonly minX: number
  readonly minY: number
  readonly maxX: number
  readonly maxY: number
}

/** Sample points of the box in each direction for the sum that approximates an integral. */
const FINENESS = 40

/** The part of the plane that a picture shows, without its margin. */
export function frameIn(pen: Pen): Frame {
  const margin = pen.units(10)
  const [minX, minY, maxX, maxY] = pen.bounds
  return { minX: minX + margin, minY: minY + margin, maxX: maxX - margin, maxY: maxY - margin }
}

export function areaOf({ minX, minY, maxX, maxY }: Frame): number {
  return (maxX - minX) * (maxY - minY)
}

/** The diagram of weighted sites: circles whose radii are the weights minus the smallest weight. */
export function weighted(sites: readonly Circle[], weights: readonly number[], library: CircleVoronoi): Diagram {
  const least = Math.min(...weights)
  return library.compute(Float64Array.from(sites.flatMap(({ x, y }, i) => [x, y, (weights[i] as number) - least])))
}

/** The area of each cell in a box. */
export function areasIn(frame: Frame, diagram: Diagram): readonly number[] {
  return [...diagram.cellAreas({ bounds: boundsOf(frame) })]
}

/** The derivatives of all areas by all weights, by finite differences. Row i belongs to the area of cell i. */
export function stiffnessIn(
  frame: Frame,
  sites: readonly Circle[],
  weights: readonly number[],
  library: CircleVoronoi,
): readonly (readonly number[])[] {
  const step = 1e-4 * Math.sqrt(areaOf(frame))
  const areasAt = (j: number, by: number) =>
    areasIn(
      frame,
      weighted(
        sites,
        weights.map((weight, i) => (i === j ? weight + by : weight)),
        library,
      ),
    )
  const columns = sites.map((_, j) => {
    const [after, before] = [areasAt(j, step), areasAt(j, -step)]
    return after.map((area, i) => (area - (before[i] as number)) / (2 * step))
  })
  return sites.map((_, i) => columns.map((column) => column[i] as number))
}

/**
 * The function of the weights that is greatest where the cells have their prescribed areas, in units of the box's area:
 * the mean of the least distance minus weight, plus the sum of weights times shares.
 */
export function heightOver(
  { minX, minY, maxX, maxY }: Frame,
  sites: readonly Circle[],
  shares: readonly number[],
): (weights: readonly number[]) => number {
  const distances: Float64Array[] = []
  for (let k = 0; k < FINENESS * FINENESS; k++) {
    const x = minX + ((maxX - minX) * ((k % FINENESS) + 0.5)) / FINENESS
    const y = minY + ((maxY - minY) * (Math.floor(k / FINENESS) + 0.5)) / FINENESS
    distances.push(Float64Array.from(sites, (site) => Math.hypot(site.x - x, site.y - y)))
  }
  return (weights) => {
    let sum = 0
    for (const to of distances) {
      let least = Number.POSITIVE_INFINITY
      for (let i = 0; i < to.length; i++) least = Math.min(least, (to[i] as number) - (weights[i] as number))
      sum += least
    }
    return sum / distances.length + weights.reduce((total, weight, i) => total + weight * (shares[i] as number), 0)
  }
}

/** Draws the cells in a box with their sites. Draws the weights as discs if few discs overlap. */
export function drawWeighted(
  pen: Pen,
  frame: Frame,
  diagram: Diagram,
  sites: readonly Circle[],
  { hasDiscs = true } = {},
): void {
  const colors = colorsOf(diagram)
  const bounds = boundsOf(frame)
  for (const i of sites.keys()) pen.path(`cell c${colors[i]}`, diagram.cellPath(i, { bounds }))
  for (const [i, { x, y }] of hasDiscs ? sites.entries() : []) {
    pen.disc(`weight c${colors[i]}`, { x, y, r: diagram.circles[3 * i + 2] as number })
  }
  pen.path('edge', diagram.render({ bounds }))
  const { minX, minY, maxX, maxY } = frame
  pen.path('frame', `M${minX},${minY}H${maxX}V${maxY}H${minX}Z`)
  for (const [i, site] of sites.entries()) pen.dot(`site c${colors[i]}`, site, 5)
}

/** Whether a cell's share of the area looks right. */
export function isNear(share: number, goal: number): boolean {
  return Math.abs(share - goal) < 0.015
}

/** Writes the number of each site and its cell's share of the area. */
export function writeShares(
  pen: Pen,
  sites: readonly Circle[],
  shares: readonly number[],
  goals: readonly number[],
): void {
  for (const [i, { x, y }] of sites.entries()) {
    const [share, goal] = [shares[i] as number, goals[i] as number]
    const isRight = isNear(share, goal)
    pen.write('number', { x, y: y + pen.units(14) }, `${i}`)
    pen.write(isRight ? 'label right' : 'label', { x, y: y - pen.units(26) }, `${percent(share)}${isRight ? ' ✓' : ''}`)
  }
}

export function percent(part: number): string {
  return `${Math.round(100 * part)} %`
}

function boundsOf({ minX, minY, maxX, maxY }: Frame): [number, number, number, number] {
  return [minX, minY, maxX, maxY]
}
