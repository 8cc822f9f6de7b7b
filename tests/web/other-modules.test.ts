// SPDX-License-Identifier: GPL-3.0-or-later
import { afterEach, expect, it, vi } from 'vitest'
import { metricsAddress, regionsAddress } from '../../web/lib/wasm/other-wasm.ts'
import { otherModules } from '../../web/view/load.ts'

afterEach(() => vi.unstubAllGlobals())

it('modules for a thread may be bytes, a response or promises of either, and none is sent where there is none', async () => {
  const bytes = Uint8Array.of(1, 2)
  expect(await otherModules({ regionsWasm: bytes, metricsWasm: Promise.resolve(new Response(bytes)) })).toEqual({
    regionsWasm: bytes,
    metricsWasm: bytes.buffer,
  })
})

it('addresses for a thread are those that the page would resolve, also the relative URLs of Turbopack', async () => {
  vi.stubGlobal('document', { baseURI: 'https://example.org/course/' })
  /** The class of Turbopack's runtime: a URL whose text is relative. */
  class RelativeURL extends URL {
    override get href() {
      return '/media/regions.wasm'
    }
    override toString() {
      return '/media/regions.wasm'
    }
  }
  expect(
    await otherModules({ regionsWasm: new RelativeURL('x:/media/regions.wasm'), metricsWasm: 'metrics.wasm' }),
  ).toEqual({
    regionsWasm: 'https://example.org/media/regions.wasm',
    metricsWasm: 'https://example.org/course/metrics.wasm',
  })
})

it('default addresses for a thread are those of the files beside the library', () => {
  const names = [metricsAddress(), regionsAddress()].map((url) => url?.href.split('/').at(-1))
  expect(names).toEqual(['circle-voronoi-metrics.wasm', 'circle-voronoi-regions.wasm'])
})
