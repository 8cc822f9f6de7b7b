// SPDX-License-Identifier: GPL-3.0-or-later
// The responses of the service worker, with fake caches. tests/e2e/site.spec.ts uses real ones.
import { afterEach, expect, it, vi } from 'vitest'

const SCOPE = 'https://example.org/site/'

afterEach(() => vi.unstubAllGlobals())

it('answers what is asked for in its folder, from its cache or else from the network, and nothing else', async () => {
  const listeners = new Map<string, (event: object) => void>()
  const cached = new Map([[`${SCOPE}index.html`, 'the page']])
  const match = async ({ url }: { url: string }) => cached.get(url)
  vi.stubGlobal('self', {
    registration: { scope: SCOPE },
    addEventListener: (name: string, listener: (event: object) => void) => listeners.set(name, listener),
  })
  vi.stubGlobal('VERSION', '7')
  vi.stubGlobal('FILES', [])
  vi.stubGlobal('caches', { open: async () => ({ match }), match })
  vi.stubGlobal('fetch', async ({ url }: { url: string }) => `fetched ${url}`)
  // The variable hides from TypeScript that the file is not a module.
  const script = '../../web/app/service-worker.ts'
  await import(/* @vite-ignore */ script)
  const answerTo = (url: string, method = 'GET') => {
    const answers: unknown[] = []
    const event = { request: { url, method }, respondWith: (answer: unknown) => answers.push(answer) }
    listeners.get('fetch')?.(event)
    return answers[0]
  }
  expect(await answerTo(`${SCOPE}index.html`)).toBe('the page')
  expect(await answerTo(`${SCOPE}data/more.csv`)).toBe(`fetched ${SCOPE}data/more.csv`)
  expect(answerTo(`${SCOPE}index.html`, 'POST')).toBeUndefined()
  expect(answerTo('https://example.org/other/index.html')).toBeUndefined()
})
