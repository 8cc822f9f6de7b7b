// SPDX-License-Identifier: GPL-3.0-or-later
// Collects saved files, copied texts, other tabs, shared links and printed pages.
import { Bitmap } from './page-canvas.ts'
import { soon } from './whole-page.ts'

/** Collects what leaves the page. */
export function outputs() {
  const files: { readonly name: string; readonly content: Blob }[] = []
  const copied: string[] = []
  const shared: { readonly url: string }[] = []
  const tabs: { location: { href: string }; isClosed: boolean; close(): void }[] = []
  const blobs = new Map<string, Blob>()
  const failing = { share: undefined as Error | undefined }
  URL.createObjectURL = (blob) => {
    const url = `blob:${blobs.size}`
    blobs.set(url, blob as Blob)
    return url
  }
  Object.assign(HTMLCanvasElement.prototype, { captureStream: () => ({ getTracks: () => [] }) })
  HTMLAnchorElement.prototype.click = function (this: HTMLAnchorElement) {
    files.push({ name: this.download, content: blobs.get(this.href) as Blob })
  }
  const surroundings = {
    ClipboardItem: class {
      readonly parts: Record<string, Promise<Blob>>
      constructor(parts: Record<string, Promise<Blob>>) {
        this.parts = parts
      }
    },
    createImageBitmap: async () => new Bitmap(1, 1),
    print: () => setTimeout(() => window.dispatchEvent(new Event('afterprint'))),
  }
  Object.assign(globalThis, surroundings)
  const openTab = () => {
    const tab = {
      location: { href: '' },
      isClosed: false,
      close() {
        tab.isClosed = true
      },
    }
    tabs.push(tab)
    return tab
  }
  Object.assign(window, { open: openTab })
  const write = async ([item]: readonly { readonly parts: Record<string, Promise<Blob>> }[]) => {
    const blob = await item?.parts['text/plain']
    copied.push((await blob?.text()) ?? '')
  }
  Object.defineProperty(navigator, 'clipboard', { value: { write }, configurable: true })
  const share = async (data: { readonly url: string }) => {
    if (failing.share !== undefined) throw failing.share
    shared.push(data)
  }
  Object.defineProperty(navigator, 'share', { value: share, configurable: true })
  /** Waits for the next file, and returns its name and its text. */
  const file = async () => {
    const { name, content } = await soon(() => {
      const [first] = files.splice(0, 1)
      if (first === undefined) throw new Error('No file was saved.')
      return first
    })
    return { name, type: content.type, text: await content.text(), content }
  }
  const text = () =>
    soon(() => {
      const [first] = copied.splice(0, 1)
      if (first === undefined) throw new Error('Nothing was copied.')
      return first
    })
  return { files, copied, shared, tabs, failing, file, text }
}
