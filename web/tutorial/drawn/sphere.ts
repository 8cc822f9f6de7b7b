// SPDX-License-Identifier: GPL-3.0-or-later
// Circles on a globe, drawn as seen from far away. A globe in a figure has radius 1.
import type { Circle, Point } from '../../lib/index.ts'
import type { Pen } from './scene.ts'

/** A vector; z points to the eye. */
export type Vector = readonly [x: number, y: number, z: number]

/** A circle on the globe: a unit vector, and an angle in radians as the radius, which may be negative. */
export interface Cap {
  readonly center: Vector
  readonly r: number
}

/** Rows of the colored picture, and directions in which borders are looked for. */
const ROWS = 140
const DIRECTIONS = 540
/** Smaller radii are not seen. */
const LEAST = 0.01
/** Points of a drawn circle. */
const RIM = 90
/** Centers stay within this distance of the globe's middle, on the side that is seen. */
const NEAR_LIMB = 0.985

/** The circles of a figure on the globe around a point of the picture. */
export function capsOf(circles: readonly Circle[], globe: Point): Cap[] {
  return circles.map(({ x, y, r }) => {
    const [right, up] = [x - globe.x, y - globe.y]
    const shrink = Math.min(1, NEAR_LIMB / Math.hypot(right, up))
    const [a, b] = [right * shrink, up * shrink]
    return { center: [a, b, Math.sqrt(1 - a * a - b * b)], r }
  })
}

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/** The angle between two directions. */
export function angleBetween(a: Vector, b: Vector): number {
  return Math.acos(Math.min(Math.max(dot(a, b), -1), 1))
}

/** The distance from a cap to a place: to its center, minus its radius. */
export function distanceTo({ center, r }: Cap, place: Vector): number {
  return angleBetween(center, place) - r
}

export function nearestCap(caps: readonly Cap[], place: Vector): number {
  const distances = caps.map((cap) => distanceTo(cap, place))
  return distances.indexOf(Math.min(...distances))
}

/** Two directions at a place that are at right angles to it: to the right and up for an eye above the place. */
export function axesAt(place: Vector): readonly [right: Vector, up: Vector] {
  const [x, y, z] = place
  const side: Vector = Math.abs(y) < 0.99 ? [0, 1, 0] : [1, 0, 0]
  const along = dot(side, place)
  const rest: Vector = [side[0] - along * x, side[1] - along * y, side[2] - along * z]
  const length = Math.hypot(...rest)
  const up: Vector = [rest[0] / length, rest[1] / length, rest[2] / length]
  return [[up[1] * z - up[2] * y, up[2] * x - up[0] * z, up[0] * y - up[1] * x], up]
}

/** The place at an angle from another one, in a direction. */
export function placeFrom(
  from: Vector,
  [right, up]: readonly [Vector, Vector],
  direction: number,
  angle: number,
): Vector {
  const [sine, cosine] = [Math.sin(angle), Math.cos(angle)]
  const [a, b] = [sine * Math.cos(direction), sine * Math.sin(direction)]
  const at = (k: 0 | 1 | 2) => cosine * from[k] + a * right[k] + b * up[k]
  return [at(0), at(1), at(2)]
}

/** Draws the cells that are seen, in the colors of their circles, and their borders. */
export function drawGlobe(pen: Pen, caps: readonly Cap[], globe: Point): void {
  const cells = rowsOf(caps.length, (place) => nearestCap(caps, place))
  for (const [i, rows] of cells.entries()) pen.path(`cell rows c${i}`, rowsPath(rows, globe))
  for (const i of caps.keys()) pen.path('edge', seenPath(borderOf(caps, i), globe))
  pen.disc('frame', { ...globe, r: 1 })
}

/** Draws the part of an empty disc that is seen. */
export function drawDisc(pen: Pen, disc: Cap, globe: Point): void {
  const [rows = []] = rowsOf(1, (place) => (distanceTo(disc, place) < 0 ? 0 : -1))
  pen.path('empty rows', rowsPath(rows, globe)).path('touching good part', rimPath(disc, globe))
}

/** Draws the circles with their numbers. Circles with negative radii are dashed. */
export function drawCaps(pen: Pen, caps: readonly Cap[], globe: Point): void {
  for (const [i, cap] of caps.entries()) {
    const center = { x: globe.x + cap.center[0], y: globe.y + cap.center[1] }
    pen.path(`c${i} rim${cap.r < 0 ? ' negative' : ''}`, rimPath(cap, globe))
    drawNumbered(pen, i, center)
  }
}

/** Draws the center of a circle with its number. */
export function drawNumbered(pen: Pen, i: number, center: Point): void {
  pen.dot(`c${i}`, center, 4)
  pen.write('number', { x: center.x + pen.units(11), y: center.y + pen.units(4) }, `${i}`)
}

/** The part of a circle that is seen; empty for a point. */
export function rimPath({ center, r }: Cap, globe: Point): string {
  if (Math.abs(r) < LEAST) return ''
  const axes = axesAt(center)
  const rim = Array.from({ length: RIM + 1 }, (_, k) => placeFrom(center, axes, (2 * Math.PI * k) / RIM, Math.abs(r)))
  return seenPath(rim, globe)
}

/** A part of a row of the picture, from one x to another. */
interface Row {
  readonly from: number
  readonly to: number
  readonly y: number
}

/** The parts of rows with each owner. Places may have none, which is -1. */
function rowsOf(owners: number, ownerOf: (place: Vector) => number): Row[][] {
  const parts = Array.from({ length: owners }, (): Row[] => [])
  const step = 2 / ROWS
  for (let row = 0; row < ROWS; row++) {
    const y = -1 + (row + 0.5) * step
    const half = Math.sqrt(1 - y * y)
    const count = Math.max(1, Math.round((2 * half) / step))
    const at = (k: number) => -half + (2 * half * k) / count
    let [owner, from] = [-1, 0]
    for (let k = 0; k <= count; k++) {
      const x = at(k + 0.5)
      const now = k === count ? -1 : ownerOf([x, y, Math.sqrt(Math.max(1 - x * x - y * y, 0))])
      if (now === owner) continue
      if (owner >= 0) parts[owner]?.push({ from: at(from), to: at(k), y: y - step / 2 })
      ;[owner, from] = [now, k]
    }
  }
  return parts
}

function rowsPath(rows: readonly Row[], globe: Point): string {
  return rows
    .map(({ from, to, y }) => {
      const [x0, x1] = [short(globe.x + from), short(globe.x + to)]
      return `M${x0},${short(globe.y + y)}H${x1}V${short(globe.y + y + 2 / ROWS)}H${x0}Z`
    })
    .join('')
}

/** The border of a cell, by directions from its center. Empty without a border. */
function borderOf(caps: readonly Cap[], i: number): Vector[] {
  const own = caps[i] as Cap
  const others = caps.filter((_, k) => k !== i)
  // Another circle contains this one.
  if (others.some((cap) => angleBetween(cap.center, own.center) <= cap.r - own.r)) return []
  const axes = axesAt(own.center)
  const [right, up] = axes
  const borders = others
    .filter((cap) => angleBetween(cap.center, own.center) > own.r - cap.r)
    .map((cap) => {
      const angle = angleBetween(cap.center, own.center)
      const lead = own.r - cap.r
      const direction = Math.atan2(dot(cap.center, up), dot(cap.center, right))
      return (phi: number) =>
        Math.atan2(Math.cos(lead) - Math.cos(angle), Math.sin(angle) * Math.cos(phi - direction) - Math.sin(lead))
    })
  if (borders.length === 0) return []
  return Array.from({ length: DIRECTIONS + 1 }, (_, k) => {
    const phi = (2 * Math.PI * k) / DIRECTIONS
    return placeFrom(own.center, axes, phi, Math.min(...borders.map((border) => border(phi))))
  })
}

/** The path of the points that are on the seen side. */
function seenPath(points: readonly Vector[], globe: Point): string {
  let d = ''
  let isOpen = false
  for (const [x, y, z] of points) {
    if (z >= 0) d += `${isOpen ? 'L' : 'M'}${short(globe.x + x)},${short(globe.y + y)}`
    isOpen = z >= 0
  }
  return d
}

function short(value: number): string {
  return `${Number(value.toFixed(4))}`
}
