// SPDX-License-Identifier: GPL-3.0-or-later
// Paints cones pixel by pixel. Each circle has a cone with its tip above the center at the height of the radius and a
// slope of 1. The height of a cone over a point is minus the distance from the point to the rim.

/** The viewing direction (0 degrees: from the side, 90: from above), and the rotation of the plane. */
export interface Pose {
  readonly tilt: number
  readonly turn: number
}

/** The six data colors of the tokens: red, green, blue. */
const COLORS = [
  [63, 127, 191],
  [224, 160, 48],
  [60, 154, 124],
  [201, 104, 143],
  [107, 102, 184],
  [217, 104, 60],
] as const
/** The direction of the light: from the left, the front and above. */
const LIGHT = [-0.45, -0.35, 0.82] as const
/** Brightness of the lines between cones and around circles. */
const LINE = 0.35
/** The darkest side is this much darker than the side that faces the light, seen from the side. */
const CONTRAST = 0.5
const DEGREE = Math.PI / 180

/**
 * Returns the image; pixels beside the cones stay transparent.
 * @param view x and y of the middle, and the width
 * @returns red, green, blue and alpha of each pixel
 */
export function paintCones(
  circles: readonly (readonly number[])[],
  view: readonly number[],
  { tilt, turn }: Pose,
  width: number,
  height: number,
): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(4 * width * height)
  const [middleX = 0, middleY = 0, span = 1] = view
  const scale = width / span
  const [sin, cos] = [Math.sin(tilt * DEGREE), Math.cos(tilt * DEGREE)]
  const [turnX, turnY] = [Math.cos(turn * DEGREE), Math.sin(turn * DEGREE)]
  const cones = circles.map(([x = 0, y = 0, r = 0]) => ({
    u: (x - middleX) * turnX - (y - middleY) * turnY,
    v: (x - middleX) * turnY + (y - middleY) * turnX,
    r,
  }))
  // Shifts the mean height to the middle of the picture.
  const lift = cos * ((0.35 * height) / 2 / scale)
  /** The parts seen in the row above: 2 i on cone i, 2 i + 1 on its part above the ground, -1 beside all cones. */
  const above = new Int32Array(width).fill(-1)

  for (let row = 0; row < height; row++) {
    const s = (height / 2 - row - 0.5) / scale - lift
    const rays = cones.map((cone) => rayAt(cone, s, sin, cos))
    let beside = -1
    for (let column = 0; column < width; column++) {
      const u = (column + 0.5 - width / 2) / scale
      let t = Number.POSITIVE_INFINITY
      let first = -1
      for (let i = 0; i < cones.length; i++) {
        const own = entry(cones[i] as Cone, rays[i] as Ray, u)
        if (own >= t) continue
        t = own
        first = i
      }
      const isInside = s * cos - t * sin >= 0
      const part = first < 0 ? -1 : 2 * first + (isInside ? 1 : 0)
      const up = above[column] as number
      const isLine = (beside >= 0 && beside !== part) || (up >= 0 && up !== part)
      beside = part
      above[column] = part
      if (first < 0) continue
      const cone = cones[first] as Cone
      const [du, dv] = [u - cone.u, s * sin + t * cos - cone.v]
      const d = Math.sqrt(du * du + dv * dv) || 1
      // The surface has slope 1, so its normal leans outward by 45 degrees.
      const bright = ((du / d) * LIGHT[0] + (dv / d) * LIGHT[1] + LIGHT[2]) * Math.SQRT1_2
      const shade = (1 - CONTRAST * (1 - bright) * cos) * (isLine ? LINE : 1)
      const color = COLORS[first % COLORS.length] as (typeof COLORS)[number]
      const white = isInside ? 0 : 0.62
      const k = 4 * (row * width + column)
      for (let c = 0; c < 3; c++) pixels[k + c] = ((color[c] as number) * (1 - white) + 250 * white) * shade
      pixels[k + 3] = 255
    }
  }
  return pixels
}

interface Cone {
  readonly u: number
  readonly v: number
  readonly r: number
}

/**
 * The rays through the height s of the picture, v = s sin + t cos and z = s cos - t sin, seen from a cone. A ray meets
 * the cone where (z - r)^2 is the square of the distance from the axis, k t^2 - 2 m t + c - (u - cone.u)^2 = 0, and
 * where z <= r.
 */
interface Ray {
  readonly k: number
  readonly m: number
  readonly c: number
  /** The t of z = r. */
  readonly least: number
}

function rayAt({ v, r }: Cone, s: number, sin: number, cos: number): Ray {
  const [depth, dv] = [s * cos - r, s * sin - v]
  const least = sin > 0 ? depth / sin : depth > 0 ? Number.POSITIVE_INFINITY : Number.NEGATIVE_INFINITY
  return { k: sin * sin - cos * cos, m: depth * sin + dv * cos, c: depth * depth - dv * dv, least }
}

/** The t where a ray enters a cone, which goes down without end; infinite if it does not. */
function entry(cone: Cone, { k, m, c, least }: Ray, u: number): number {
  const rest = c - (u - cone.u) * (u - cone.u)
  const square = m * m - k * rest
  if (square < 0) return Number.POSITIVE_INFINITY
  const root = Math.sqrt(square)
  // The same root in both forms. Each has no cancellation, and the first stays finite where k is 0.
  const t = m < 0 ? rest / (m - root) : (m + root) / k
  return t >= least ? t : Number.POSITIVE_INFINITY
}
