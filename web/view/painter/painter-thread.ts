// SPDX-License-Identifier: GPL-3.0-or-later

import { CircleVoronoiError, postedError, reasonOf } from '../../lib/base/errors.ts'
import { loadedOnce } from '../../lib/base/loaded-once.ts'
import { type CircleVoronoi, circleVoronoiOf } from '../../lib/wasm/library.ts'
import type { Regions } from '../../lib/wasm/regions.ts'
import type { OtherModules } from '../load.ts'
import type { DomainChange, FromPainter, InProgress, Patch, ToPainter } from '../protocol.ts'
import { answers, type Steps } from './answers.ts'
import { metricsFor, regionsFrom } from './other-modules.ts'
import { PaintedScene } from './painted-scene.ts'

/** Time slice for painting, in milliseconds, before the thread handles messages. */
const SLICE = 8
/** Pause after the last edit before long computations, in milliseconds. */
const REST = 120

const port = globalThis as unknown as {
  onmessage: (event: MessageEvent<ToPainter>) => void
  postMessage(message: FromPainter, transfer?: Transferable[]): void
}

let begin: (library: CircleVoronoi | Promise<CircleVoronoi>) => void
const library = new Promise<CircleVoronoi>((resolve) => {
  begin = resolve
})
const scenes = new Map<number, PaintedScene>()
/** A measurement in steps. `begin` restarts it, for example after an opening. */
interface Measuring {
  readonly scene: PaintedScene
  readonly begin: () => Generator<void, FromPainter>
  steps: Generator<void, FromPainter>
}
let measuring: Measuring[] = []
let others: OtherModules = {}
const metrics = loadedOnce(async () => metricsFor(await library, others))
const regions = loadedOnce(() => regionsFrom(others))
let rest: ReturnType<typeof setTimeout> | undefined
let isPainting = false
/** Yields to messages that have arrived. */
const pause = new MessageChannel()

/** Answers the `Painter` of a page. Runs in the thread that calls it. */
export function answerViews(): void {
  pause.port1.onmessage = paintSlice
  // Handles messages in order, although the first ones wait for the library.
  let last: Promise<void> = Promise.resolve()
  port.onmessage = ({ data }) => {
    if (data.kind === 'start') {
      others = data.others
      begin(circleVoronoiOf(data.module))
    } else last = last.then(() => answer(data)).catch((error) => fail(error, data))
  }
}

async function answer(message: Exclude<ToPainter, { kind: 'start' }>): Promise<void> {
  if (message.kind === 'add') {
    scenes.set(message.scene, new PaintedScene(await library))
    return
  }
  const scene = scenes.get(message.scene)
  if (scene === undefined) return
  switch (message.kind) {
    case 'open':
      try {
        const opened = scene.open(message.circles, message, await regionsFor(message), message.kept)
        scene.opening = message.opening
        for (const waiting of measuring) if (waiting.scene === scene) waiting.steps = waiting.begin()
        post({
          kind: 'opened',
          scene: message.scene,
          revision: message.revision,
          counts: scene.counts(),
          ...opened,
        })
        schedule()
        findAtRest()
      } catch (error) {
        refuse(message.scene, message.revision, error)
      }
      return
    case 'edit':
      if (message.opening !== scene.opening) {
        post({ kind: 'superseded', scene: message.scene, revision: message.revision })
        return
      }
      try {
        const { patches, boxes, change, found, fitted, colors, seconds } = scene.edit(
          message.edits,
          message,
          await regionsFor(message),
        )
        post(
          {
            kind: 'edited',
            scene: message.scene,
            revision: message.revision,
            counts: scene.counts(),
            grid: scene.tiles.viewport?.grid.id ?? -1,
            patches,
            boxes,
            change,
            marks: scene.marks(),
            found,
            fitted,
            colors,
            seconds,
          },
          patches.map(({ image }) => image),
        )
        if (scene.tiles.isWaiting) schedule()
        if (found === undefined || scene.isPowerMissing || scene.isMethodMissing) findAtRest()
      } catch (error) {
        refuse(message.scene, message.revision, error)
      }
      return
    case 'look': {
      const { isElsewhere, isOtherScale } = scene.look(message)
      schedule()
      // Outlines are clipped to the viewport and have its precision.
      if (isElsewhere && scene.isAnythingMarked) {
        post({ kind: 'outlined', scene: message.scene, marks: scene.marks() })
      }
      if (isOtherScale && scene.isPathFound) tellFound(message.scene, scene)
      return
    }
    case 'ask':
      // A picture contains all layers.
      if (message.name === 'svg' || message.name === 'image') await addMissing(scene)
      reply(scene, message)
      return
    case 'layers':
      scene.setLayers(message.layers, message.isPainted)
      // A layer limits cells.
      if (message.isPainted && scene.isAnythingMarked) {
        post({ kind: 'outlined', scene: message.scene, marks: scene.marks() })
      }
      tellFound(message.scene, scene)
      return
    case 'mark':
      post({ kind: 'marked', scene: message.scene, marks: scene.mark(message.selected, message.hovered) })
      return
    case 'close':
      scene.dispose()
      scenes.delete(message.scene)
      measuring = measuring.filter((waiting) => waiting.scene !== scene)
  }
}

function fail(error: unknown, { scene, kind }: InProgress): void {
  post({ kind: 'failed', message: reasonOf(error), during: { scene, kind } })
}

/** The module for clipping and fitting, loaded on demand. */
async function regionsFor({ region, fit }: DomainChange): Promise<Regions | undefined> {
  if ((region ?? undefined) === undefined && fit === undefined) return undefined
  return regions()
}

function reply(scene: PaintedScene, { request, name, args }: Extract<ToPainter, { kind: 'ask' }>): void {
  try {
    const value = (answers[name] as (scene: PaintedScene, ...args: readonly unknown[]) => unknown)(scene, ...args)
    if (typeof value !== 'function') {
      post({ kind: 'answer', request, value }, name === 'image' && value !== undefined ? [value as ImageBitmap] : [])
      return
    }
    measureInSteps(scene, function* () {
      return { kind: 'answer', request, value: yield* (value as Steps<unknown>)() }
    })
  } catch (error) {
    if (!(error instanceof CircleVoronoiError)) throw error
    post({ kind: 'answer', request, error: postedError(error) })
  }
}

/** Fast queries follow while an end of the path is dragged. */
function tellFound(number: number, scene: PaintedScene): void {
  if (scene.isFoundQuickly && !scene.isPowerMissing && !scene.isMethodMissing) {
    post({ kind: 'found', scene: number, found: scene.find() })
  } else {
    findAtRest()
  }
}

function refuse(scene: number, revision: number, error: unknown): void {
  if (!(error instanceof CircleVoronoiError)) throw error
  post({ kind: 'refused', scene, revision, error: postedError(error) })
}

function schedule(): void {
  if (isPainting) return
  isPainting = true
  pause.port2.postMessage(undefined)
}

function paintSlice(): void {
  isPainting = false
  const end = performance.now() + SLICE
  for (const [number, scene] of scenes) {
    const patches: Patch[] = []
    try {
      while (scene.tiles.isWaiting && performance.now() < end) {
        patches.push(...scene.tiles.paintNext())
      }
    } catch (error) {
      fail(error, { scene: number, kind: 'paint' })
      return
    }
    if (patches.length === 0) continue
    post(
      {
        kind: 'painted',
        scene: number,
        grid: scene.tiles.viewport?.grid.id ?? -1,
        patches,
        paintId: scene.tiles.viewport?.paintId ?? -1,
        isWhole: !scene.tiles.isWaiting,
      },
      patches.map(({ image }) => image),
    )
  }
  // Another scene may be waiting after one has used the time slice.
  if ([...scenes.values()].some(({ tiles }) => tiles.isWaiting)) schedule()
  measure(end)
}

function measureInSteps(scene: PaintedScene, begin: Measuring['begin']): void {
  measuring.push({ scene, begin, steps: begin() })
  schedule()
}

/** Uses the rest of a time slice for measurements. Measurements of a reopened scene restart. */
function measure(end: number): void {
  const first = measuring[0]
  if (first === undefined) return
  let step = first.steps.next()
  while (step.done !== true && performance.now() < end) step = first.steps.next()
  if (step.done === true) {
    measuring.shift()
    post(step.value)
  }
  if (measuring.length > 0) schedule()
}

/** Runs long computations once nothing has been edited for a while. */
function findAtRest(): void {
  clearTimeout(rest)
  rest = setTimeout(findAll, REST)
}

async function findAll(): Promise<void> {
  for (const [number, scene] of scenes) {
    try {
      await findIn(number, scene)
    } catch (error) {
      fail(error, { scene: number, kind: 'find' })
      return
    }
  }
}

async function findIn(number: number, scene: PaintedScene): Promise<void> {
  if (scene.isMethodMissing) {
    scene.addMethod()
    schedule()
  }
  if (scene.isAnythingToFind) post({ kind: 'found', scene: number, found: scene.find() })
  // The scene may have been closed or changed during the wait.
  await addMissing(scene, () => scenes.get(number) === scene)
}

/** Computes the visible layers of the method and of the power diagram. */
async function addMissing(scene: PaintedScene, isThere = () => true): Promise<void> {
  if (scene.isMethodMissing) {
    scene.addMethod()
    schedule()
  }
  if (!scene.isPowerMissing) return
  const loaded = await metrics().catch(() => undefined)
  // A module that fails to load leaves its layer empty. The next attempt may succeed.
  if (loaded === undefined || !isThere() || !scene.isPowerMissing) return
  scene.addPower(loaded)
  schedule()
}

function post(message: FromPainter, transfer: Transferable[] = []): void {
  port.postMessage(message, transfer)
}
