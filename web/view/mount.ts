// SPDX-License-Identifier: GPL-3.0-or-later
import './theme.css'
import type { FigureLoadOptions } from './load.ts'
import { Painter } from './painter.ts'
import type { Store } from './store.ts'
import { View } from './view.ts'
import type { ViewState } from './view-state.ts'

/** The thread shared by all views of a page. */
let shared: { painter: Painter; views: number } | undefined

/**
 * Shows circles and their diagram in an element, which keeps its size. A page can have many views. They share only the
 * computing and painting thread, and outside their elements they listen only to the color scheme. The view draws the
 * state of `store`, and keeps none of its own.
 */
export function mount(container: HTMLElement, store: Store<ViewState>, load: FigureLoadOptions = {}): View {
  shared ??= { painter: new Painter(load), views: 0 }
  const { painter } = shared
  shared.views += 1
  return new View(container, painter, store, () => {
    if (shared?.painter !== painter) return
    shared.views -= 1
    if (shared.views > 0) return
    painter.dispose()
    shared = undefined
  })
}
