// SPDX-License-Identifier: GPL-3.0-or-later
import './theme.css'
import type { LoadOptions } from '../lib/wasm/load-options.ts'
import { boundingBox, type Camera, fitted } from './camera.ts'
import type { Hands } from './gestures.ts'
import { PlainHands } from './hands.ts'
import { checkLayers, DEFAULT_LAYERS, type Layers } from './layers.ts'
import { Painter } from './painter.ts'
import { type Listening, listenToPointer } from './pointer.ts'
import { View } from './view.ts'

export interface MountOptions extends LoadOptions {
  /** x, y and r of each; they can be set later, too. */
  readonly circles?: Float64Array
  readonly layers?: Partial<Layers>
  /** Default: all of these circles are seen. */
  readonly camera?: Camera
  /**
   * What gestures do: `edit` (the default) drags, resizes and adds circles, `look` only pans, zooms and selects, `none`
   * nothing. A client with a history of its own listens itself (`listenToPointer`).
   */
  readonly gestures?: 'edit' | 'look' | 'none'
}

/** Around circles that are all seen, in pixels. */
const MARGIN = { top: 16, right: 16, bottom: 16, left: 16 }

/** All views of a page share a thread, as long as there is one. */
let shared: { painter: Painter; views: number } | undefined

/**
 * Shows circles and their diagram in an element, which keeps its own size. Many may be on one page: nothing is shared but the
 * thread that computes and paints, and nothing outside of the element is touched or listened to but the color scheme.
 *
 * @throws CircleVoronoiError `badArgument`, as `View.setLayers`
 */
export function mount(container: HTMLElement, options: MountOptions = {}): View {
  const { circles, layers, camera, gestures = 'edit', ...load } = options
  checkLayers({ ...DEFAULT_LAYERS, ...layers })
  shared ??= { painter: new Painter(load), views: 0 }
  const { painter } = shared
  shared.views += 1
  let listening: Listening | undefined
  const view = new View(container, painter, () => {
    listening?.stop()
    if (shared?.painter !== painter) return
    shared.views -= 1
    if (shared.views > 0) return
    painter.dispose()
    shared = undefined
  })
  if (gestures !== 'none') {
    const hands: Hands = new PlainHands(view, gestures === 'edit')
    listening = listenToPointer(container, view, hands)
  }
  if (layers !== undefined) view.setLayers(layers)
  if (camera !== undefined) view.setCamera(camera)
  else if (circles !== undefined) view.setCamera(fitted(boundingBox(circles), view.size, MARGIN))
  // What is refused is told as an event.
  if (circles !== undefined) view.setCircles(circles).catch(() => {})
  return view
}
