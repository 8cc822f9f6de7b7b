// SPDX-License-Identifier: GPL-3.0-or-later
// The caches that the service worker keeps. tests/e2e/site.spec.ts tests its answers.
import { afterEach, expect, it, vi } from 'vitest'

const SCOPE = 'https://example.org/site/'
const OTHERS = ['https://example.org/site 5', `${SCOPE}other/ 6`]

afterEach(() => vi.unstubAllGlobals())

it('keeps its own cache, that of the version before, and those of other sites', async () => {
  const kept = new Set([...OTHERS, ...[4, 5, 6, 7].map((version) => `${SCOPE} ${version}`)])
  const listeners = new Map<string, (event: object) => void>()
  vi.stubGlobal('self', {
    registration: { scope: SCOPE },
    clients: { claim: async () => {} },
    addEventListener: (name: string, listener: (event: object) => void) => listeners.set(name, listener),
  })
  vi.stubGlobal('VERSION', '7')
  vi.stubGlobal('FILES', [])
  vi.stubGlobal('caches', { keys: async () => [...kept], delete: async (name: string) => kept.delete(name) })
  // The variable hides from TypeScript that the file is not a module.
  const script = '../../web/app/service-worker.ts'
  await import(/* @vite-ignore */ script)
  let done: Promise<unknown> | undefined
  listeners.get('activate')?.({
    waitUntil: (until: Promise<unknown>) => {
      done = until
    },
  })
  await done
  expect([...kept]).toEqual([...OTHERS, `${SCOPE} 6`, `${SCOPE} 7`])
})
