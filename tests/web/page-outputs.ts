// SPDX-License-Identifier: GPL-3.0-or-later
// Collects what leaves the page: saved files and copied texts.
import { expect } from 'vitest'
import { Bitmap } from './page-canvas.ts'
import { soon } from './whole-page.ts'

export function outputs() {
  const files: { readonly name: string; readonly content: Blob }[] = []
  const copied: string[] = []
  const blobs = new Map<string, Blob>()
  URL.createObjectURL = (blob) => {
    const url = `blob:${blobs.size}`
    blobs.set(url, blob as Blob)
    return url
  }
  HTMLAnchorElement.prototype.click = function (this: HTMLAnchorElement) {
    files.push({ name: this.download, content: blobs.get(this.href) as Blob })
  }
  class Item {
    readonly parts: Record<string, Promise<Blob>>
    constructor(parts: Record<string, Promise<Blob>>) {
      this.parts = parts
    }
  }
  Object.assign(globalThis, { ClipboardItem: Item, createImageBitmap: async () => new Bitmap(1, 1) })
  Object.assign(HTMLCanvasElement.prototype, { captureStream: () => ({ getTracks: () => [] }) })
  const write = async ([item]: readonly Item[]) => {
    const blob = await item?.parts['text/plain']
    copied.push((await blob?.text()) ?? '')
  }
  Object.defineProperty(navigator, 'clipboard', { value: { write }, configurable: true })
  /** Waits for the next one, and takes it. */
  const next = <Value>(list: Value[]) =>
    soon(() => {
      expect(list).not.toEqual([])
      return list.shift() as Value
    })
  const file = async () => {
    const { name, content } = await next(files)
    return { name, text: await content.text() }
  }
  return { file, text: () => next(copied) }
}
