// SPDX-License-Identifier: GPL-3.0-or-later
// The answers to questions about a scene.
import { NONE } from '../../lib/base/diagram-data.ts'
import { CircleVoronoiError } from '../../lib/base/errors.ts'
import type { Questions } from '../protocol.ts'
import { distributionOf } from './distribution.ts'
import { CanvasDrawing } from './drawing.ts'
import { factsOf } from './facts.ts'
import type { PaintedScene } from './painted-scene.ts'
import { tabulated, tabulatedAll } from './tabulate.ts'
import { touchingAround, touchingNear } from './touching.ts'
import { traced } from './traced.ts'
import { trialOf } from './trial.ts'

/** What takes long is answered in steps. */
export type Steps<Value> = () => Generator<void, Value>
/** A function for each question. */
type Answers = {
  readonly [Name in keyof Questions]: (
    scene: PaintedScene,
    ...args: Parameters<Questions[Name]>
  ) => ReturnType<Questions[Name]> | Steps<ReturnType<Questions[Name]>>
}

export const answers = {
  hit: (scene, x, y, slack) => scene.hit(x, y, slack),
  legend: (scene) => scene.picture.legend,
  touch(scene, x, y, slack) {
    const { diagram } = scene.picture
    const box = { minX: x - slack, minY: y - slack, maxX: x + slack, maxY: y + slack }
    const near = touchingNear(diagram, scene.picture.circlesIn(box), x, y, slack)
    if (near !== undefined) return near
    const id = scene.nearest(x, y)
    return id < 0 ? undefined : touchingAround(diagram, diagram.indexOf(id), x, y)
  },
  try({ library, picture, nearest, outlineOf }, circle) {
    const id = nearest(circle.x, circle.y)
    try {
      const index = id < 0 ? NONE : picture.diagram.indexOf(id)
      return trialOf(library, picture, circle, index, (local, i) => outlineOf([i], local))
    } catch (error) {
      if (error instanceof CircleVoronoiError) return undefined
      throw error
    }
  },
  svg: (scene, ...given) => drawn(() => scene.svg(...given)),
  image: (scene, frame, ...given) =>
    drawn(() => {
      const canvas = new OffscreenCanvas(frame.width, frame.height)
      const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D
      scene.draw(new CanvasDrawing(context), frame, ...given)
      return canvas.transferToImageBitmap()
    }),
  measure: (scene) => () => distributionOf(scene.picture),
  tabulate: (scene, columns, ids) =>
    ids === undefined ? () => tabulatedAll(scene.picture, columns) : tabulated(scene.picture, columns, ids),
  tell: (scene, ids) => factsOf(scene.picture, scene.counts(), ids),
  compute({ library, picture }, options) {
    try {
      const { stats, certificate } = library.compute(picture.diagram.circles, options)
      return { stats, certificate }
    } catch (error) {
      if (!(error instanceof CircleVoronoiError)) throw error
      return { problem: error.message }
    }
  },
  trace: ({ library, picture }, options) => traced(library, picture.diagram, options),
} satisfies Answers

/** `undefined`: it is too large for a canvas, or for the memory; other scenes go on. */
function drawn<Drawn>(draw: () => Drawn): Drawn | undefined {
  try {
    return draw()
  } catch {
    return undefined
  }
}
