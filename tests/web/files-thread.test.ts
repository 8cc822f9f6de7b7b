// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of the files thread to failures.
import { afterEach, expect, it, vi } from 'vitest'
import type { RemoteReply } from '../../web/view/remote-calls.ts'

const world = vi.hoisted(() => ({ failures: 1 }))
vi.mock('../../web/app/generators/generators.ts', () => ({
  loadGenerators: async () => {
    if (world.failures-- > 0) throw new Error('The network is gone')
    return { catalogue: () => 'all families' }
  },
}))

afterEach(() => vi.unstubAllGlobals())

it('says what went wrong, about which circle if about one, and tries again when it is asked again', async () => {
  const replies: RemoteReply[] = []
  vi.stubGlobal('postMessage', (reply: RemoteReply) => replies.push(reply))
  await import('../../web/app/files/files-thread.ts')
  const { onmessage } = globalThis as unknown as { onmessage: (event: object) => Promise<void> }
  const ask = async (data: object) => {
    await onmessage({ data })
    return replies.at(-1)
  }
  const error = { code: 'internal', circle: undefined, message: 'The network is gone.' }
  expect(await ask({ request: 1, name: 'catalogue', args: [] })).toEqual({ request: 1, error })
  expect(await ask({ request: 2, name: 'catalogue', args: [] })).toEqual({ request: 2, value: 'all families' })
  const read = { request: 3, name: 'read', args: [new TextEncoder().encode('0,0,1\n5,0,-1\n'), 'a.csv'] }
  const refused = { code: 'negativeRadius', circle: 1, message: expect.stringMatching(/^a\.csv:2: Circle 1 /) }
  expect(await ask(read)).toEqual({ request: 3, error: refused })
})
