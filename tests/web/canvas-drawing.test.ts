// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings on a canvas, whose state lasts from one operation to the next.
import { expect, it } from 'vitest'
import type { PathSink } from '../../web/lib/index.ts'
import { CanvasDrawing } from '../../web/view/painter/drawing.ts'

/** Keeps the state in which each operation found it. */
class FakeContext {
  readonly canvas = { width: 9, height: 9 }
  readonly done: unknown[] = []
  readonly #saved: object[] = []
  globalAlpha = 1
  clips = 0
  dash: number[] = []
  setLineDash(dash: number[]) {
    this.dash = dash
  }
  save() {
    this.#saved.push({ clips: this.clips })
  }
  restore() {
    Object.assign(this, this.#saved.pop())
  }
  clip() {
    this.clips += 1
  }
  fill = () => this.#note('fill')
  fillRect = () => this.#note('cover')
  stroke = () => this.#note('stroke')
  fillText = () => this.#note('write')
  strokeText = () => this.#note('rim')
  #note(what: string) {
    const { globalAlpha, dash, clips } = this
    this.done.push([what, globalAlpha, what === 'stroke' || what === 'rim' ? dash : [], clips])
  }
}

it('each operation has its own opacity and dashes, and at most one clip', () => {
  const context = new FakeContext()
  const drawing = new CanvasDrawing(context as unknown as CanvasRenderingContext2D)
  const path = {} as PathSink
  const write = () => drawing.write('text', 1, 1, 9, 'black', 'white')
  drawing.fill(path, 'red', 0.5)
  drawing.cover('white')
  drawing.clip(path)
  drawing.stroke(path, 'red', 1, [3, 1], 0.25)
  write()
  drawing.clip(path)
  drawing.fill(path, 'red')
  drawing.clip(undefined)
  drawing.clip(undefined)
  drawing.stroke(path, 'red', 1)
  expect(context.done).toEqual([
    ['fill', 0.5, [], 0],
    ['cover', 1, [], 0],
    ['stroke', 0.25, [3, 1], 1],
    ['rim', 1, [], 1],
    ['write', 1, [], 1],
    ['fill', 1, [], 1],
    ['stroke', 1, [], 0],
  ])
})
