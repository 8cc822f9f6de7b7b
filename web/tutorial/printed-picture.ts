// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the result of the paper's rules as printed, as SVG.
import { cameraOf } from '../editing/scene-link.ts'
import { type Box, clipCurve, type EdgeCurve, SvgPath, traceArc } from '../lib/index.ts'
import type { LinkView } from '../lib/link.ts'
import { boundingBox, type Camera, fitted, type Size } from '../view/camera.ts'
import type { Arrow, Comparison } from './printed-rules.ts'

export { compare, loadPrintedRules, sentenceOf } from './printed-rules.ts'

/** Margin around all circles in pixels, the same as in a figure without buttons. */
const MARGIN = 16
/** Length of arrow heads, in pixels. */
const HEAD = 8

/** The camera of a figure that shows a view, or all circles. */
export function lookAt(circles: Float64Array, view: LinkView | undefined, size: Size): Camera {
  if (view !== undefined) return cameraOf(view, size)
  return fitted(boundingBox(circles), size, { top: MARGIN, right: MARGIN, bottom: MARGIN, left: MARGIN })
}

/** Returns the attribute `viewBox` and the contents of the SVG for a camera. */
export function pictureOf(circles: Float64Array, comparison: Comparison, camera: Camera, { width, height }: Size) {
  const [reachX, reachY] = [width / 2 / camera.scale, height / 2 / camera.scale]
  const box = { minX: camera.x - reachX, minY: camera.y - reachY, maxX: camera.x + reachX, maxY: camera.y + reachY }
  const { found, wrong, missing, leftover } = comparison
  const arrows = (isRight: boolean) => leftover.filter((arrow) => arrow.isRight === isRight)
  const layers = [
    ['discs', discs(circles)],
    ['missing', lines(missing, box, camera)],
    ['found', lines(found, box, camera)],
    ['wrong', lines(wrong, box, camera)],
    ['arrows', heads(arrows(true), camera)],
    ['lost', heads(arrows(false), camera)],
  ]
  // The plane is y-up and SVG is y-down.
  const paths = layers.map(([name, path]) => `<path class="${name}" d="${path}"/>`).join('')
  return {
    viewBox: `${box.minX} ${-box.maxY} ${box.maxX - box.minX} ${box.maxY - box.minY}`,
    content: `<g transform="scale(1,-1)">${paths}</g>`,
  }
}

function discs(circles: Float64Array): string {
  const path = new SvgPath()
  for (let i = 0; i < circles.length; i += 3) {
    const [x, y, r] = circles.subarray(i, i + 3) as unknown as [number, number, number]
    path.moveTo(x + r, y)
    path.arc(x, y, r, 0, 2 * Math.PI, true)
  }
  return `${path}`
}

/** Flattens curves to line segments as exactly as the eye can tell. */
function lines(curves: readonly EdgeCurve[], box: Box, { scale }: Camera): string {
  const path = new SvgPath()
  for (const arc of curves.flatMap((curve) => clipCurve(curve, { bounds: box }))) {
    path.moveTo(arc.start.x, arc.start.y)
    traceArc(path, arc, 0.1 / scale)
  }
  return `${path}`
}

function heads(arrows: readonly Arrow[], { scale }: Camera): string {
  const path = new SvgPath()
  for (const { from, to } of arrows) {
    const [x, y] = [to.x - from.x, to.y - from.y]
    const size = Math.hypot(x, y)
    path.moveTo(from.x, from.y)
    path.lineTo(to.x, to.y)
    if (size === 0) continue
    const [u, v] = [(x / size) * (HEAD / scale), (y / size) * (HEAD / scale)]
    path.moveTo(to.x - u - v / 2, to.y - v + u / 2)
    path.lineTo(to.x, to.y)
    path.lineTo(to.x - u + v / 2, to.y - v - u / 2)
  }
  return `${path}`
}
