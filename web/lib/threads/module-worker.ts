// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * A worker that `make` makes of a module of a page; where that lies in another origin, from which a page takes no workers,
 * one of the same name that imports `file`: a worker takes modules from anywhere.
 */
export function startModuleWorker(make: () => Worker, file: () => URL, name: string): Worker {
  try {
    return make()
  } catch (error) {
    if (!(error instanceof DOMException && error.name === 'SecurityError')) throw error
    const script = `import ${JSON.stringify(file().href)}`
    const url = URL.createObjectURL(new Blob([script], { type: 'text/javascript' }))
    const worker = new Worker(url, { type: 'module', name })
    // The worker has read it once its module runs; what it says first is later.
    worker.addEventListener('message', () => URL.revokeObjectURL(url), { once: true })
    return worker
  }
}
