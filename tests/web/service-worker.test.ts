// SPDX-License-Identifier: GPL-3.0-or-later
// The responses of the service worker, with fake caches. tests/e2e/site.spec.ts uses real ones.
import { afterEach, expect, it, vi } from 'vitest'

const SCOPE = 'https://example.org/site/'

afterEach(() => vi.unstubAllGlobals())

/** Runs the service worker of version 7 with caches by their names, which hold addresses. */
async function working(caches: readonly string[] = [], files: readonly (readonly [string, string])[] = []) {
  vi.resetModules()
  const listeners = new Map<string, (event: object) => void>()
  const done: unknown[][] = []
  const cached = new Map([[`${SCOPE}index.html`, 'the page']])
  const earlier = new Map([[`${SCOPE}earlier.js`, 'of the version before']])
  const world = { isDeployed: true }
  const matchIn =
    (map: Map<string, string>, name: string) =>
    async ({ url }: { url: string }, options: object) => {
      done.push([name, options])
      return map.get(url)
    }
  const cache = {
    match: matchIn(cached, 'own'),
    addAll: async (requests: readonly { url: string; options: object }[]) => {
      done.push(...requests.map(({ url, options }) => ['add', url, options]))
      if (!world.isDeployed) throw new Error('integrity')
    },
  }
  vi.stubGlobal(
    'Request',
    class {
      readonly url: string
      readonly options: object
      constructor({ href }: URL, options: object) {
        this.url = href
        this.options = options
      }
    },
  )
  vi.stubGlobal('self', {
    registration: { scope: SCOPE },
    clients: { claim: async () => done.push(['claim']) },
    skipWaiting: async () => done.push(['skipWaiting']),
    addEventListener: (name: string, listener: (event: object) => void) => listeners.set(name, listener),
  })
  vi.stubGlobal('VERSION', '7')
  vi.stubGlobal('FILES', files)
  vi.stubGlobal('caches', {
    open: async (name: string) => {
      expect(name).toBe(`${SCOPE} 7`)
      return cache
    },
    match: matchIn(earlier, 'all'),
    keys: async () => caches,
    delete: async (name: string) => done.push(['delete', name]),
  })
  vi.stubGlobal('fetch', async ({ url }: { url: string }) => `fetched ${url}`)
  // The variable hides from TypeScript that the file is not a module.
  const script = '../../web/app/service-worker.ts'
  await import(/* @vite-ignore */ script)
  const until = async (name: string) => {
    let waited: Promise<unknown> | undefined
    listeners.get(name)?.({
      waitUntil: (until: Promise<unknown>) => {
        waited = until
      },
    })
    await waited
  }
  return { listeners, done, until, world }
}

it('stores all files of its version, checked by their hashes, and takes over at once', async () => {
  const files = [
    ['index.html', 'sha-1'],
    ['assets/a.js', 'sha-2'],
  ] as const
  const { done, until, world } = await working([], files)
  const added = files.map(([url, integrity]) => ['add', SCOPE + url, { integrity, cache: 'no-cache' }])
  await until('install')
  expect(done.splice(0)).toEqual([...added, ['skipWaiting']])
  world.isDeployed = false
  await expect(until('install')).rejects.toThrow('integrity')
  expect(done).toEqual([...added, ['delete', `${SCOPE} 7`]])
})

it('keeps its own cache, that of the version before, and those of other sites', async () => {
  const { done, until } = await working([
    `${SCOPE} 4`,
    'https://example.org/site 5',
    `${SCOPE} 5`,
    `${SCOPE}other/ 6`,
    `${SCOPE} 6`,
    `${SCOPE} 7`,
  ])
  await until('activate')
  expect(done).toEqual([['delete', `${SCOPE} 4`], ['delete', `${SCOPE} 5`], ['claim']])
})

it('answers what is asked for in its folder, from its cache or else from the network, and nothing else', async () => {
  const { listeners, done } = await working()
  const answerTo = (url: string, method = 'GET') => {
    const answers: unknown[] = []
    const event = { request: { url, method }, respondWith: (answer: unknown) => answers.push(answer) }
    listeners.get('fetch')?.(event)
    return answers[0]
  }
  const options = { ignoreSearch: true, ignoreVary: true }
  expect(await answerTo(`${SCOPE}index.html`)).toBe('the page')
  expect(done.splice(0)).toEqual([['own', options]])
  expect(await answerTo(`${SCOPE}earlier.js`)).toBe('of the version before')
  expect(done.splice(0)).toEqual([
    ['own', options],
    ['all', options],
  ])
  expect(await answerTo(`${SCOPE}data/more.csv`)).toBe(`fetched ${SCOPE}data/more.csv`)
  expect(answerTo(`${SCOPE}index.html`, 'POST')).toBeUndefined()
  expect(answerTo('https://example.org/other/index.html')).toBeUndefined()
})
