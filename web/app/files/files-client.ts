// SPDX-License-Identifier: GPL-3.0-or-later
import type { ErrorCode } from '../../lib/base/errors.ts'
import { type RemoteCall, RemoteCalls, type RemoteReply } from '../../view/remote-calls.ts'
import type { FilesCalls } from './files-protocol.ts'

/**
 * A client of readers, writers and generators in a thread, which starts with the first call. The page has two clients:
 * opening can be canceled and may take long, while links, saved files and lists neither wait for it nor end with it.
 */
export class FilesClient {
  readonly #calls = new RemoteCalls<FilesCalls>()
  #worker: Worker | undefined

  /** @throws CircleVoronoiError as `FilesCalls` says */
  call<Name extends keyof FilesCalls>(
    name: Name,
    ...args: Parameters<FilesCalls[Name]>
  ): Promise<ReturnType<FilesCalls[Name]>> {
    const worker = this.#start()
    return this.#calls.call(name, args, (call: RemoteCall) => worker.postMessage(call))
  }

  /** Rejects all calls and ends the thread. */
  cancel(): void {
    this.#end('internal', 'It was canceled.')
  }

  #end(code: ErrorCode, message: string): void {
    this.#worker?.terminate()
    // A new worker may succeed.
    this.#worker = undefined
    this.#calls.leave(undefined, { code, circle: undefined, message })
  }

  #start(): Worker {
    if (this.#worker !== undefined) return this.#worker
    const worker = new Worker(new URL('./files-thread.ts', import.meta.url), { type: 'module' })
    worker.onmessage = ({ data }: MessageEvent<RemoteReply>) => this.#calls.receive(data)
    worker.onerror = () => this.#end('notLoaded', 'The part of the page that does this could not be loaded. Try again.')
    this.#worker = worker
    return worker
  }
}
