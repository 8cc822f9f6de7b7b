// SPDX-License-Identifier: GPL-3.0-or-later
import type { Worker as NodeWorker } from 'node:worker_threads'
import { startModuleWorker } from './module-worker.ts'
import { newWorker, THREAD_NAME, threadFile } from './thread-file.ts'
import type { EditorCalls, Reply, Request, Start } from './worker-messages.ts'

/** A running thread of `createWorker`, in a browser or in Node. */
export interface Thread {
  /** Sends a message and transfers the memory of the arrays in `transfer`. */
  post(message: Start | Request | EditorCalls, transfer?: ArrayBuffer[]): void
  /** Sets whether the thread keeps Node from exiting. It has no effect in browsers. */
  keepAlive(isNeeded: boolean): void
  /** Ends the thread at once, even during a computation. */
  terminate(): void
}

/** The events of a thread. */
export interface ThreadEvents {
  onReply(reply: Reply): void
  /** Called if the thread could not be loaded or has failed. */
  onFailure(cause: unknown): void
}

/** Starts a thread, as a Web Worker or as a worker thread of Node. */
export function startThread(events: ThreadEvents): Thread {
  return typeof Worker === 'function' ? startWebWorker(events) : startNodeThread(events)
}

function startWebWorker({ onReply, onFailure }: ThreadEvents): Thread {
  const worker = startModuleWorker(newWorker, threadFile, THREAD_NAME)
  worker.onmessage = ({ data }: MessageEvent<Reply>) => onReply(data)
  worker.onerror = (event) => onFailure(event.message ?? 'its file cannot be loaded')
  return {
    post: (message, transfer = []) => worker.postMessage(message, transfer),
    keepAlive: () => {},
    terminate: () => worker.terminate(),
  }
}

function startNodeThread({ onReply, onFailure }: ThreadEvents): Thread {
  const threads = globalThis.process?.getBuiltinModule?.('node:worker_threads')
  if (threads === undefined) throw new Error('there are none here')
  const file = threadFile()
  // The thread does not inherit the options of this process, some of which (--input-type) would break it.
  const options = { eval: typeof file === 'string', execArgv: [], workerData: THREAD_NAME }
  const worker: NodeWorker = new threads.Worker(file, options)
  worker.on('message', onReply)
  worker.on('error', onFailure)
  return {
    post: (message, transfer = []) => worker.postMessage(message, transfer),
    keepAlive: (isNeeded) => (isNeeded ? worker.ref() : worker.unref()),
    terminate: () => void worker.terminate(),
  }
}
