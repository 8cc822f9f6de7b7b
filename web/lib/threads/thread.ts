// SPDX-License-Identifier: GPL-3.0-or-later
import { nodeModule } from '../base/node.ts'
import type { FromThread, Thread, ThreadEvents } from './channel.ts'
import { startModuleWorker } from './module-worker.ts'
import { newWorker, THREAD_NAME, threadFile } from './thread-file.ts'
import { webThread } from './web-thread.ts'

/** Starts a thread of `createWorker`, as a Web Worker or as a worker thread of Node. */
export function startThread(events: ThreadEvents): Thread {
  return typeof Worker === 'function'
    ? webThread(startModuleWorker(newWorker, threadFile, THREAD_NAME), events)
    : startNodeThread(events)
}

function startNodeThread({ onMessage, onFailure }: ThreadEvents): Thread {
  const threads = nodeModule('node:worker_threads')
  if (threads === undefined) throw new Error('there are none here')
  const file = threadFile()
  // The thread does not inherit the options of this process, some of which (--input-type) would break it.
  const options = { eval: typeof file === 'string', execArgv: [], workerData: THREAD_NAME }
  const worker = new threads.Worker(file, options)
  worker.on('message', (message: FromThread) => onMessage(message))
  worker.on('error', onFailure)
  return {
    post: (message, transfer) => worker.postMessage(message, transfer),
    keepAlive: (isNeeded) => (isNeeded ? worker.ref() : worker.unref()),
    terminate: () => void worker.terminate(),
  }
}
