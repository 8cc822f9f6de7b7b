// SPDX-License-Identifier: GPL-3.0-or-later
// The answers to questions about a scene.
import { NONE } from '../../lib/base/diagram-data.ts'
import { CircleVoronoiError } from '../../lib/base/errors.ts'
import type { Point } from '../../lib/index.ts'
import { transferring } from '../../lib/threads/answer-requests.ts'
import type { Questions, Touching } from '../protocol.ts'
import { distributionOf } from './distribution.ts'
import { CanvasDrawing } from './drawing.ts'
import { factsOf } from './facts.ts'
import type { PaintedScene } from './painted-scene.ts'
import { roomNear } from './room.ts'
import type { Steps } from './scheduler.ts'
import { tabulated, tabulatedAll } from './tabulate.ts'
import { touchingAround, touchingNear } from './touching.ts'
import { trialOf } from './trial.ts'

/** A function for each question. Long answers are computed in steps. */
type QuestionAnswers = {
  readonly [Name in keyof Questions]: (
    scene: PaintedScene,
    ...args: Parameters<Questions[Name]>
  ) => ReturnType<Questions[Name]> | Steps<ReturnType<Questions[Name]>>
}

export const answers = {
  room({ picture }, x, y) {
    const home = picture.home(x, y)
    return roomNear(picture.diagram, home.x, home.y)
  },
  legend: (scene) => scene.picture.legend,
  touch(scene, x, y, slack) {
    const { diagram } = scene.picture
    const home = scene.picture.home(x, y)
    const box = { minX: home.x - slack, minY: home.y - slack, maxX: home.x + slack, maxY: home.y + slack }
    const near = touchingNear(diagram, scene.picture.circlesIn(box), home.x, home.y, slack)
    const back = { x: x - home.x, y: y - home.y }
    if (near !== undefined) return movedBy(near, back)
    const id = scene.nearest(x, y)
    return id < 0 ? undefined : movedBy(touchingAround(diagram, diagram.indexOf(id), home.x, home.y), back)
  },
  try({ library, picture, nearest, outlineOf }, circle) {
    // A circle may take area from its own images, which a preview does not cover.
    if (picture.torus !== undefined) return undefined
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
      const image = canvas.transferToImageBitmap()
      return transferring(image, [image])
    }),
  measure: (scene) => () => distributionOf(scene.picture),
  tabulate: (scene, columns, ids) =>
    ids === undefined ? () => tabulatedAll(scene.picture, columns) : tabulated(scene.picture, columns, ids),
  tell: (scene, ids) => factsOf(scene.picture, scene.counts(), ids),
} satisfies QuestionAnswers

function movedBy<Touched extends Touching | undefined>(touching: Touched, { x, y }: Point): Touched {
  if (touching === undefined || (x === 0 && y === 0)) return touching
  const { disc, points } = touching
  return {
    ...touching,
    disc: { ...disc, x: disc.x + x, y: disc.y + y },
    points: points.map((point) => ({ x: point.x + x, y: point.y + y })),
  }
}

/** Returns `undefined` if drawing fails, as where a picture exceeds the canvas size or the memory. */
function drawn<Drawn>(draw: () => Drawn): Drawn | undefined {
  try {
    return draw()
  } catch {
    return undefined
  }
}
