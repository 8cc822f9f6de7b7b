// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * A worker that `make` makes of a module of a page; where that lies in another origin, from which a page takes no workers,
 * one of the same name that imports `file`: a worker takes modules from anywhere. If `file` is a text, that worker runs it.
 */
export function startModuleWorker(make: () => Worker, file: () => URL | string, name: string): Worker {
  try {
    return make()
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
    const worker = new Worker(url, { type: isModule ? 'module' : 'classic', name })
    // The worker has read it once its module runs; what it says first is later.
    worker.addEventListener('message', () => URL.revokeObjectURL(url), { once: true })
    return worker
  }
}
