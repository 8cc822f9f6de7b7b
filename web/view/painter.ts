// SPDX-License-Identifier: GPL-3.0-or-later

import { reasonOf } from '../lib/base/errors.ts'
import { startModuleWorker } from '../lib/threads/module-worker.ts'
import { compileCircleVoronoi } from '../lib/wasm/load-options.ts'
import { type FigureLoadOptions, otherModules } from './load.ts'
import { newWorker, THREAD_NAME, threadFile } from './painter-file.ts'
import type { FromPainter, InProgress, Questions, ToPainter } from './protocol.ts'
import { Failure, Superseded } from './refusal.ts'
import { RemoteCalls } from './remote-calls.ts'
import {
  failureFor,
  isDisposedOf,
  type PictureEvents,
  type Reason,
  SceneClient,
  type SceneThread,
} from './scene-client.ts'

/** The state that a thread starts with: none, everything that its predecessor had, or only circles and viewport. */
type Beginning = 'new' | 'restored' | 'bare'

/**
 * The thread that computes and paints the diagrams of all views of a page. A failure of the thread itself, as opposed
 * to a refused request, is an `Error` that is not a `CircleVoronoiError`. Nothing has changed then, and a new thread
 * takes over: at once, or at the next opening or edit if the failed thread never worked.
 * A new thread receives the circles, the layers and the viewport, but not the work during which the former one failed,
 * because the work may fail again. If the new thread fails before it has done anything, its successor receives only the
 * circles and the viewport. If that one fails too, there is no other.
 */
export class Painter {
  readonly #options: FigureLoadOptions
  readonly #scenes = new Map<number, SceneClient>()
  readonly #questions = new RemoteCalls<Questions>()
  #worker: Worker | undefined
  /** Whether the thread has completed any request. */
  #hasWorked = false
  #beginning: Beginning = 'new'
  #isDisposed = false
  #lastScene = 0
  readonly #thread: SceneThread = {
    questions: this.#questions,
    isRunning: () => this.#worker !== undefined,
    begin: () => {
      if (this.#worker === undefined && !this.#isDisposed) this.#start()
      return !this.#isDisposed
    },
    restart: () => {
      // A result that the user canceled needs no reason.
      this.#stop(new Superseded())
      this.#start()
    },
    post: (message) => this.#worker?.postMessage(message),
    remove: (scene) => this.#scenes.delete(scene),
  }

  constructor(options: FigureLoadOptions = {}) {
    this.#options = options
    this.#start()
  }

  /** Adds a scene for another view. */
  add(events: PictureEvents): SceneClient {
    this.#lastScene += 1
    const scene = new SceneClient(this.#lastScene, events, this.#thread)
    this.#scenes.set(this.#lastScene, scene)
    return scene
  }

  /** Terminates the thread, and with it all views. */
  dispose(): void {
    this.#isDisposed = true
    this.#stop(failureFor(isDisposedOf))
  }

  #start(beginning: Beginning = 'new'): void {
    let worker: Worker
    try {
      worker = startModuleWorker(newWorker, threadFile, THREAD_NAME)
    } catch (error) {
      this.#stop(failureFor(() => reasonOf(error)))
      return
    }
    this.#worker = worker
    this.#hasWorked = false
    this.#beginning = beginning
    const fail = (reason: Reason, during?: InProgress) => {
      if (this.#worker === worker) this.#fail(reason, during)
    }
    worker.onmessage = ({ data }: MessageEvent<FromPainter>) => {
      if (data.kind === 'failed') fail(() => data.message, data.during)
      else if (this.#worker === worker) this.#receive(data)
    }
    worker.onerror = ({ message }) => fail((words) => message ?? words.noThread)
    Promise.all([compileCircleVoronoi(this.#options), otherModules(this.#options)]).then(
      ([module, others]) => worker.postMessage({ kind: 'start', module, others } satisfies ToPainter),
      (error: Error) => fail(() => reasonOf(error)),
    )
    for (const scene of this.#scenes.values()) scene.restore()
  }

  #receive(message: Exclude<FromPainter, { kind: 'failed' }>): void {
    if (message.kind === 'answer') {
      this.#hasWorked = true
      this.#questions.receive(message)
    } else if (this.#scenes.get(message.scene)?.receive(message)) this.#hasWorked = true
  }

  #fail(reason: Reason, during?: InProgress): void {
    const next = this.#hasWorked ? 'restored' : this.#beginning === 'restored' ? 'bare' : undefined
    const isFirst = !this.#hasWorked && this.#beginning === 'new'
    this.#stop(failureFor(reason))
    // The callers of the rejected requests report the failure.
    if (isFirst) return
    const lost = [...this.#scenes.values()].map(
      (scene) => [scene, scene.forgetCause(during, next !== 'restored')] as const,
    )
    if (next !== undefined) this.#start(next)
    const failure = new Failure((words) => words[next ? 'drawingFailed' : 'drawingEnded'](reason(words)))
    for (const [scene, what] of lost) scene.fail(failure, what)
  }

  #stop(failure: Error): void {
    this.#worker?.terminate()
    this.#worker = undefined
    for (const scene of this.#scenes.values()) scene.leave(failure)
  }
}
