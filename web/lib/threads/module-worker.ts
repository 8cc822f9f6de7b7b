// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * A worker that `make` makes of a module of a page; where that lies in another origin, from which a page takes no
 * workers,
 * one of the same name that imports `file`: a worker takes modules from anywhere. If `file` is a text, that worker runs
 * it.
 */
export function startModuleWorker(make: () => Worker, file: () => URL | string, name: string): Worker {
  try {
    return withTrustedUrls(make)
  } catch (error) {
    if (!(error instanceof DOMException && error.name === 'SecurityError')) throw error
    const source = file()
    const isModule = typeof source !== 'string'
    const script = isModule ? `import ${JSON.stringify(source.href)}` : source
    // Chromium takes no modules from a blob in a frame without an origin.
    const url =
      isModule && globalThis.origin === 'null'
        ? `data:text/javascript,${encodeURIComponent(script)}`
        : URL.createObjectURL(new Blob([script], { type: 'text/javascript' }))
    const worker = withTrustedUrls(() => new Worker(url, { type: isModule ? 'module' : 'classic', name }))
    // The worker has read the text once its module runs, before its first message.
    worker.addEventListener('message', () => URL.revokeObjectURL(url), { once: true })
    return worker
  }
}

/** The part of Trusted Types that this needs; not all browsers have it, and TypeScript's DOM types do not. */
interface TrustedTypes {
  createPolicy(
    name: string,
    rules: { createScriptURL(url: string): string },
  ): {
    createScriptURL(url: string): string
  }
}

/** `undefined`: not made yet; `null`: the page does not want it. */
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
 * the plain
 * expression `new Worker(new URL(...))`, so `Worker` itself is replaced while `make` runs.
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
