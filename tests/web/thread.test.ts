// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of a thread of `createWorker`, and the memory that it transfers. tests/wasm/worker.test.mjs runs it in Node.
import { readFileSync } from 'node:fs'
import { afterEach, describe, expect, it, vi } from 'vitest'
import type { FromThread, ToThread } from '../../web/lib/threads/channel.ts'
import { answerWorker } from '../../web/lib/threads/worker-answers.ts'
import { compileCircleVoronoi } from '../../web/lib/wasm/load-options.ts'

const THREE = Float64Array.of(0, 0, 1, 10, 0, 2, 4, 9, 3)

afterEach(() => {
  vi.unstubAllGlobals()
  vi.restoreAllMocks()
})

type Request = readonly [name: string, ...args: unknown[]]
const request = (): Request => ['compute', THREE.slice(), { options: {} }]

describe('what a thread answers', () => {
  const module = compileCircleVoronoi({})

  /** A stub of a thread's port that records messages. */
  function answering() {
    const said: [answer: FromThread, transfer: ArrayBuffer[]][] = []
    const port = {
      onmessage: (_: { data: ToThread }): unknown => undefined,
      postMessage: (answer: FromThread, transfer: ArrayBuffer[]) => said.push([answer, transfer]),
    }
    const original = process.getBuiltinModule
    vi.spyOn(process, 'getBuiltinModule').mockImplementation(((name: string) =>
      name === 'node:worker_threads' ? { parentPort: port } : original(name)) as typeof original)
    answerWorker()
    const ask = async ([name, ...args]: Request, tellsProgress = false) =>
      port.onmessage({ data: { id: 1, name, args, tellsProgress } })
    return { said, port, ask, start: async () => ask(['start', await module]) }
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
  const fitOf = async (more: object, where: object | undefined, wasm?: WebAssembly.Module): Promise<Request> => [
    'fitAreas',
    { sites: SITES.slice(), ...fitting, ...more },
    where,
    wasm ?? (await WebAssembly.compile(regions)),
  ]

  /** The memory of all arrays in a value. The few numbers of a snapshot are copied. */
  const memoryOf = (value: unknown): unknown[] => {
    if (ArrayBuffer.isView(value)) return [value.buffer]
    const { numbers: _, ...parts } = Object(value)
    return typeof value === 'object' ? Object.values(parts).flatMap(memoryOf) : []
  }

  it.each([
    ['a diagram', async () => [request()]],
    [
      'a periodic diagram',
      async () => [['computePeriodic', THREE.slice(), { a: [20, 0], b: [0, 20] }, { options: {} }]],
    ],
    ['a fit', async () => [await fitOf({}, region)]],
    ['a fit in a box', async () => [await fitOf({ lattice: Float64Array.of(9, 0, 0, 4) }, undefined)]],
    ['snapshots of an editor', async () => [['edit', THREE, {}], ['snapshot']]],
  ] satisfies [string, () => Promise<readonly Request[]>][])(
    'is %s, with the memory of all its arrays',
    async (_, made) => {
      const { said, ask, start } = answering()
      await start()
      for (const request of await made()) await ask(request)
      const [answer, transfer] = said.at(-1) as [{ value: object }, ArrayBuffer[]]
      expect(answer.value).toBeDefined()
      expect(new Set(transfer)).toEqual(new Set(memoryOf(answer.value)))
      expect(transfer).toHaveLength(new Set(transfer).size)
    },
  )

  it('is a fit, though the module did not load the first time', async () => {
    const { said, ask } = answering()
    const wrong = new WebAssembly.Module(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0))
    for (const wasm of [wrong, undefined]) await ask(await fitOf({}, region, wasm))
    expect(said.map(([answer]) => answer)).toMatchObject([
      { error: { code: 'notLoaded' } },
      { value: { areas: expect.anything() } },
    ])
  })

  it('is what else went wrong, in one sentence', async () => {
    const { said, ask, start, port } = answering()
    await start()
    port.postMessage = (answer, transfer) => {
      if ('progress' in answer) throw new TypeError('No clone.')
      return said.push([answer, transfer])
    }
    await ask(request(), true)
    expect(said.at(-1)).toEqual([{ id: 1, error: { code: 'internal', circle: undefined, message: 'No clone.' } }, []])
  })
})
