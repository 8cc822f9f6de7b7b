// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError } from '../../lib/base/errors.ts'
import { Channel } from '../../lib/threads/channel.ts'
import { webThread } from '../../lib/threads/web-thread.ts'
import type { FilesCalls } from './files-protocol.ts'

/**
 * A client of readers, writers and generators in a thread, which starts with the first call. The page has two clients:
 * opening can be canceled and may take long, while links, saved files and lists neither wait for it nor end with it.
 */
export class FilesClient {
  #channel: Channel<FilesCalls> | undefined

  /** @throws CircleVoronoiError as `FilesCalls` says */
  call<Name extends keyof FilesCalls>(
    name: Name,
    ...args: Parameters<FilesCalls[Name]>
  ): Promise<ReturnType<FilesCalls[Name]>> {
    return this.#open().request(name, args)
  }

  /** Rejects all calls and ends the thread. */
  cancel(): void {
    this.#channel?.end(new CircleVoronoiError('internal', 'It was canceled.'))
  }

  /** Returns the channel to the thread, or to another one if that has ended. */
  #open(): Channel<FilesCalls> {
    if (this.#channel !== undefined && !this.#channel.isEnded) return this.#channel
    const reason = 'The part of the page that does this could not be loaded. Try again.'
    const worker = new Worker(new URL('./files-thread.ts', import.meta.url), { type: 'module' })
    const fail = () => channel.end(new CircleVoronoiError('notLoaded', reason))
    const channel = new Channel<FilesCalls>((events) => webThread(worker, events), fail, {})
    this.#channel = channel
    return channel
  }
}
