// SPDX-License-Identifier: GPL-3.0-or-later
import { encodeLink, type LinkInput } from '../lib/link.ts'
import type { FilesClient } from './files/files-client.ts'

/** What is said of fewer circles is written at once, so that a tab that closes still keeps it. */
const FEW = 2000

/** Writes links: those of many circles in the thread of files, as they take longer than a frame. */
export class LinkWriter {
  readonly #files: FilesClient

  constructor(files: FilesClient) {
    this.#files = files
  }

  /**
   * Without the names of circles, if there is room for the circles alone.
   *
   * @throws CircleVoronoiError as `encodeLink`
   */
  async linkOf(state: LinkInput): Promise<string> {
    const write = (state: LinkInput) => (sizeOf(state) > FEW ? this.#files.call('link', state) : encodeLink(state))
    try {
      return await write(state)
    } catch (error) {
      if (state.names === undefined) throw error
      return write({ ...state, names: undefined })
    }
  }
}

function sizeOf({ circles, edits }: LinkInput): number {
  const count = circles instanceof Float64Array ? circles.length / 3 : 0
  return count + (edits?.length ?? 0)
}
