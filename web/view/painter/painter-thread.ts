// SPDX-License-Identifier: GPL-3.0-or-later

import { loadedOnce } from '../../lib/base/loaded-once.ts'
import { type Answers, answerRequests } from '../../lib/threads/answer-requests.ts'
import { type CircleVoronoi, circleVoronoiOf } from '../../lib/wasm/library.ts'
import type { OtherModules } from '../load.ts'
import type { ComputingRequests, PainterEvents, PainterRequests } from '../protocol.ts'
import { answers } from './answers.ts'
import { fitted } from './fitted.ts'
import { metricsFor, regionsFrom } from './other-modules.ts'
import { SceneAnswers, type SceneThread } from './scene-answers.ts'
import { Scheduler, type Steps } from './scheduler.ts'
import { computed, traced } from './traced.ts'

type SceneRequest = Exclude<keyof PainterRequests, 'start' | 'add' | 'close'>

/** The requests for one scene besides questions. */
const SCENE_REQUESTS = ['open', 'edit', 'look', 'layers', 'mark'] as const
const QUESTIONS = Object.keys(answers) as (keyof typeof answers)[]
const isQuestion = (name: SceneRequest): name is keyof typeof answers => name in answers

/** Answers the requests of a `Painter`. Runs in the thread that calls it. */
export function answerViews(): void {
  const scenes = new Map<number, SceneAnswers>()
  let begin: (library: Promise<CircleVoronoi>) => void
  const library = new Promise<CircleVoronoi>((resolve) => {
    begin = resolve
  })
  let others: OtherModules = {}
  const metrics = loadedOnce(async () => metricsFor(await library, others))
  const regions = loadedOnce(async () => {
    await library
    return regionsFrom(others)
  })
  const scheduler = new Scheduler((end) => {
    let isLeft = false
    // A scene may be waiting after another one has used the time.
    for (const scene of scenes.values()) isLeft = scene.paint(end) || isLeft
    return isLeft
  })
  let last: Promise<unknown> = Promise.resolve()
  /** Handles requests in their order, although the first ones wait for the library. */
  const inOrder = <Value>(act: () => Value | Promise<Value>): Promise<Value> => {
    const done = last.then(act)
    last = done.catch(() => {})
    return done
  }
  const answersByName = [...SCENE_REQUESTS, ...QUESTIONS].map((name) => {
    const answer = async ([number, ...args]: readonly [number, ...unknown[]], { signal }: { signal: AbortSignal }) => {
      const found = await inOrder(async () => {
        const scene = scenes.get(number) as SceneAnswers
        // A picture contains all layers.
        if (name === 'svg' || name === 'image') await scene.addMissing()
        return isQuestion(name)
          ? (answers[name] as (...args: readonly unknown[]) => unknown)(scene.scene, ...args)
          : (scene[name] as (...args: readonly unknown[]) => unknown)(...args)
      })
      // Later requests do not wait for long work.
      return typeof found === 'function' ? scheduler.run(scenes.get(number), found as Steps<unknown>, signal) : found
    }
    return [name, answer]
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
          scheduler,
          regions,
          metrics,
          tell: (event, data, transfer) => tell(event, { scene: number, ...data } as never, transfer),
        }
        scenes.set(number, new SceneAnswers(await library, thread))
      }),
    close: ([number]) =>
      inOrder(() => {
        scenes.get(number)?.close()
        scenes.delete(number)
      }),
    ...(Object.fromEntries(answersByName) as Pick<Answers<PainterRequests>, SceneRequest>),
    compute: async (args) => computed(await library, ...args),
    fit: async (args) => fitted(await regions(), ...args),
    trace: async (args) => traced(await library, ...args),
  })
}
