// SPDX-License-Identifier: GPL-3.0-or-later

import { CircleVoronoiError } from '../../lib/base/errors.ts'
import { loadedOnce } from '../../lib/base/loaded-once.ts'
import { type Answers, answerRequests } from '../../lib/threads/answer-requests.ts'
import { type CircleVoronoi, circleVoronoiOf } from '../../lib/wasm/library.ts'
import type { OtherModules } from '../load.ts'
import type { ComputingRequests, PainterEvents, PainterRequests } from '../protocol.ts'
import { answers } from './answers.ts'
import { metricsFor, regionsFrom } from './other-modules.ts'
import { SceneAnswers, type SceneThread } from './scene-answers.ts'
import { Scheduler, type Steps } from './scheduler.ts'
import { computed, traced } from './traced.ts'

type SceneRequest = Exclude<keyof PainterRequests, 'start' | 'add'>

/** The requests for one scene besides questions. */
const SCENE_REQUESTS = ['open', 'edit', 'look', 'layers', 'mark', 'close'] as const
const QUESTIONS = Object.keys(answers) as (keyof typeof answers)[]

/** Answers the requests of a `Painter`. Runs in the thread that calls it. */
export function answerViews(): void {
  const scenes = new Map<number, SceneAnswers>()
  let begin: (library: Promise<CircleVoronoi>) => void
  const library = new Promise<CircleVoronoi>((resolve) => {
    begin = resolve
  })
  let others: OtherModules = {}
  const metrics = loadedOnce(async () => metricsFor(await library, others))
  const regions = loadedOnce(() => regionsFrom(others))
  const scheduler = new Scheduler((end) => {
    for (const scene of scenes.values()) scene.paint(end)
    // A scene may be waiting after another one has used the time.
    return [...scenes.values()].some(({ scene }) => scene.tiles.isWaiting)
  })
  let last: Promise<unknown> = Promise.resolve()
  /** Handles requests in their order, although the first ones wait for the library. */
  const inOrder = <Value>(act: () => Value | Promise<Value>): Promise<Value> => {
    const done = last.then(act)
    last = done.catch(() => {})
    return done
  }
  const sceneOf = (number: number): SceneAnswers => {
    const scene = scenes.get(number)
    if (scene === undefined) throw new CircleVoronoiError('internal', 'The scene has been closed.')
    return scene
  }

  const requests = SCENE_REQUESTS.map((name) => {
    const act = ([number, ...args]: readonly [number, ...unknown[]]) =>
      inOrder(() => {
        const scene = sceneOf(number)
        if (name === 'close') scenes.delete(number)
        return (scene[name] as (...args: readonly unknown[]) => unknown)(...args)
      })
    return [name, act]
  })
  const questions = QUESTIONS.map((name) => {
    const act = async ([number, ...args]: readonly [number, ...unknown[]], { signal }: { signal: AbortSignal }) => {
      const answer = await inOrder(async () => {
        const scene = sceneOf(number)
        // A picture contains all layers.
        if (name === 'svg' || name === 'image') await scene.addMissing()
        return (answers[name] as (...args: readonly unknown[]) => unknown)(scene.scene, ...args)
      })
      const isLong = typeof answer === 'function'
      return isLong ? scheduler.run(sceneOf(number), answer as Steps<unknown>, signal) : answer
    }
    return [name, act]
  })

  const tell = answerRequests<PainterRequests & ComputingRequests, PainterEvents>({
    start: async ([module, given]) => {
      others = given
      begin(circleVoronoiOf(module))
      await library
    },
    add: ([number]) =>
      inOrder(async () => {
        const thread: SceneThread = {
          ...{ scheduler, regions, metrics },
          tell: (event, data, transfer) => tell(event, { scene: number, ...data } as never, transfer),
        }
        scenes.set(number, new SceneAnswers(await library, thread))
      }),
    ...(Object.fromEntries([...requests, ...questions]) as Pick<Answers<PainterRequests>, SceneRequest>),
    compute: async ([circles, , options]) => computed(await library, circles, options),
    trace: async ([circles, ids, options]) => traced(await library, circles, ids, options),
  })
}
