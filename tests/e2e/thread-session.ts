// SPDX-License-Identifier: GPL-3.0-or-later
import type { CDPSession, Page, Worker } from '@playwright/test'

/** The file of the painter's thread. */
export const THREAD = /start-thread/

/** The painter's thread of a page. */
export function threadOf(page: Page): Worker {
  return page.workers().find((worker) => THREAD.test(worker.url())) as Worker
}

/** Has a function ask a thread of a page, which has a protocol of its own within that of the page. `url`: that of its file. */
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

/** A method of the protocol, and what it answers. */
// biome-ignore lint/suspicious/noExplicitAny: each method has another answer
export type Ask = (method: string, params?: object) => Promise<any>

/** Bytes of the heap of a thread, once what is not needed is gone. */
export async function heapOf(ask: Ask): Promise<number> {
  await ask('HeapProfiler.collectGarbage')
  const { usedSize } = await ask('Runtime.getHeapUsage')
  return usedSize
}
