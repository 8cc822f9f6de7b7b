// SPDX-License-Identifier: GPL-3.0-or-later
// Three sites in a box, beside a map of pairs of weights. The map's height is the concave function whose maximum has
// the prescribed areas; the slider draws its contour lines.
import type { Circle } from '../../lib/index.ts'
import {
  areaOf,
  areasIn,
  drawWeighted,
  type Frame,
  heightOver,
  isNear,
  percent,
  weighted,
  writeShares,
} from './areas.ts'
import { type Kind, list, Pen, type Scene } from './scene.ts'

/** The prescribed shares of the area. */
export const THREE_SHARES = [0.2, 0.3, 0.5] as const
const MOST_LINES = 8
/** The number of grid cells of the map in each direction. */
const SQUARES = 28

export const weightPlane: Kind = {
  range: () => ({ last: MOST_LINES, step: 1 }),

  draw(scene, value, library) {
    const { circles } = scene
    const pen = new Pen(scene)
    const { box, map } = panelsOf(pen)
    const weights = weightsOf(scene, map)
    const diagram = weighted(circles, weights, library)
    drawWeighted(pen, box, diagram, circles)
    const shares = areasIn(box, diagram).map((area) => area / areaOf(box))
    writeShares(pen, circles, shares, THREE_SHARES)
    const { minX, minY, maxX, maxY } = map
    const middle = { x: (minX + maxX) / 2, y: (minY + maxY) / 2 }
    pen.path('map', `M${minX},${minY}H${maxX}V${maxY}H${minX}Z`)
    pen.path('axis', `M${minX},${middle.y}H${maxX}M${middle.x},${minY}V${maxY}`)
    if (value > 0) pen.path('contour', contoursOf(scene, map, box, Math.floor(value)))
    pen.write('label', { x: maxX - pen.units(4), y: minY + pen.units(8) }, 'weight of site 1 →', 'end')
    pen.write('label', { x: minX + pen.units(6), y: maxY - pen.units(28) }, '↑ weight of site 2', 'start')
    const isRight = shares.every((share, i) => isNear(share, THREE_SHARES[i] as number))
    pen.dot(isRight ? 'point right' : 'point', scene.point ?? middle, 7)
    const parts = shares.map(
      (share, i) => `cell ${i} has ${percent(share)} (goal: ${percent(THREE_SHARES[i] as number)})`,
    )
    return {
      content: pen.content,
      told: isRight ? `Well done. Every cell has its area: ${list(parts)}.` : `${list(parts).replace(/^c/, 'C')}.`,
    }
  },
}

/** The box of the sites, and the map of weights. */
export function panelsOf(pen: Pen): { readonly box: Frame; readonly map: Frame } {
  const [minX, minY, maxX, maxY] = pen.bounds
  const margin = pen.units(12)
  const middle = (minX + maxX) / 2
  const side = middle - minX - 1.5 * margin
  const y = (minY + maxY) / 2
  return {
    box: { minX: minX + margin, minY: y - side / 2, maxX: minX + margin + side, maxY: y + side / 2 },
    map: { minX: maxX - margin - side, minY: y - side / 2, maxX: maxX - margin, maxY: y + side / 2 },
  }
}

/** The weights of the three sites. The first one is 0. */
export function weightsOf({ point }: Scene, { minX, minY, maxX, maxY }: Frame): readonly number[] {
  const middle = { x: (minX + maxX) / 2, y: (minY + maxY) / 2 }
  const x = Math.min(Math.max(point?.x ?? middle.x, minX), maxX)
  const y = Math.min(Math.max(point?.y ?? middle.y, minY), maxY)
  return [0, x - middle.x, y - middle.y]
}

/** The last height map. Dragging a point does not change the map, so that it is reused. */
let kept: { readonly key: string; readonly heights: readonly (readonly number[])[] } | undefined

function heightsOf(circles: readonly Circle[], map: Frame, box: Frame): readonly (readonly number[])[] {
  const key = JSON.stringify([circles, map])
  if (kept?.key === key) return kept.heights
  const height = heightOver(box, circles, THREE_SHARES)
  const half = (map.maxX - map.minX) / 2
  const at = (k: number) => half * ((2 * k) / SQUARES - 1)
  const heights = Array.from({ length: SQUARES + 1 }, (_, row) =>
    Array.from({ length: SQUARES + 1 }, (_, column) => height([0, at(column), at(row)])),
  )
  kept = { key, heights }
  return heights
}

/** Contour lines below the maximum, by marching squares. */
function contoursOf({ circles }: Scene, map: Frame, box: Frame, count: number): string {
  const heights = heightsOf(circles, map, box)
  const all = heights.flat()
  const [least, most] = [Math.min(...all), Math.max(...all)]
  const size = (map.maxX - map.minX) / SQUARES
  let d = ''
  for (let line = 1; line <= count; line++) {
    const level = most - (most - least) * (line / (MOST_LINES + 1)) ** 2
    for (let row = 0; row < SQUARES; row++) {
      for (let column = 0; column < SQUARES; column++) {
        const corners = [
          [column, row],
          [column + 1, row],
          [column + 1, row + 1],
          [column, row + 1],
        ] as const
        const over = corners.map(([c, r]) => (heights[r]?.[c] as number) - level)
        const cuts = corners.flatMap(([c, r], k) => {
          const [from, to] = [over[k] as number, over[(k + 1) % 4] as number]
          if (from > 0 === to > 0) return []
          const part = from / (from - to)
          const [nextC, nextR] = corners[(k + 1) % 4] as readonly [number, number]
          const x = map.minX + size * (c + part * (nextC - c))
          const y = map.minY + size * (r + part * (nextR - r))
          return [`${x.toFixed(2)},${y.toFixed(2)}`]
        })
        for (let k = 0; k + 1 < cuts.length; k += 2) d += `M${cuts[k]}L${cuts[k + 1]}`
      }
    }
  }
  return d
}
