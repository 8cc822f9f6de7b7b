// SPDX-License-Identifier: GPL-3.0-or-later
import type { Check } from './check-types.ts'

/**
 * The presentation of a link's figure in `embed.html`: its texts, and the question that it asks. An element and the
 * playground leave these fields to the page.
 *
 * @category Links
 */
export interface LinkFrame {
  /** The title of the figure, at most 200 letters long. */
  readonly title?: string | undefined
  /** The task for readers, at most 2000 letters long. */
  readonly question?: string | undefined
  /** The condition that the circles must meet. Circle `i` of the link has the id `i`. */
  readonly check?: Check | undefined
  /** Whether readers cannot edit the circles. */
  readonly readonly?: boolean | undefined
  /** The name of the figure for screen readers, at most 200 letters long. */
  readonly alt?: string | undefined
  /** The language of the frame, such as `de`. */
  readonly lang?: string | undefined
}

const FRAME_FIELDS = ['title', 'question', 'check', 'readonly', 'alt', 'lang'] as const

/** Returns the fields of a state that describe the frame. */
export function frameOf(state: LinkFrame): LinkFrame {
  return Object.fromEntries(FRAME_FIELDS.flatMap((name) => (state[name] === undefined ? [] : [[name, state[name]]])))
}
