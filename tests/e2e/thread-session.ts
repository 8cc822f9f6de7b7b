// SPDX-License-Identifier: GPL-3.0-or-later
import type { CDPSession, Page, Worker } from '@playwright/test'

/** The file of the painting thread. */
export const THREAD = /start-thread/

/** The painting thread of a page. */
export function threadOf(page: Page): Worker {
  return page.workers().find((worker) => THREAD.test(worker.url())) as Worker
}

/** Calls `use` with a debugging session of a page's thread, nested in that of the page. `url` matches its file. */
export async function withThread<Result>(
  session: CDPSession,
  url: RegExp,
  use: (ask: Ask) => Promise<Result>,
): Promise<Result> {
  const attached = new Promise<string>((resolve) => {
    session.on('Target.attachedToTarget', ({ sessionId, targetInfo }) => {
      if (url.test(targetInfo.url)) resolve(sessionId)
    })
  })
  await session.send('Target.setAutoAttach', { autoAttach: true, waitForDebuggerOnStart: false, flatten: false })
  const sessionId = await attached
  let last = 0
  const ask: Ask = (method, params = {}) =>
    new Promise((resolve) => {
      last += 1
      const id = last
      session.on('Target.receivedMessageFromTarget', ({ message }) => {
        const answer = JSON.parse(message)
        if (answer.id === id) resolve(answer.result)
      })
      session.send('Target.sendMessageToTarget', { sessionId, message: JSON.stringify({ id, method, params }) })
    })
  try {
    return await use(ask)
  } finally {
    await session.send('Target.setAutoAttach', { autoAttach: false, waitForDebuggerOnStart: false, flatten: false })
  }
}

/** Calls a method of the protocol and returns its answer. */
// biome-ignore lint/suspicious/noExplicitAny: each method has another answer
export type Ask = (method: string, params?: object) => Promise<any>

/** Bytes of a thread's heap after garbage collection. */
export async function heapOf(ask: Ask): Promise<number> {
  await ask('HeapProfiler.collectGarbage')
  const { usedSize } = await ask('Runtime.getHeapUsage')
  return usedSize
}
