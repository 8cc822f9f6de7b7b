// SPDX-License-Identifier: GPL-3.0-or-later
import type { FromThread, Thread, ThreadEvents } from './channel.ts'

/** Makes a thread of a Web Worker. */
export function webThread(worker: Worker, { onMessage, onFailure }: ThreadEvents): Thread {
  worker.onmessage = ({ data }: MessageEvent<FromThread>) => onMessage(data)
  worker.onerror = ({ message }) => onFailure(message)
  return {
    post: (message, transfer) => worker.postMessage(message, transfer as Transferable[]),
    keepAlive: () => {},
    terminate: () => worker.terminate(),
  }
}
