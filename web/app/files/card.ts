// SPDX-License-Identifier: GPL-3.0-or-later

/** The size of a picture that other sites show beside a link, in pixels, and the height of its caption. */
export const CARD = { width: 1200, height: 630, caption: 84 } as const

/** A picture with a caption below, as a PNG. */
export async function cardOf(picture: Blob, title: string, site: string): Promise<Blob> {
  const { width, height, caption } = CARD
  const canvas = new OffscreenCanvas(width, height)
  const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D
  const bitmap = await createImageBitmap(picture)
  context.drawImage(bitmap, 0, 0, width, height - caption)
  bitmap.close()
  context.fillStyle = '#ffffff'
  context.fillRect(0, height - caption, width, caption)
  context.textBaseline = 'middle'
  const middle = height - caption / 2
  const write = (text: string, style: string, color: string, x: number, align: CanvasTextAlign) => {
    context.font = `${style} system-ui, sans-serif`
    context.fillStyle = color
    context.textAlign = align
    context.fillText(text, x, middle, width / 2)
  }
  write(title, '600 34px', '#20242c', 36, 'left')
  write(site, '24px', '#5b6270', width - 36, 'right')
  return canvas.convertToBlob({ type: 'image/png' })
}
