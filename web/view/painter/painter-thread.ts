// SPDX-License-Identifier: GPL-3.0-or-later
// What runs in the worker of a view's `Painter`.

import { CircleVoronoiError, reasonOf } from '../../lib/errors.ts'
import { type CircleVoronoi, circleVoronoiOf } from '../../lib/library.ts'
import type { FromPainter, Patch, ToPainter } from '../protocol.ts'
import { PaintedScene } from './painted-scene.ts'

/** How long the thread paints before it listens again, in milliseconds. */
const SLICE = 8

const port = globalThis as unknown as {
  onmessage: (event: MessageEvent<ToPainter>) => void
  postMessage(message: FromPainter, transfer?: Transferable[]): void
}

let begin: (library: CircleVoronoi | Promise<CircleVoronoi>) => void
const library = new Promise<CircleVoronoi>((resolve) => {
  begin = resolve
})
const scenes = new Map<number, { readonly scene: PaintedScene; revision: number }>()
let isPainting = false
/** Lets messages that have arrived be heard before more is painted. */
const pause = new MessageChannel()
pause.port1.onmessage = paintSlice

// One after the other, though the first ones wait for the library.
let last: Promise<void> = Promise.resolve()
port.onmessage = ({ data }) => {
  if (data.kind === 'start') begin(circleVoronoiOf(data.module))
  else last = last.then(() => answer(data)).catch((error) => post({ kind: 'failed', message: reasonOf(error) }))
}

async function answer(message: Exclude<ToPainter, { kind: 'start' }>): Promise<void> {
  const known = scenes.get(message.scene) ?? {
    scene: new PaintedScene(await library),
    revision: 0,
  }
  scenes.set(message.scene, known)
  const { scene } = known
  const start = performance.now()
  switch (message.kind) {
    case 'open':
      try {
        scene.open(message.circles)
        known.revision = message.revision
        post({
          kind: 'opened',
          scene: message.scene,
          revision: message.revision,
          counts: scene.counts(),
          seconds: secondsSince(start),
        })
        schedule()
      } catch (error) {
        refuse(message.scene, message.revision, error)
      }
      return
    case 'edit':
      try {
        const { patches, boxes, inserted } = scene.edit(message.edits)
        known.revision = message.revision
        post(
          {
            kind: 'edited',
            scene: message.scene,
            revision: message.revision,
            counts: scene.counts(),
            grid: scene.grid,
            patches,
            boxes,
            inserted,
            marks: scene.marks(),
            seconds: secondsSince(start),
          },
          patches.map(({ image }) => image),
        )
      } catch (error) {
        refuse(message.scene, message.revision, error)
      }
      return
    case 'look':
      scene.look(message, message.style)
      schedule()
      return
    case 'hit':
      post({ kind: 'hit', request: message.request, hit: scene.hit(message.x, message.y, message.slack) })
      return
    case 'mark':
      post({ kind: 'marked', scene: message.scene, marks: scene.mark(message.selected, message.hovered) })
      return
    case 'close':
      scene.dispose()
      scenes.delete(message.scene)
  }
}

function refuse(scene: number, revision: number, error: unknown): void {
  if (!(error instanceof CircleVoronoiError)) throw error
  post({ kind: 'refused', scene, revision, code: error.code, circle: error.circle, message: error.message })
}

function secondsSince(start: number): number {
  return (performance.now() - start) / 1000
}

function schedule(): void {
  if (isPainting) return
  isPainting = true
  pause.port2.postMessage(undefined)
}

function paintSlice(): void {
  isPainting = false
  const end = performance.now() + SLICE
  for (const [number, { scene, revision }] of scenes) {
    const patches: Patch[] = []
    while (scene.isWaiting && performance.now() < end) {
      const patch = scene.paintNext()
      if (patch !== undefined) patches.push(patch)
    }
    if (patches.length === 0) continue
    post(
      {
        kind: 'painted',
        scene: number,
        revision,
        grid: scene.grid,
        patches,
        wish: scene.wish,
        isWhole: !scene.isWaiting,
      },
      patches.map(({ image }) => image),
    )
    if (scene.isWaiting) schedule()
  }
}

function post(message: FromPainter, transfer: Transferable[] = []): void {
  port.postMessage(message, transfer)
}
