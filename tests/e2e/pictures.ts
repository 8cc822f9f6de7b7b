// SPDX-License-Identifier: GPL-3.0-or-later
// The painted picture of a page, before and after something that must not change it.
import type { Hands } from './monkey.ts'

declare global {
  var pictures: Partial<Record<'before' | 'after', ImageData>> | undefined
}

/** Summarizes the visible state, to detect changes. */
export function shown(page: Hands): Promise<string> {
  return page.evaluate(async () => {
    const hashes = [...document.querySelectorAll<HTMLCanvasElement>('#figure canvas')].map(async (canvas) => {
      const copy = new OffscreenCanvas(canvas.width, canvas.height)
      const context = copy.getContext('2d', { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D
      context.drawImage(canvas, 0, 0)
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height)
      return String(new Uint8Array(await crypto.subtle.digest('SHA-256', data)))
    })
    const status = document.querySelector('#status')?.textContent
    return [status, location.href, ...(await Promise.all(hashes))].join()
  }, undefined)
}

/** Keeps the picture in the page. */
export function keepPicture(page: Hands, name: 'before' | 'after'): Promise<void> {
  return page.evaluate((name) => {
    const canvas = document.querySelector('#figure canvas') as HTMLCanvasElement
    const copy = new OffscreenCanvas(canvas.width, canvas.height)
    const context = copy.getContext('2d', { willReadFrequently: true }) as OffscreenCanvasRenderingContext2D
    context.drawImage(canvas, 0, 0)
    globalThis.pictures = { ...globalThis.pictures, [name]: context.getImageData(0, 0, canvas.width, canvas.height) }
  }, name)
}

/** The bytes of a kept picture as PNG. */
export function pngOf(page: Hands, name: 'before' | 'after'): Promise<number[]> {
  return page.evaluate(async (name) => {
    const picture = globalThis.pictures?.[name] as ImageData
    const canvas = new OffscreenCanvas(picture.width, picture.height)
    canvas.getContext('2d')?.putImageData(picture, 0, 0)
    return [...new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer())]
  }, name)
}

/**
 * The number and places of tiles that differ. Clipping changes the chords of lines by up to a tenth of a pixel, so that
 * single pixels may differ.
 */
export function differenceOf(page: Hands): Promise<{ squares: number }> {
  return page.evaluate(() => {
    const { before: one, after: other } = globalThis.pictures as Record<'before' | 'after', ImageData>
    const side = 3
    const most = 24 * side * side
    if (one.width !== other.width || one.height !== other.height) return { squares: Number.POSITIVE_INFINITY }
    let squares = 0
    let [left, top, right, bottom] = [one.width, one.height, 0, 0]
    for (let y = 0; y + side <= one.height; y += side) {
      for (let x = 0; x + side <= one.width; x += side) {
        const sums = [0, 0, 0]
        for (let k = 0; k < side * side; k++) {
          const first = 4 * ((y + Math.floor(k / side)) * one.width + x + (k % side))
          for (const c of [0, 1, 2]) {
            sums[c] = (sums[c] as number) + (one.data[first + c] as number) - (other.data[first + c] as number)
          }
        }
        if (sums.every((sum) => Math.abs(sum) <= most)) continue
        squares += 1
        ;[left, top, right, bottom] = [Math.min(left, x), Math.min(top, y), Math.max(right, x), Math.max(bottom, y)]
      }
    }
    return squares === 0 ? { squares } : { squares, left, top, right, bottom }
  }, undefined)
}
