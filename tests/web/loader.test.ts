// SPDX-License-Identifier: GPL-3.0-or-later
import { readFileSync } from 'node:fs'
import { describe, expect, it, vi } from 'vitest'
import { ERROR_CODES, type LoadOptions, loadCircleVoronoi } from '../../web/lib/index.ts'
import { compileCircleVoronoi } from '../../web/lib/wasm/load-options.ts'
import { instantiate } from '../../web/lib/wasm/wasm.ts'
import { library } from './library.ts'

const THREE = Float64Array.of(0, 0, 1, 10, 0, 2, 4, 9, 3)

describe('compute', () => {
  it('copies: neither the input nor another result changes with a diagram', () => {
    const input = THREE.slice()
    const first = library.compute(input)
    const vertices = first.vertices.slice()
    input[0] = 99
    library.compute(Float64Array.of(1, 2, 3))
    expect(first.circles).toEqual(THREE)
    expect(first.vertices).toEqual(vertices)
  })

  it.each(['auto', 'touching-disc', 'flip'] as const)('can use the method %s', (method) => {
    const diagram = library.compute(THREE, { method })
    expect(diagram.stats.method).toBe(method)
    expect(diagram.vertices).toHaveLength(3)
  })
})

describe('errors', () => {
  it('has the codes of the C++ core', async () => {
    const { default: createModule } = await import('../../web/lib/generated/circle-voronoi.js')
    const { errorCodeNames } = await instantiate(createModule, await compileCircleVoronoi({}))
    expect(errorCodeNames()).toEqual(ERROR_CODES)
  })
})

describe('progress', () => {
  it('tells the stages in order and a growing part of the event loop', () => {
    // A square grid with unequal radii, large enough that the event loop reports progress.
    const circles = Array.from({ length: 22_500 }, (_, i) => ({ x: i % 150, y: Math.floor(i / 150), r: (i % 7) / 20 }))
    const told: [string, number][] = []
    const { stats } = library.compute(circles, {
      method: 'touching-disc',
      progress: (stage, done) => told.push([stage, done]),
    })
    const stages = [...new Set(told.map(([stage]) => stage))]
    expect(stages).toEqual(['order', 'triangulate', 'sample', 'pair', 'touch', 'certify', 'assemble'])
    expect(Object.keys(stats.seconds)).toEqual(expect.arrayContaining(stages))
    const touched = told.filter(([stage]) => stage === 'touch').map(([, done]) => done)
    expect(touched[0]).toBe(0)
    expect(touched.length).toBeGreaterThan(2)
    expect(touched).toEqual(touched.toSorted((a, b) => a - b))
    expect(touched.at(-1)).toBeLessThanOrEqual(1)
  })

  it('throws what the callback throws, once, and goes on working', () => {
    let calls = 0
    const progress = () => {
      calls += 1
      throw new RangeError('mine')
    }
    expect(() => library.compute(THREE, { progress })).toThrow(new RangeError('mine'))
    expect(calls).toBe(1)
    expect(library.compute(THREE).certificate.certified).toBe(true)
  })
})

describe('the WebAssembly', () => {
  const file = new URL('../../web/lib/generated/circle-voronoi.wasm', import.meta.url)
  const bytes = readFileSync(file)
  const response = (type: string) => new Response(bytes, { headers: { 'Content-Type': type } })

  it.each<[string, () => LoadOptions['wasm']]>([
    ['a URL', () => file],
    ['an address', () => file.href],
    ['bytes', () => bytes],
    ['an ArrayBuffer', () => new Uint8Array(bytes).buffer],
    ['a module', () => new WebAssembly.Module(bytes)],
    ['a response', () => response('application/wasm')],
    ['a response of another type', () => response('application/octet-stream')],
    ['a response of a type with parameters', () => response('application/wasm; charset=utf-8')],
    ['a response without a type', () => new Response(bytes)],
    ['a promise of any of them', () => Promise.resolve(response('application/wasm'))],
  ])('loads from %s', async (_, wasm) => {
    const loaded = await loadCircleVoronoi({ wasm: wasm() as NonNullable<LoadOptions['wasm']> })
    expect(loaded.compute(THREE).certificate.certified).toBe(true)
  })

  it('fetches a file where the platform has no node:fs', async () => {
    vi.spyOn(process, 'getBuiltinModule').mockReturnValue(undefined as never)
    const fetched: string[] = []
    vi.stubGlobal('fetch', async (url: URL) => {
      fetched.push(url.href)
      return response('application/wasm')
    })
    try {
      expect((await loadCircleVoronoi({ wasm: file })).compute(THREE).certificate.certified).toBe(true)
    } finally {
      vi.restoreAllMocks()
      vi.unstubAllGlobals()
    }
    expect(fetched).toEqual([file.href])
  })

  it('has an address relative to the page, or to the location of a worker', async () => {
    const fetched: string[] = []
    vi.stubGlobal('fetch', async (url: URL) => {
      fetched.push(url.href)
      return response('application/wasm')
    })
    const compile = vi.spyOn(WebAssembly, 'compileStreaming')
    vi.stubGlobal('location', { href: 'https://example.org/a/worker.js' })
    await loadCircleVoronoi({ wasm: 'x.wasm' })
    vi.stubGlobal('document', { baseURI: 'https://example.org/b/page.html' })
    await loadCircleVoronoi({ wasm: 'x.wasm' })
    vi.unstubAllGlobals()
    expect(fetched).toEqual(['https://example.org/a/x.wasm', 'https://example.org/b/x.wasm'])
    expect(compile).toHaveBeenCalledTimes(2)
    compile.mockRestore()
  })

  it('is apart for each of two loads at a time', async () => {
    const [one, two] = await Promise.all([loadCircleVoronoi(), loadCircleVoronoi()])
    expect(one).not.toBe(two)
    const inOne = () => one.compute(THREE, { progress: () => expect(two.compute(THREE).vertices).toHaveLength(3) })
    expect(inOne().vertices).toHaveLength(3)
  })

  it.each<[string, () => LoadOptions['wasm'], string]>([
    ['a missing file', () => new URL('missing.wasm', file), `loaded from ${new URL('missing.wasm', file)}: `],
    ['an answer that is none', () => new Response('', { status: 404, statusText: 'Not Found' }), '404 Not Found'],
    ['an answer of a server that gives no words', () => new Response('', { status: 503 }), 'the answer is 503.'],
    ['bytes that are none', () => Uint8Array.of(1, 2, 3, 4), 'what was given'],
    ['another module', () => Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0), 'this module'],
    ['no address', () => 'circle-voronoi.wasm', 'what was given'],
    ['a fetch that failed', () => Promise.reject(new Error('offline')), 'offline'],
  ])('refuses %s', async (_, wasm, words) => {
    const error = await loadCircleVoronoi({ wasm: wasm() as NonNullable<LoadOptions['wasm']> }).then(
      () => undefined,
      (reason) => reason,
    )
    expect(error).toMatchObject({ name: 'CircleVoronoiError', code: 'notLoaded', circle: undefined })
    expect(error.message).toContain(words)
    expect(error.message).toMatch(/[^.]\.$/)
    expect(error.cause).toBeInstanceOf(Error)
  })
})

describe('resample', () => {
  it('makes the touching disc method right where samples are too few', () => {
    // Equal circles around one point, where rounding alone disorders zero-length edges.
    const circles = Float64Array.from({ length: 36 }, (_, i) => {
      const angle = (Math.floor(i / 3) * Math.PI) / 6
      return [10 * Math.cos(angle), 10 * Math.sin(angle), 1][i % 3] as number
    })
    const options = { method: 'touching-disc' } as const
    expect(library.compute(circles, { ...options, resample: true }).certificate.certified).toBe(true)
  })
})
