// SPDX-License-Identifier: GPL-3.0-or-later
import { encodeLink, type LinkInput } from '../lib/link.ts'
import type { FilesClient } from './files/files-client.ts'

/** Links with fewer circles are written synchronously, so that a closing tab still saves them. */
const FEW = 2000

/** Writes links. With many circles this takes longer than a frame and runs in the files thread. */
export class LinkWriter {
  readonly #files: FilesClient

  constructor(files: FilesClient) {
    this.#files = files
  }

  /**
   * Drops attributes and headings that do not fit.
   * @throws CircleVoronoiError as `encodeLink`
   */
  async linkOf(state: LinkInput): Promise<string> {
    const write = (state: LinkInput) => (sizeOf(state) > FEW ? this.#files.call('link', state) : encodeLink(state))
    try {
      return await write(state)
    } catch (error) {
      if (state.attributes === undefined && state.headings === undefined) throw error
      return write({ ...state, attributes: undefined, headings: undefined })
    }
  }
}

function sizeOf({ circles, edits }: LinkInput): number {
  const count = circles instanceof Float64Array ? circles.length / 3 : 0
  return count + (edits?.length ?? 0)
}
