// SPDX-License-Identifier: GPL-3.0-or-later
import { receivedError } from '../../lib/base/errors.ts'
import type { Float64s } from '../../lib/index.ts'
import type { LinkInput } from '../../lib/link.ts'
import type { RegionShape } from '../../lib/regions/region-shape.ts'
import type { Catalogue, Recipe } from '../generators/generators.ts'
import type { FilesReply, FilesRequest, Read, SavedFormat } from './files-protocol.ts'

/** Readers, writers and generators, in a thread that begins with the first of them. */
export class FilesClient {
  readonly #waiting = new Map<number, (reply: FilesReply) => void>()
  #worker: Worker | undefined
  #lastRequest = 0

  /** @throws CircleVoronoiError as `readCircles`, `readDiagram` */
  read(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<Read> {
    return this.#ask((request) => ({ kind: 'read', request, bytes, name }))
  }

  /** Circles that show a picture. @throws CircleVoronoiError `internal`, if the browser cannot read it */
  stipple(picture: Blob): Promise<Read> {
    return this.#ask((request) => ({ kind: 'stipple', request, picture }))
  }

  /** @throws CircleVoronoiError as `compute`, `writeDiagram` */
  write(circles: Float64s, format: SavedFormat, region?: RegionShape): Promise<string> {
    return this.#ask((request) => ({ kind: 'write', request, circles, format, region }))
  }

  /** @throws CircleVoronoiError as `encodeLink` */
  link(state: LinkInput): Promise<string> {
    return this.#ask((request) => ({ kind: 'link', request, state }))
  }

  /** @throws CircleVoronoiError `badInput`, if there is no family or figure of this name */
  make(recipe: Recipe): Promise<Float64s> {
    return this.#ask((request) => ({ kind: 'make', request, recipe }))
  }

  catalogue(): Promise<Catalogue> {
    return this.#ask((request) => ({ kind: 'catalogue', request }))
  }

  async #ask<Result>(question: (request: number) => FilesRequest): Promise<Result> {
    this.#lastRequest += 1
    const request = this.#lastRequest
    const worker = this.#start()
    const { result, error } = await new Promise<FilesReply>((resolve) => {
      this.#waiting.set(request, resolve)
      worker.postMessage(question(request))
    })
    if (error !== undefined) throw receivedError(error)
    return result as Result
  }

  /** Ends all that is being done; nobody hears of it any more. */
  cancel(): void {
    this.#worker?.terminate()
    this.#worker = undefined
    this.#waiting.clear()
  }

  #start(): Worker {
    if (this.#worker !== undefined) return this.#worker
    const worker = new Worker(new URL('./files-thread.ts', import.meta.url), { type: 'module' })
    worker.onmessage = ({ data }: MessageEvent<FilesReply>) => {
      this.#waiting.get(data.request)?.(data)
      this.#waiting.delete(data.request)
    }
    worker.onerror = () => {
      const message = 'The part of the page that does this could not be loaded. Try again.'
      for (const [request, answer] of this.#waiting)
        answer({ request, error: { code: 'notLoaded', circle: undefined, message } })
      this.#waiting.clear()
      // The next one may work.
      worker.terminate()
      this.#worker = undefined
    }
    this.#worker = worker
    return worker
  }
}
