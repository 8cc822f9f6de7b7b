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
/** Darkness of the lines between cones and around circles. */
const LINE = 0.35
/** Samples per row of pixels along each ray from front to back. */
const FINENESS = 1.6
const DEGREE = Math.PI / 180

/**
 * Returns the image; pixels behind the cones stay transparent.
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
  const [reach, depth] = [span / 2, (span / 2) * (height / width)]
  const steps = Math.ceil(height * FINENESS)
  /** The cone seen in the previous column of pixels, and whether inside its circle. */
  const beside = new Int32Array(steps)
  // Shifts the mean height to the middle of the picture.
  const lift = cos * (depth * 0.35)

  for (let column = 0; column < width; column++) {
    const u = (column + 0.5) / scale - reach
    let top = height
    let before = -1
    /** Whether the ray has crossed a line since the last pixel. */
    let isLine = false
    for (let step = 0; step < steps && top > 0; step++) {
      const v = -depth + (2 * depth * (step + 0.5)) / steps
      let z = Number.NEGATIVE_INFINITY
      let nearest = 0
      for (let i = 0; i < cones.length; i++) {
        const cone = cones[i] as (typeof cones)[number]
        const [du, dv] = [u - cone.u, v - cone.v]
        const own = cone.r - Math.sqrt(du * du + dv * dv)
        if (own > z) [z, nearest] = [own, i]
      }
      const row = Math.floor(height / 2 - (v * sin + z * cos + lift) * scale)
      const isInside = z >= 0
      const part = 2 * nearest + (isInside ? 1 : 0)
      isLine ||= (before >= 0 && part !== before) || (column > 0 && part !== beside[step])
      before = part
      beside[step] = part
      if (row >= top) continue
      const cone = cones[nearest] as (typeof cones)[number]
      const d = Math.hypot(u - cone.u, v - cone.v) || 1
      // The surface has slope 1, so its normal leans outward by 45 degrees.
      const bright =
        ((u - cone.u) / d) * LIGHT[0] * Math.SQRT1_2 +
        ((v - cone.v) / d) * LIGHT[1] * Math.SQRT1_2 +
        LIGHT[2] * Math.SQRT1_2
      const shade = 1 + (bright - 0.58) * 0.9 * cos
      const color = COLORS[nearest % COLORS.length] as (typeof COLORS)[number]
      const white = isInside ? 0 : 0.62
      for (let y = Math.max(row, 0); y < top; y++) {
        const k = 4 * (y * width + column)
        for (let c = 0; c < 3; c++) {
          const own = (color[c] as number) * (1 - white) + 250 * white
          pixels[k + c] = own * shade * (isLine ? LINE : 1)
        }
        pixels[k + 3] = 255
      }
      top = Math.max(row, 0)
      isLine = false
    }
  }
  return pixels
}
