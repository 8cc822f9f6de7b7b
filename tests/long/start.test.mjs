// SPDX-License-Identifier: GPL-3.0-or-later
// `npm start` answers requests for files that are still being built once they are built.
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { after, it } from 'node:test'
import { fileURLToPath } from 'node:url'

const started = spawn(process.execPath, ['scripts/start.mjs'], {
  cwd: fileURLToPath(new URL('../..', import.meta.url)),
  env: { ...process.env, PORT: '0' },
  // A process group of its own, so that all its children can be ended with it.
  detached: true,
  stdio: ['ignore', 'pipe', 'inherit'],
})
after(() => process.kill(-started.pid))

/** Waits until the page is served. */
const address = await new Promise((resolve, reject) => {
  let output = ''
  started.stdout.setEncoding('utf8').on('data', (text) => {
    output += text
    const found = /The page is at (\S+)/.exec(output)
    if (found !== null) resolve(found[1])
  })
  started.once('close', () => reject(new Error(output)))
})

for (const [path, type] of [
  ['', 'text/html'],
  ['generated/families.js', 'text/javascript'],
  ['generated/circle-voronoi-regions.wasm', 'application/wasm'],
  ['tutorial/', 'text/html'],
  ['service-worker.js', 'text/javascript'],
]) {
  it(`has /${path}`, async () => {
    const response = await fetch(address + path)
    assert.equal(response.status, 200)
    assert.match(response.headers.get('content-type'), new RegExp(`^${type}`))
    assert.ok((await response.arrayBuffer()).byteLength > 0)
  })
}

it('has no other modules', async () => {
  const response = await fetch(`${address}generated/none.wasm`, { headers: { accept: 'application/wasm' } })
  assert.equal(response.status, 404)
})
