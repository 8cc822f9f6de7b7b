// SPDX-License-Identifier: GPL-3.0-or-later
// A globe, and what an eye at the largest circle sees through it: circles of the plane. The slider shows one empty disc
// after another, on the globe and in the plane.
import type { Circle, CircleVoronoi, Diagram, Point } from '../../lib/index.ts'
import { boundingBox } from '../../view/camera.ts'
import { type Kind, list, Pen, type Scene } from './scene.ts'
import {
  angleBetween,
  axesAt,
  type Cap,
  capsOf,
  dot,
  drawCaps,
  drawDisc,
  drawGlobe,
  drawNumbered,
  placeFrom,
  type Vector,
} from './sphere.ts'

/** The middles of both halves of the picture. */
const GLOBE = { x: -1.1, y: 0 }
const PLANE = { x: 1.1, y: 0 }
/** Half of the side of the square that shows a part of the plane. */
const HALF = 1
/** Rows of a disc in this square. */
const ROWS = 140
/** The part of this square that circles fill. */
const FILLED = 0.8

export const globePlane: Kind = {
  range: (scene, library) => ({ last: Math.max(seenFromLargest(scene, library).discs.length - 1, 1), step: 1 }),

  draw(scene, value, library) {
    const { caps, eye, circles, names, diagram, discs } = seenFromLargest(scene, library)
    const pen = new Pen(scene)
    const disc = discs[Math.min(Math.round(value), discs.length - 1)]
    drawGlobe(pen, caps, GLOBE)
    if (disc !== undefined) drawDisc(pen, disc.onGlobe, GLOBE)
    drawCaps(pen, caps, GLOBE)

    const bounds = [PLANE.x - HALF, PLANE.y - HALF, PLANE.x + HALF, PLANE.y + HALF] as const
    for (const [k, i] of names.entries()) pen.path(`cell c${i}`, diagram.cellPath(k, { bounds: [...bounds] }))
    pen.path('edge', diagram.render({ bounds: [...bounds] }))
    if (disc !== undefined) {
      pen.path('empty rows', chordsIn(disc.inPlane, bounds)).path('touching good part', arcsIn(disc.inPlane, bounds))
    }
    for (const [k, circle] of circles.entries()) {
      const i = names[k] as number
      if (circle.r !== 0) pen.disc(`c${i} rim negative`, circle)
      drawNumbered(pen, i, circle)
    }
    pen.path('frame', `M${bounds[0]},${bounds[1]}H${bounds[2]}V${bounds[3]}H${bounds[0]}Z`)
    pen.write('label', { x: GLOBE.x, y: -1.22 }, 'on the globe')
    pen.write('label', { x: PLANE.x, y: -1.22 }, `as seen from circle ${eye}`)
    const touched = disc === undefined ? [] : disc.circles.map((k) => names[k] as number).sort((a, b) => a - b)
    const told =
      disc === undefined
        ? `In the plane there is no empty disc that touches three circles.`
        : `The empty disc touches circles ${list(touched)}, on the globe and in the plane.`
    return { content: pen.content, told }
  },
}

/** An empty disc that touches three circles, in the plane and on the globe. `circles` are those of the plane. */
interface EmptyDisc {
  readonly circles: readonly number[]
  readonly inPlane: Circle
  readonly onGlobe: Cap
}

/** Everything that an eye at the largest circle sees, once its radius was subtracted from all radii. */
interface Seen {
  /** The circles on the globe; the largest one is a point. */
  readonly caps: readonly Cap[]
  /** The index of the largest circle. */
  readonly eye: number
  /** The circles of the plane, in units of the picture, and the index of each on the globe. */
  readonly circles: readonly Circle[]
  readonly names: readonly number[]
  readonly diagram: Diagram
  readonly discs: readonly EmptyDisc[]
}

/** Exported for tests. */
export function seenFromLargest(scene: Scene, library: CircleVoronoi): Seen {
  const given = capsOf(scene.circles, GLOBE)
  const most = Math.max(...given.map(({ r }) => r))
  const eye = given.findIndex(({ r }) => r === most)
  const caps = given.map(({ center, r }) => ({ center, r: r - most }))
  const { center: place } = caps[eye] as Cap
  const axes = axesAt(place)
  const pictures = caps.map((cap) => pictureOf(cap, place, axes))
  // The eye does not see itself, nor what lies inside its circle.
  const names = [...caps.keys()].filter((i) => i !== eye && pictures[i] !== undefined)
  const seen = names.map((i) => pictures[i] as Circle)
  const box = boundingBox(Float64Array.from(seen.flatMap(({ x, y, r }) => [x, y, Math.abs(r)])))
  const middle = { x: (box.minX + box.maxX) / 2, y: (box.minY + box.maxY) / 2 }
  const scale = (FILLED * 2 * HALF) / Math.max(box.maxX - box.minX, box.maxY - box.minY, 1e-3)
  const circles = seen.map(({ x, y, r }) => ({
    x: PLANE.x + scale * (x - middle.x),
    y: PLANE.y + scale * (y - middle.y),
    r: scale * r,
  }))
  const diagram = library.compute(circles, { weights: true })
  const discs = Array.from({ length: diagram.vertices.length / 3 }, (_, v): EmptyDisc => {
    const [x = 0, y = 0, r = 0] = diagram.vertices.subarray(3 * v, 3 * v + 3)
    const plain = { x: (x - PLANE.x) / scale + middle.x, y: (y - PLANE.y) / scale + middle.y, r: r / scale }
    const touched = [...diagram.triangles.subarray(3 * v, 3 * v + 3)]
    return { circles: touched, inPlane: { x, y, r }, onGlobe: onGlobe(plain, place, axes) }
  })
  return { caps, eye, circles, names, diagram, discs }
}

/** The stereographic projection of a cap from a place; `undefined` for caps that the place hides. */
function pictureOf({ center, r }: Cap, eye: Vector, [right, up]: readonly [Vector, Vector]): Circle | undefined {
  const angle = angleBetween(center, eye)
  if (angle + r <= 1e-9) return undefined
  const [near, far] = [1 / Math.tan((angle - r) / 2), 1 / Math.tan((angle + r) / 2)]
  const direction = Math.atan2(dot(center, up), dot(center, right))
  const middle = (near + far) / 2
  return { x: middle * Math.cos(direction), y: middle * Math.sin(direction), r: (near - far) / 2 }
}

/** The cap whose picture is a circle of the plane. */
function onGlobe({ x, y, r }: Circle, eye: Vector, axes: readonly [Vector, Vector]): Cap {
  const middle = Math.hypot(x, y)
  // The angles of the two ends on the line through the origin.
  const [near, far] = [2 * Math.atan2(1, middle + r), 2 * Math.atan2(1, middle - r)]
  return { center: placeFrom(eye, axes, Math.atan2(y, x), (near + far) / 2), r: (far - near) / 2 }
}

type Box = readonly [minX: number, minY: number, maxX: number, maxY: number]

/** The path of a disc inside a box, in rows. */
function chordsIn({ x, y, r }: Circle, [minX, minY, maxX, maxY]: Box): string {
  const height = (maxY - minY) / ROWS
  return Array.from({ length: ROWS }, (_, row) => {
    const low = minY + row * height
    const half = Math.sqrt(Math.max(r ** 2 - (low + height / 2 - y) ** 2, 0))
    const [from, to] = [Math.max(x - half, minX), Math.min(x + half, maxX)]
    const path = `M${from.toFixed(4)},${low.toFixed(4)}H${to.toFixed(4)}V${(low + height).toFixed(4)}H${from.toFixed(4)}Z`
    return from < to ? path : ''
  }).join('')
}

/** The path of the parts of a circle inside a box. */
function arcsIn({ x, y, r }: Circle, [minX, minY, maxX, maxY]: Box): string {
  let d = ''
  let isOpen = false
  for (let k = 0; k <= 720; k++) {
    const angle = (Math.PI * k) / 360
    const at: Point = { x: x + r * Math.cos(angle), y: y + r * Math.sin(angle) }
    const isIn = at.x >= minX && at.x <= maxX && at.y >= minY && at.y <= maxY
    if (isIn) d += `${isOpen ? 'L' : 'M'}${Number(at.x.toFixed(4))},${Number(at.y.toFixed(4))}`
    isOpen = isIn
  }
  return d
}
