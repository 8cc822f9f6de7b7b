// SPDX-License-Identifier: GPL-3.0-or-later

import { reasonOf, receivedError } from '../lib/base/errors.ts'
import { loadedOnce } from '../lib/base/loaded-once.ts'
import { Channel, type Functions, type ThreadEvents } from '../lib/threads/channel.ts'
import { startModuleWorker } from '../lib/threads/module-worker.ts'
import { webThread } from '../lib/threads/web-thread.ts'
import { compileCircleVoronoi } from '../lib/wasm/load-options.ts'
import type { CompiledWasm } from '../lib/wasm/wasm.ts'
import { type FigureLoadOptions, type OtherModules, otherModules } from './load.ts'
import { newWorker, THREAD_NAME, threadFile } from './painter-file.ts'
import type { ComputingRequests, PainterEvents, PainterRequests } from './protocol.ts'
import { Failure, Superseded } from './refusal.ts'
import {
  asFailure,
  failureFor,
  isDisposedOf,
  type PictureEvents,
  type Reason,
  SceneClient,
  type SceneThreads,
} from './scene-client.ts'

/**
 * The thread that computes and paints the diagrams of all views of a page. If it crashes, another one gets the state of
 * each view, as in a new page. If that one crashes before it has done anything, the views are told, and the next
 * opening or edit starts another one.
 */
export class Painter {
  readonly #modules: () => Promise<[CompiledWasm, OtherModules]>
  readonly #scenes = new Map<number, SceneClient>()
  #channel: Channel<PainterRequests, PainterEvents> | undefined
  /** A thread that has fitted areas and waits for the next fit, because a drag makes many short ones. */
  #fitter: Channel<ComputingRequests> | undefined
  /** Whether the thread has painted a picture or answered a view. */
  #hasWorked = false
  /** Whether the thread continues after a crash. */
  #isRestarted = false
  #isDisposed = false
  #lastScene = 0
  readonly #threads: SceneThreads = {
    channel: () => this.#channel,
    begin: () => {
      if (this.#isDisposed) throw failureFor(isDisposedOf)
      return this.#channel ?? this.#start(false)
    },
    restart: () => {
      // A result that the user canceled needs no reason.
      this.#end(new Superseded())
      this.#tryToStart(false)
    },
    compute: async (name, args, signal) => {
      const channel = (name === 'fit' && this.#takeFitter()) || this.#openComputing()
      const end = () => channel.end(signal.reason)
      signal.addEventListener('abort', end)
      try {
        const answer = await channel.request(name, args)
        if (name === 'fit' && !channel.isEnded) this.#fitter ??= channel
        return answer
      } finally {
        signal.removeEventListener('abort', end)
        if (channel !== this.#fitter) end()
      }
    },
    worked: () => {
      this.#hasWorked = true
    },
    remove: (scene) => this.#scenes.delete(scene),
  }

  constructor(options: FigureLoadOptions = {}) {
    this.#modules = loadedOnce(() => Promise.all([compileCircleVoronoi(options), otherModules(options)]))
    this.#tryToStart(false)
  }

  /** Adds a scene for another view. */
  add(events: PictureEvents): SceneClient {
    this.#lastScene += 1
    const scene = new SceneClient(this.#lastScene, events, this.#threads)
    this.#scenes.set(this.#lastScene, scene)
    return scene
  }

  /** Terminates the thread, and with it all views. */
  dispose(): void {
    this.#isDisposed = true
    this.#end(failureFor(isDisposedOf))
    this.#fitter?.end(failureFor(isDisposedOf))
    for (const scene of this.#scenes.values()) scene.close()
  }

  /** @throws Failure if threads cannot be started */
  #start(isRestarted: boolean): Channel<PainterRequests, PainterEvents> {
    const channel = this.#open<PainterRequests, PainterEvents>(
      (reason) => {
        if (this.#channel === channel) this.#fail(reason)
      },
      {
        painted: (painted) => {
          this.#hasWorked ||= painted.isWhole
          this.#scenes.get(painted.scene)?.events.painted(painted)
        },
        found: ({ scene, found }) => this.#scenes.get(scene)?.events.found(found),
        outlined: ({ scene, marks }) => this.#scenes.get(scene)?.events.marked(marks),
        failed: ({ scene, error }) => this.#scenes.get(scene)?.events.failed(asFailure(receivedError(error))),
      },
    )
    this.#channel = channel
    this.#hasWorked = false
    this.#isRestarted = isRestarted
    for (const scene of this.#scenes.values()) scene.restore()
    return channel
  }

  /** Opens a channel to a new thread for computations. @throws Failure */
  #openComputing(): Channel<ComputingRequests> {
    const channel = this.#open<ComputingRequests, object>((reason) => channel.end(failureFor(reason)), {})
    return channel
  }

  #takeFitter(): Channel<ComputingRequests> | undefined {
    const fitter = this.#fitter
    this.#fitter = undefined
    return fitter?.isEnded ? undefined : fitter
  }

  /**
   * Opens a channel to a new thread. `onFailure` is called if the thread crashes or cannot be loaded.
   * @throws Failure if threads cannot be started
   */
  #open<Requests extends Functions<Requests> & Pick<PainterRequests, 'start'>, Events extends object>(
    onFailure: (reason: Reason) => void,
    onEvent: { readonly [Name in keyof Events]: (data: Events[Name]) => void },
  ): Channel<Requests, Events> {
    const start = (events: ThreadEvents) => webThread(startModuleWorker(newWorker, threadFile, THREAD_NAME), events)
    try {
      const crash = (cause: unknown) => onFailure((words) => (cause === undefined ? words.noThread : reasonOf(cause)))
      const channel = new Channel<Requests, Events>(start, crash, onEvent)
      this.#modules()
        .then((modules) => channel.request('start', modules as Parameters<Requests['start']>))
        .catch((error) => onFailure(() => reasonOf(error)))
      return channel
    } catch (error) {
      throw failureFor(() => reasonOf(error))
    }
  }

  #fail(reason: Reason): void {
    const isAgain = this.#hasWorked
    // The callers of the rejected requests report a failure at the first start.
    const isTold = isAgain || this.#isRestarted
    this.#end(failureFor(reason))
    const continues = isAgain && this.#tryToStart(true)
    if (!isTold) return
    const failure = new Failure((words) => words[continues ? 'drawingFailed' : 'drawingEnded'](reason(words)))
    for (const { events } of this.#scenes.values()) events.failed(failure)
  }

  /** Starts a thread. Returns false if threads cannot be started: the next opening or edit reports the error. */
  #tryToStart(isRestarted: boolean): boolean {
    try {
      this.#start(isRestarted)
      return true
    } catch {
      return false
    }
  }

  #end(failure: Error): void {
    const channel = this.#channel
    this.#channel = undefined
    channel?.end(failure)
  }
}
