// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError } from '../lib/errors.ts'
import { encodeLink, type LinkInput } from '../lib/link.ts'

export interface LinkRequest {
  readonly request: number
  readonly state: LinkInput
}

export interface LinkReply {
  readonly request: number
  /** `undefined`: there is too much for a link. */
  readonly link: string | undefined
}

/** What is said of fewer circles is written at once, so that a tab that closes still keeps it. */
const FEW = 2000

/** Writes links: those of many circles in a thread of its own, as they take longer than a frame. */
export class LinkWriter {
  #thread: Worker | undefined
  #requests = 0
  readonly #waiting = new Map<number, (link: string | undefined) => void>()

  /** `undefined`: there is too much for a link. */
  async linkOf(state: LinkInput): Promise<string | undefined> {
    if (sizeOf(state) > FEW) return this.#fromThread(state)
    try {
      return await encodeLink(state)
    } catch (error) {
      if (error instanceof CircleVoronoiError) return undefined
      throw error
    }
  }

  #fromThread(state: LinkInput): Promise<string | undefined> {
    this.#thread ??= this.#started()
    this.#requests += 1
    const request = this.#requests
    this.#thread.postMessage({ request, state } satisfies LinkRequest)
    return new Promise((resolve) => this.#waiting.set(request, resolve))
  }

  #started(): Worker {
    const thread = new Worker(new URL('./link-thread.ts', import.meta.url), { type: 'module' })
    thread.onmessage = ({ data: { request, link } }: MessageEvent<LinkReply>) => {
      this.#waiting.get(request)?.(link)
      this.#waiting.delete(request)
    }
    // The next one has another thread; what waits is not kept.
    thread.onerror = () => {
      thread.terminate()
      this.#thread = undefined
      for (const resolve of this.#waiting.values()) resolve(undefined)
      this.#waiting.clear()
    }
    return thread
  }
}

function sizeOf({ circles, edits }: LinkInput): number {
  const count = circles instanceof Float64Array ? circles.length / 3 : 0
  return count + (edits?.length ?? 0)
}
