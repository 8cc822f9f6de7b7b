// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Starts the module worker that `make` creates. If the module has another origin, which pages refuse for workers,
 * starts a worker of this name that imports `file` instead: workers may import from any origin. If `file` returns a
 * text, the worker runs this text.
 */
export function startModuleWorker(make: () => Worker, file: () => URL | string, name: string): Worker {
  try {
    return withTrustedUrls(make)
  } catch (error) {
    if (!(error instanceof DOMException && error.name === 'SecurityError')) throw error
    const source = file()
    const isModule = typeof source !== 'string'
    const script = isModule ? `import ${JSON.stringify(source.href)}` : source
    // Chromium loads no modules from a blob in a frame without an origin.
    const url =
      isModule && globalThis.origin === 'null' ? `data:text/javascript,${encodeURIComponent(script)}` : blobOf(script)
    return withTrustedUrls(() => new Worker(url, { type: isModule ? 'module' : 'classic', name }))
  }
}

/** The blobs of all scripts, which later threads read again. */
const blobs = new Map<string, string>()

function blobOf(script: string): string {
  const url = blobs.get(script) ?? URL.createObjectURL(new Blob([script], { type: 'text/javascript' }))
  blobs.set(script, url)
  return url
}

/** The part of Trusted Types that this module needs. Some browsers and TypeScript's DOM types lack it. */
interface TrustedTypes {
  createPolicy(
    name: string,
    rules: { createScriptURL(url: string): string },
  ): {
    createScriptURL(url: string): string
  }
}

/** The policy of the page: `undefined` if not created yet, `null` if the page does not allow it. */
let policy: ReturnType<TrustedTypes['createPolicy']> | null | undefined

function policyOfPage(): typeof policy {
  const { trustedTypes } = globalThis as { trustedTypes?: TrustedTypes }
  if (policy !== undefined || trustedTypes === undefined) return policy
  try {
    policy = trustedTypes.createPolicy('circle-voronoi', { createScriptURL: (url) => url })
  } catch {
    policy = null
  }
  return policy
}

/**
 * Makes a worker, also in a page that requires Trusted Types and allows the policy `circle-voronoi`. Bundlers look for
 * the plain expression `new Worker(new URL(...))`, so `Worker` itself is replaced while `make` runs.
 */
function withTrustedUrls(make: () => Worker): Worker {
  const trusted = policyOfPage()
  if (!trusted) return make()
  const { Worker: PlainWorker } = globalThis
  globalThis.Worker = new Proxy(PlainWorker, {
    construct: (_, [url, options]) => new PlainWorker(trusted.createScriptURL(String(url)), options),
  })
  try {
    return make()
  } finally {
    globalThis.Worker = PlainWorker
  }
}
