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
   * Without the attributes or the names of circles, if there is no room for them.
   *
   * @throws CircleVoronoiError as `encodeLink`
   */
  async linkOf(state: LinkInput): Promise<string> {
    const write = (state: LinkInput) => (sizeOf(state) > FEW ? this.#files.call('link', state) : encodeLink(state))
    try {
      return await write(state)
    } catch (error) {
      if (state.names === undefined && state.attributes === undefined) throw error
      // First without the larger part.
      const names = state.attributes === undefined ? undefined : state.names
      return this.linkOf({ ...state, names, attributes: undefined })
    }
  }
}

function sizeOf({ circles, edits }: LinkInput): number {
  const count = circles instanceof Float64Array ? circles.length / 3 : 0
  return count + (edits?.length ?? 0)
}
