// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError } from '../lib/errors.ts'
import type { Edit } from '../lib/index.ts'
import { compileCircleVoronoi, type LoadOptions } from '../lib/load-options.ts'
import type { Counts, FromPainter, Grid, Hit, Marks, PixelBox, ToPainter } from './protocol.ts'
import type { Style } from './style.ts'

/** What came of circles that were opened, or of edits. */
export interface Edited {
  readonly counts: Counts
  /** The ids of the circles that came, in the order of the edits. */
  readonly inserted: Int32Array
  /** How long it took. */
  readonly seconds: number
}

/** What a view is told of its picture. */
export interface PictureEvents {
  painted(painted: Painted): void
  marked(marks: Marks): void
}

export type Painted = Extract<FromPainter, { kind: 'painted' | 'edited' }>

interface Scene {
  readonly events: PictureEvents
  readonly waiting: Map<number, { resolve(edited: Edited): void; reject(error: unknown): void }>
}

/**
 * The thread that has the diagrams of all views of a page, and paints them. What fails because of it, and not because of what
 * was asked, is an `Error` that is no `CircleVoronoiError`.
 */
export class Painter {
  readonly #worker = new Worker(new URL('./painter/painter-thread.ts', import.meta.url), { type: 'module' })
  readonly #scenes = new Map<number, Scene>()
  readonly #asked = new Map<number, (answer: never) => void>()
  #lastScene = 0
  #lastRequest = 0
  #failure: Error | undefined

  constructor(options: LoadOptions = {}) {
    this.#worker.onmessage = ({ data }: MessageEvent<FromPainter>) => this.#receive(data)
    this.#worker.onerror = (event) => this.#fail(event.message ?? 'its file cannot be loaded')
    compileCircleVoronoi(options).then(
      (module) => this.#post({ kind: 'start', module }),
      (error: Error) => this.#fail(error.message),
    )
  }

  /** A scene for another view. */
  add(events: PictureEvents): PainterScene {
    this.#lastScene += 1
    const scene = this.#lastScene
    this.#scenes.set(scene, { events, waiting: new Map() })
    return new PainterScene(scene, {
      post: (message) => this.#post(message),
      edited: (revision) =>
        new Promise((resolve, reject) => {
          if (this.#failure !== undefined) reject(this.#failure)
          else this.#scenes.get(scene)?.waiting.set(revision, { resolve, reject })
        }),
      ask: (message) =>
        new Promise((resolve) => {
          this.#lastRequest += 1
          this.#asked.set(this.#lastRequest, resolve)
          this.#post({ ...message, request: this.#lastRequest } as ToPainter)
        }),
    })
  }

  /** Ends the thread, and with it all views. */
  dispose(): void {
    this.#fail('it was disposed of')
    this.#worker.terminate()
  }

  #post(message: ToPainter): void {
    this.#worker.postMessage(message)
  }

  #receive(message: FromPainter): void {
    if (message.kind === 'failed') {
      this.#fail(message.message)
      return
    }
    if (message.kind === 'hit') {
      this.#asked.get(message.request)?.(message as never)
      this.#asked.delete(message.request)
      return
    }
    const scene = this.#scenes.get(message.scene)
    if (scene === undefined) return
    if (message.kind === 'marked' || message.kind === 'edited') scene.events.marked(message.marks)
    if (message.kind === 'painted' || message.kind === 'edited') scene.events.painted(message)
    if (message.kind === 'painted' || message.kind === 'marked') return
    const waiting = scene.waiting.get(message.revision)
    scene.waiting.delete(message.revision)
    if (message.kind === 'refused') {
      waiting?.reject(new CircleVoronoiError(message.code, message.circle, message.message))
    } else {
      waiting?.resolve({
        counts: message.counts,
        seconds: message.seconds,
        inserted: message.kind === 'edited' ? message.inserted : new Int32Array(),
      })
    }
  }

  #fail(reason: string): void {
    this.#failure = new Error(`The diagram could not be computed: ${reason}.`)
    for (const { waiting } of this.#scenes.values()) {
      for (const { reject } of waiting.values()) reject(this.#failure)
      waiting.clear()
    }
  }
}

/** How a scene talks to the thread. */
interface Line {
  post(message: ToPainter): void
  edited(revision: number): Promise<Edited>
  ask<Answer>(message: object): Promise<Answer>
}

/** The circles of one view, in the painter's thread. */
export class PainterScene {
  readonly #scene: number
  readonly #line: Line
  #revision = 0

  constructor(scene: number, line: Line) {
    this.#scene = scene
    this.#line = line
  }

  /**
   * Other circles; circle i gets id i.
   *
   * @throws CircleVoronoiError as `compute`; then all stays as it was
   */
  open(circles: Float64Array): Promise<Edited> {
    this.#revision += 1
    this.#line.post({ kind: 'open', scene: this.#scene, revision: this.#revision, circles })
    return this.#line.edited(this.#revision)
  }

  /** @throws CircleVoronoiError as `DiagramEditor.apply`; then all stays as it was */
  edit(edits: readonly Edit[]): Promise<Edited> {
    this.#revision += 1
    this.#line.post({ kind: 'edit', scene: this.#scene, revision: this.#revision, edits })
    return this.#line.edited(this.#revision)
  }

  look(grid: Grid, seen: PixelBox, wanted: PixelBox, style: Style): void {
    this.#line.post({ kind: 'look', scene: this.#scene, grid, seen, wanted, style })
  }

  /** The circle at a point of the plane; `slack`: how near counts as on it. */
  async hit(x: number, y: number, slack: number): Promise<Hit | undefined> {
    const { hit } = await this.#line.ask<{ hit: Hit | undefined }>({ kind: 'hit', scene: this.#scene, x, y, slack })
    return hit
  }

  /** Which circles stand out. */
  mark(selected: number | undefined, hovered: number | undefined): void {
    this.#line.post({ kind: 'mark', scene: this.#scene, selected, hovered })
  }

  close(): void {
    this.#line.post({ kind: 'close', scene: this.#scene })
  }
}
