// SPDX-License-Identifier: GPL-3.0-or-later

import { postedError } from '../../lib/base/errors.ts'
import type { Edit } from '../../lib/index.ts'
import { transferring } from '../../lib/threads/answer-requests.ts'
import type { CircleVoronoi } from '../../lib/wasm/library.ts'
import type { Metrics } from '../../lib/wasm/metrics.ts'
import type { Regions } from '../../lib/wasm/regions.ts'
import type { KeptIds } from '../circle-table.ts'
import type { PaintedLayers } from '../layers.ts'
import type {
  DomainChange,
  EditedPicture,
  Highlights,
  Opened,
  PainterEvents,
  PaintRequest,
  Patch,
} from '../protocol.ts'
import type { Style } from '../style.ts'
import { PaintedScene } from './painted-scene.ts'
import type { Scheduler } from './scheduler.ts'

/** Pause after the last edit before long computations, in milliseconds. */
const REST = 120
/** The number of an opening for circles that may differ from the confirmed ones. No edit has it. */
const UNKNOWN = -1

/** The parts of the thread that all scenes share. */
export interface SceneThread {
  readonly scheduler: Scheduler
  readonly regions: () => Promise<Regions>
  readonly metrics: () => Promise<Metrics>
  tell<Name extends keyof PainterEvents>(
    event: Name,
    data: Omit<PainterEvents[Name], 'scene'>,
    transfer?: readonly Transferable[],
  ): void
}

/** Answers the requests for one scene. */
export class SceneAnswers {
  readonly scene: PaintedScene
  readonly #thread: SceneThread
  /** Identifies the current circles. Edits for other circles are void. */
  #opening = 0
  #rest: ReturnType<typeof setTimeout> | undefined
  /** Aborted when the global results that are being computed are outdated. */
  #finding = new AbortController()

  constructor(library: CircleVoronoi, thread: SceneThread) {
    this.scene = new PaintedScene(library)
    this.#thread = thread
  }

  async open(opening: number, circles: Float64Array, kept: KeptIds | undefined, change: DomainChange): Promise<Opened> {
    const { scene } = this
    const opened = await this.#change(change, (regions) => scene.open(circles, change, regions, kept))
    this.#opening = opening
    this.#thread.scheduler.restart(this)
    this.#thread.scheduler.schedule()
    this.#findAtRest()
    return { counts: scene.counts(), ...opened }
  }

  async edit(opening: number, edits: readonly Edit[], change: DomainChange): Promise<EditedPicture | undefined> {
    if (opening !== this.#opening) return undefined
    const { scene } = this
    return this.#change(change, (regions) => {
      const edited = scene.edit(edits, change, regions)
      const { patches, found } = edited
      if (scene.tiles.isWaiting) this.#thread.scheduler.schedule()
      if (found === undefined || scene.isPowerMissing || scene.isMethodMissing) this.#findAtRest()
      else this.#stopFinding()
      const grid = scene.tiles.viewport?.grid.id ?? -1
      const picture = { kind: 'edited', grid, counts: scene.counts(), marks: scene.marks(), ...edited } as const
      return transferring(picture, bitmapsOf(patches))
    })
  }

  /** Changes the circles. After an unexpected error, they may differ, and the view opens the confirmed ones again. */
  async #change<Changed>(change: DomainChange, act: (regions: Regions | undefined) => Changed): Promise<Changed> {
    const regions = await this.#regionsFor(change)
    try {
      return act(regions)
    } catch (error) {
      if (postedError(error).code === 'internal') this.#opening = UNKNOWN
      throw error
    }
  }

  look(request: PaintRequest, style: Style): void {
    const { scene } = this
    const { isElsewhere, isOtherScale } = scene.look({ ...request, style })
    this.#thread.scheduler.schedule()
    // Outlines are clipped to the viewport and have its precision.
    if (isElsewhere) this.#tellOutlines()
    if (isOtherScale && scene.isPathFound) this.#tellFound()
  }

  layers(layers: PaintedLayers, isPainted: boolean): void {
    this.scene.setLayers(layers, isPainted)
    // A layer limits cells.
    if (isPainted) this.#tellOutlines()
    this.#tellFound()
  }

  mark(selected: number | undefined, hovered: number | undefined): Highlights {
    return this.scene.mark(selected, hovered)
  }

  close(): void {
    this.#stopFinding()
    this.scene.dispose()
  }

  /** Paints tiles until a time of `performance.now()`, and returns whether tiles are left. */
  paint(end: number): boolean {
    const { tiles } = this.scene
    const patches: Patch[] = []
    try {
      while (tiles.isWaiting && performance.now() < end) patches.push(...tiles.paintNext())
    } catch (error) {
      // Other tiles would fail, too.
      tiles.stop()
      this.#fail(error)
    }
    const { viewport } = tiles
    if (viewport !== undefined && patches.length > 0) {
      const { grid, paintId } = viewport
      const painted = { kind: 'painted', grid: grid.id, patches, paintId, isWhole: !tiles.isWaiting } as const
      this.#thread.tell('painted', painted, bitmapsOf(patches))
    }
    return tiles.isWaiting
  }

  /** Computes the visible layers of the method and of the power diagram. */
  async addMissing(): Promise<void> {
    this.#addMethod()
    const { scene } = this
    if (!scene.isPowerMissing) return
    const metrics = await this.#thread.metrics().catch(() => undefined)
    // A module that fails to load leaves its layer empty. The next attempt may succeed.
    if (metrics === undefined || !scene.isPowerMissing) return
    scene.addPower(metrics)
    this.#thread.scheduler.schedule()
  }

  /** The module for clipping, loaded on demand. */
  async #regionsFor({ region }: DomainChange): Promise<Regions | undefined> {
    return (region ?? undefined) && this.#thread.regions()
  }

  #tellOutlines(): void {
    if (this.scene.isAnythingMarked) this.#thread.tell('outlined', { marks: this.scene.marks() })
  }

  /** Fast searches follow while an end of the path is dragged. */
  #tellFound(): void {
    const { scene } = this
    if (scene.isFoundQuickly && !scene.isPowerMissing && !scene.isMethodMissing) {
      this.#stopFinding()
      this.#thread.tell('found', { found: scene.find() })
    } else {
      this.#findAtRest()
    }
  }

  /** Runs long computations once nothing has been edited for a while. */
  #findAtRest(): void {
    this.#stopFinding()
    this.#finding = new AbortController()
    const { signal } = this.#finding
    const fail = (error: unknown) => signal.aborted || this.#fail(error)
    this.#rest = setTimeout(() => this.#find(signal).catch(fail), REST)
  }

  /** Stops a search that has begun, whose results would be older than those of the view. */
  #stopFinding(): void {
    clearTimeout(this.#rest)
    this.#finding.abort()
  }

  #addMethod(): void {
    if (!this.scene.isMethodMissing) return
    this.scene.addMethod()
    this.#thread.scheduler.schedule()
  }

  async #find(signal: AbortSignal): Promise<void> {
    this.#addMethod()
    const { scene } = this
    if (scene.isAnythingToFind) {
      const found = await this.#thread.scheduler.run(this, () => scene.findInSteps(), signal)
      this.#thread.tell('found', { found })
    }
    await this.addMissing()
  }

  #fail(error: unknown): void {
    this.#thread.tell('failed', { error: postedError(error) })
  }
}

function bitmapsOf(patches: readonly Patch[]): readonly ImageBitmap[] {
  return patches.map(({ image }) => image)
}
