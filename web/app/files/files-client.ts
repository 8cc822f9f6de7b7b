// SPDX-License-Identifier: GPL-3.0-or-later
import { type RemoteCall, RemoteCalls, type RemoteReply } from '../../view/remote-calls.ts'
import type { FilesCalls } from './files-protocol.ts'

/** Readers, writers and generators, in a thread that begins with the first call. */
export class FilesClient {
  #calls = new RemoteCalls<FilesCalls>()
  #worker: Worker | undefined

  /** @throws CircleVoronoiError as `FilesCalls` says */
  call<Name extends keyof FilesCalls>(
    name: Name,
    ...args: Parameters<FilesCalls[Name]>
  ): Promise<ReturnType<FilesCalls[Name]>> {
    const worker = this.#start()
    return this.#calls.call(name, args, (call: RemoteCall) => worker.postMessage(call))
  }

  /** Ends all calls; nobody hears of them any more. */
  cancel(): void {
    this.#worker?.terminate()
    this.#worker = undefined
    this.#calls = new RemoteCalls()
  }

  #start(): Worker {
    if (this.#worker !== undefined) return this.#worker
    const worker = new Worker(new URL('./files-thread.ts', import.meta.url), { type: 'module' })
    worker.onmessage = ({ data }: MessageEvent<RemoteReply>) => this.#calls.receive(data)
    worker.onerror = () => {
      const message = 'The part of the page that does this could not be loaded. Try again.'
      this.#calls.leave(undefined, { code: 'notLoaded', circle: undefined, message })
      // The next one may work.
      worker.terminate()
      this.#worker = undefined
    }
    this.#worker = worker
    return worker
  }
}
