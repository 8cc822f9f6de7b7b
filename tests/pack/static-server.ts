// SPDX-License-Identifier: GPL-3.0-or-later
import { readFile } from 'node:fs/promises'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { extname, join, normalize } from 'node:path'

const TYPES: Record<string, string> = {
  '.css': 'text/css',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.mjs': 'text/javascript',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
}

/** The strictest policy for a page with WebAssembly: no `eval`, nothing from other origins, no inline scripts. */
export const STRICT_POLICY = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'"
/** Allows inline scripts. */
export const INLINE_POLICY = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval' 'unsafe-inline'"

export interface Server {
  /** Ends with a slash. */
  readonly address: string
  close(): Promise<void>
}

/** Serves a folder like a plain file server, under a Content-Security-Policy and with CORS for all origins. */
export async function serve(folder: string, policy = STRICT_POLICY): Promise<Server> {
  const headersOf = (path: string) => ({
    'Access-Control-Allow-Origin': '*',
    'Content-Security-Policy': policy,
    'Content-Type': TYPES[extname(path)] ?? 'application/octet-stream',
  })
  const server = createServer(async ({ url = '/' }, response) => {
    const { pathname } = new URL(url, 'http://localhost')
    const path = normalize(pathname.endsWith('/') ? `${pathname}index.html` : pathname)
    try {
      const body = await readFile(join(folder, path))
      response.writeHead(200, headersOf(path))
      response.end(body)
    } catch {
      // Browsers request an icon on their own.
      response.writeHead(pathname === '/favicon.ico' ? 204 : 404).end()
    }
  })
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve))
  const { port } = server.address() as AddressInfo
  return {
    address: `http://127.0.0.1:${port}/`,
    close: () => {
      const closed = new Promise<void>((resolve) => server.close(() => resolve()))
      // Browsers open connections in advance. Closing would wait for idle ones.
      server.closeAllConnections()
      return closed
    },
  }
}
