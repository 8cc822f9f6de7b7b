// SPDX-License-Identifier: GPL-3.0-or-later
import { escaped } from '../../lib/drawing/escaped.ts'

/** Saves a file through the browser. */
export function save(content: Blob, name: string): void {
  const link = document.createElement('a')
  link.href = URL.createObjectURL(content)
  link.download = name
  link.click()
  // Waits until the browser has begun to read it.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000)
}

/**
 * The HTML that shows a link's circles in another page, with the module next to this page. `about` is the name for screen
 * readers, and the text where the module does not run.
 */
export function elementCode(module: string, link: string, controls: string, about: string): string {
  const text = escaped(about)
  return `<script type="module" src="${module}"></script>\n<circle-voronoi src="#${link}" ${controls} alt="${text}">${text}</circle-voronoi>`
}

/** The layout of a frame of fixed size: a question adds text above the figure, the player adds text below. */
export type FrameShape = 'figure' | 'question' | 'player'
const SHAPES: Readonly<Record<FrameShape, string>> = { figure: '3 / 2', question: '4 / 3', player: '1' }

/**
 * The HTML that embeds a page at the available width. The attributes width and height are for sites that remove styles.
 */
export function embedCode(address: string, title = 'Voronoi diagram of circles', shape: FrameShape = 'figure'): string {
  const style = `width: 100%; height: auto; aspect-ratio: ${SHAPES[shape]}; max-height: 90vh; border: 0`
  return `<iframe src="${address}" title="${escaped(title)}" loading="lazy" width="100%" height="480" style="${style}"></iframe>`
}
