// SPDX-License-Identifier: GPL-3.0-or-later
// Canvases without pixels. Other tests compare pictures; these only let the page and its threads draw.

/** The number of drawing calls on each canvas. */
export const draws = new WeakMap<object, number>()

/** Accepts any drawing, and keeps the properties that are set. A color in hexadecimal digits stays what it is. */
function contextOf(canvas: object) {
  const state: Record<PropertyKey, unknown> = { canvas }
  const method = (name: PropertyKey) => () => {
    if (/^(fill|stroke|fillText|drawImage)$/.test(String(name))) draws.set(canvas, (draws.get(canvas) ?? 0) + 1)
    return name === 'measureText' ? { width: 0 } : undefined
  }
  return new Proxy(state, { get: (_, name) => (name in state ? state[name] : method(name)) })
}

/** The pixels of a canvas. */
export class Bitmap {
  readonly width: number
  readonly height: number
  constructor(width: number, height: number) {
    this.width = width
    this.height = height
  }
  close() {}
}

export class Canvas {
  readonly #context = contextOf(this)
  width: number
  height: number
  constructor(width: number, height: number) {
    this.width = width
    this.height = height
  }
  getContext() {
    return this.#context
  }
  transferToImageBitmap() {
    return new Bitmap(this.width, this.height)
  }
  async convertToBlob({ type }: { readonly type: string }) {
    return new Blob([`${this.width} x ${this.height}`], { type })
  }
}

export class Path {
  moveTo() {}
  lineTo() {}
  bezierCurveTo() {}
  arc() {}
  closePath() {}
  addPath() {}
}

const contexts = new WeakMap<object, object>()

/** The context of an element of the page. */
export function contextOfElement(this: HTMLCanvasElement): object {
  const context = contexts.get(this) ?? contextOf(this)
  contexts.set(this, context)
  return context
}
