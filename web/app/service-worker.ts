// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the site work offline after the first visit. Each version of the site has a cache with all of its files, checked
// by their hashes. A page comes from the newest complete version, and its file names contain hashes, so that no page mixes two
// versions. The cache of the previous version stays for pages that are still open. Libraries for service workers either delete
// files that open pages have yet to load, or wait until all pages are closed.
//
// `FILES` is written by scripts/site.mjs: the addresses of all files in the site, and their hashes.

declare const FILES: readonly (readonly [url: string, integrity: string])[]
declare const VERSION: string

/** The used part of a service worker's global scope, which the DOM's types lack. */
interface Scope {
  readonly registration: ServiceWorkerRegistration
  readonly clients: { claim(): Promise<void> }
  skipWaiting(): Promise<void>
  addEventListener(name: 'install' | 'activate' | 'fetch', listener: (event: Lasting) => void): void
}

interface Lasting {
  readonly request: Request
  waitUntil(done: Promise<unknown>): void
  respondWith(response: Promise<Response>): void
}

const worker = self as unknown as Scope
const { scope } = worker.registration
// Caches are shared by all sites of an origin.
const CACHE = `${scope} ${VERSION}`

worker.addEventListener('install', (event) => event.waitUntil(install()))
worker.addEventListener('activate', (event) => event.waitUntil(activate()))
worker.addEventListener('fetch', (event) => {
  const { method, url } = event.request
  if (method === 'GET' && url.startsWith(scope)) event.respondWith(answer(event.request))
})

async function install(): Promise<void> {
  const cache = await caches.open(CACHE)
  try {
    // Integrity checks fail while another version is being deployed.
    await cache.addAll(
      FILES.map(([url, integrity]) => new Request(new URL(url, scope), { integrity, cache: 'no-cache' })),
    )
  } catch (error) {
    await caches.delete(CACHE)
    throw error
  }
  await worker.skipWaiting()
}

async function activate(): Promise<void> {
  const ours = (await caches.keys()).filter((name) => name.startsWith(`${scope} `))
  const old = ours.filter((name) => name !== CACHE).slice(0, -1)
  for (const name of old) await caches.delete(name)
  await worker.clients.claim()
}

async function answer(request: Request): Promise<Response> {
  const cache = await caches.open(CACHE)
  const options = { ignoreSearch: true, ignoreVary: true }
  return (await cache.match(request, options)) ?? (await caches.match(request, options)) ?? fetch(request)
}
