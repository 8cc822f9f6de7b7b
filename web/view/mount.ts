// SPDX-License-Identifier: GPL-3.0-or-later
import './theme.css'
import type { FigureLoadOptions } from './load.ts'
import { Painter } from './painter.ts'
import { View } from './view.ts'

/** All views of a page share a thread, as long as there is one. */
let shared: { painter: Painter; views: number } | undefined

/**
 * Shows circles and their diagram in an element, which keeps its own size. Many may be on one page: nothing is shared but the
 * thread that computes and paints, and nothing outside of the element is touched or listened to but the color scheme.
 */
export function mount(container: HTMLElement, load: FigureLoadOptions = {}): View {
  shared ??= { painter: new Painter(load), views: 0 }
  const { painter } = shared
  shared.views += 1
  return new View(container, painter, () => {
    if (shared?.painter !== painter) return
    shared.views -= 1
    if (shared.views > 0) return
    painter.dispose()
    shared = undefined
  })
}
