// SPDX-License-Identifier: GPL-3.0-or-later
// Both ends of a thread: its start in a browser, and its answers. tests/wasm/worker.test.mjs runs it in Node.
import { readFileSync } from 'node:fs'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { answerRequests } from '../../web/lib/threads/answer-requests.ts'
import type { ComputeRequest, EditorCalls, Reply, Request, Start } from '../../web/lib/threads/worker-messages.ts'
import { compileCircleVoronoi } from '../../web/lib/wasm/load-options.ts'

const THREE = Float64Array.of(0, 0, 1, 10, 0, 2, 4, 9, 3)

afterEach(() => {
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

const request = (circles = THREE): ComputeRequest => ({
  circles: circles.slice() as ComputeRequest['circles'],
  options: {},
  tellsProgress: false,
})

describe('what a thread answers', () => {
  const module = compileCircleVoronoi({})

  /** A stub of a thread's port that records messages. */
  function answering() {
    const said: [reply: Reply, transfer: ArrayBuffer[] | undefined][] = []
    const port = {
      onmessage: (_: { data: Start | Request | EditorCalls }): unknown => undefined,
      postMessage: (reply: Reply, transfer?: ArrayBuffer[]) => said.push([reply, transfer]),
    }
    const original = process.getBuiltinModule
    vi.spyOn(process, 'getBuiltinModule').mockImplementation(((name: string) =>
      name === 'node:worker_threads' ? { parentPort: port } : original(name)) as typeof original)
    answerRequests()
    return { said, port, ask: (data: Start | Request | EditorCalls) => port.onmessage({ data }) }
  }

  const SITES = Float64Array.of(2, 2, 0, 7, 3, 0)
  const fitting = {
    areas: Float64Array.of(1, 3),
    metric: 'circles' as const,
    shares: true,
    tolerance: 1e-9,
    maxSteps: 99,
    relax: 0,
  }
  const region = {
    points: Float64Array.of(0, 0, 10, 0, 10, 10, 0, 10),
    ringOffsets: Int32Array.of(0, 4),
    polygonOffsets: undefined,
  }
  const regions = readFileSync(new URL('../../web/lib/generated/circle-voronoi-regions.wasm', import.meta.url))
  const fitOf = async (more: object, where: object) => ({
    fit: { sites: SITES.slice(), ...fitting, ...more },
    region: undefined,
    wasm: await WebAssembly.compile(regions),
    tellsProgress: false,
    ...where,
  })

  /** The memory of all arrays in a value. The few numbers of a snapshot are copied. */
  const memoryOf = (value: unknown): unknown[] => {
    if (ArrayBuffer.isView(value)) return [value.buffer]
    const { numbers: _, ...parts } = Object(value)
    return typeof value === 'object' ? Object.values(parts).flatMap(memoryOf) : []
  }

  it.each([
    ['a diagram', async () => request()],
    ['a periodic diagram', async () => ({ ...request(), lattice: { a: [20, 0], b: [0, 20] } })],
    ['a fit', () => fitOf({}, { region })],
    ['a fit in a box', () => fitOf({ lattice: Float64Array.of(9, 0, 0, 4) }, {})],
    [
      'snapshots of an editor',
      async () => ({
        calls: [
          { method: 'edit', args: [THREE] },
          { method: 'snapshot', args: [] },
        ],
      }),
    ],
  ] as const)('is %s, with the memory of all its arrays', async (_, made) => {
    const { said, ask } = answering()
    await ask({ module: await module })
    await ask((await made()) as Request)
    expect(said).toHaveLength(1)
    const [[reply, transfer]] = said as [[Reply, ArrayBuffer[]]]
    expect('error' in reply).toBe(false)
    expect(new Set(transfer)).toEqual(new Set(memoryOf(reply)))
    expect(transfer).toHaveLength(new Set(transfer).size)
  })

  it('is a fit, though the module did not load the first time', async () => {
    const { said, ask } = answering()
    const wrong = new WebAssembly.Module(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0))
    for (const more of [{ wasm: wrong }, {}]) await ask(await fitOf({}, { region, ...more }))
    const kinds = said.map(([told]) => ('error' in told ? told.error.code : Object.keys(told)[0]))
    expect(kinds).toEqual(['notLoaded', 'fit'])
  })

  it('is what else went wrong, in one sentence', async () => {
    const { said, ask, port } = answering()
    await ask({ module: await module })
    port.postMessage = (reply, transfer) => {
      if ('progress' in reply) throw new TypeError('No clone.')
      return said.push([reply, transfer])
    }
    await ask({ ...request(), tellsProgress: true })
    const message = expect.stringContaining('No clone.')
    expect(said).toEqual([[{ error: { code: 'internal', circle: undefined, message } }, []]])
  })
})
