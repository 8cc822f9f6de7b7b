// SPDX-License-Identifier: GPL-3.0-or-later
// The page's calls to its files thread, and writing links there.
import { afterEach, expect, it, vi } from 'vitest'
import { FilesClient } from '../../web/app/files/files-client.ts'
import { LinkWriter } from '../../web/app/link-writer.ts'
import { PageActions } from '../../web/app/page-actions.ts'
import type { Editing } from '../../web/editing/editing.ts'
import { INITIAL_STATE } from '../../web/editing/state.ts'
import { createStore } from '../../web/editing/store.ts'
import type { RemoteCall, RemoteReply } from '../../web/view/remote-calls.ts'
import type { View } from '../../web/view/view.ts'

const NO_PADDING = { top: 0, right: 0, bottom: 0, left: 0 }
const threads: FakeWorker[] = []

class FakeWorker {
  readonly calls: RemoteCall[] = []
  onmessage: ((event: { data: RemoteReply }) => void) | undefined
  onerror: (() => void) | undefined
  constructor() {
    threads.push(this)
  }
  postMessage(call: RemoteCall) {
    this.calls.push(call)
  }
  reply(answer: Omit<RemoteReply, 'request'>) {
    this.onmessage?.({ data: { request: this.calls.at(-1)?.request as number, ...answer } })
  }
  isTerminated = false
  terminate() {
    this.isTerminated = true
  }
}

afterEach(() => {
  vi.unstubAllGlobals()
  threads.length = 0
})

it('starts a new thread after one could not be loaded', async () => {
  vi.stubGlobal('Worker', FakeWorker)
  const client = new FilesClient()
  const failed = client.call('catalogue')
  threads[0]?.onerror?.()
  await expect(failed).rejects.toMatchObject({ code: 'notLoaded', message: /could not be loaded/ })
  const loaded = client.call('catalogue')
  threads[1]?.reply({ value: 'all families' })
  expect(await loaded).toBe('all families')
  expect(threads).toHaveLength(2)
})

it('ends what is opened where that is canceled, which is told, and nothing that is saved or linked', async () => {
  vi.stubGlobal('Worker', FakeWorker)
  const [reader, files] = [new FilesClient(), new FilesClient()]
  const circles = Float64Array.from({ length: 9000 }, (_, k) => k)
  const read = reader.call('read', new Uint8Array(), 'large.csv')
  const link = new LinkWriter(files).linkOf({ circles })
  const written = files.call('write', circles, 'csv')
  const [reading, other] = threads as [FakeWorker, FakeWorker]
  expect([reading.calls.length, other.calls.length]).toEqual([1, 2])
  const view = { cancel: () => false } as unknown as View
  const actions = new PageActions(createStore(INITIAL_STATE), {} as Editing, view, () => NO_PADDING, reader)
  actions.cancelOpening()
  await expect(read).rejects.toThrow('It was canceled.')
  expect([reading.isTerminated, other.isTerminated]).toEqual([true, false])
  other.onmessage?.({ data: { request: other.calls[0]?.request as number, value: 'v1.x' } })
  other.reply({ value: 'x,y,r' })
  expect([await link, await written]).toEqual(['v1.x', 'x,y,r'])
  // A new thread reads the next file.
  reader.call('read', new Uint8Array(), 'next.csv')
  expect(threads).toHaveLength(3)
})

it('writes a link without attributes if it would be too large with them', async () => {
  vi.stubGlobal('Worker', FakeWorker)
  const links = new LinkWriter(new FilesClient())
  const circles = Float64Array.from({ length: 9000 }, (_, k) => k)
  const attributes = { properties: [], ids: [], heights: [], collection: '{"a":1}' }
  const link = links.linkOf({ circles, attributes })
  const [thread] = threads
  expect(thread?.calls[0]?.args).toEqual([{ circles, attributes }])
  thread?.reply({ error: { code: 'linkTooLong', circle: undefined, message: 'The link is too large.' } })
  await vi.waitFor(() => expect(thread?.calls).toHaveLength(2))
  expect(thread?.calls[1]?.args).toEqual([{ circles, attributes: undefined }])
  thread?.reply({ value: 'v1.x' })
  expect(await link).toBe('v1.x')
})
