// SPDX-License-Identifier: GPL-3.0-or-later
import type { LinkInput } from '../lib/link.ts'
import type { FigureState } from './circle-voronoi-element.ts'

/**
 * The message that `embed.html` posts to its parent when it is ready, and when its height, its circles or its check
 * change. Listen with `window.addEventListener('message', ...)`, and compare `event.source` with the `contentWindow` of
 * the frame.
 */
export interface FrameMessage {
  readonly type: 'circle-voronoi'
  /** The height in CSS pixels at which everything in the frame is visible, for its current width. */
  readonly height: number
  /** The state of the figure; `undefined` until circles are visible. */
  readonly state: FigureState | undefined
  /** Whether the circles meet the check; `undefined` if the frame has no check, or no circles yet. */
  readonly met: boolean | undefined
  /** The answer for a form, as the element submits it: JSON with `circles`, and with `check` if the frame has a check. */
  readonly answer: string
  /** The reason why the latest link or request cannot be shown; `undefined` if it is shown. */
  readonly error: string | undefined
}

/** The message that a page posts to the `contentWindow` of a frame to change its figure. The frame answers with a message. */
export interface FrameRequest {
  readonly type: 'circle-voronoi'
  /**
   * A state, or a link as text. Without circles, a state changes only the parts that it names. A message without a
   * state changes nothing.
   */
  readonly state?: LinkInput | string | undefined
}
