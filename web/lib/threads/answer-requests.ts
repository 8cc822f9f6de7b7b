// SPDX-License-Identifier: GPL-3.0-or-later

import { CircleVoronoiError, type PostedError, postedError, reasonOf } from '../base/errors.ts'
import type { DiagramData } from '../base/types.ts'
import { Diagram } from '../diagram/diagram.ts'
import type { DiagramEditor } from '../wasm/editor.ts'
import { type CircleVoronoi, type ComputingLibrary, circleVoronoiOf } from '../wasm/library.ts'
import type { Progress } from '../wasm/options.ts'
import type { CallResult, EditorCall, EditorCalls, Reply, Request, Start } from './worker-messages.ts'

/** What Node's parent port and the global scope of a browser's worker have in common. */
interface Port {
  onmessage: ((event: { readonly data: Start | Request | EditorCalls }) => void) | null
  postMessage(reply: Reply, transfer?: ArrayBuffer[]): void
}

/** Computes what the client in `worker.ts` asks for, in the thread that this is called in. */
export function answerRequests(): void {
  const nodePort = globalThis.process?.getBuiltinModule?.('node:worker_threads').parentPort
  const port = (nodePort ?? globalThis) as unknown as Port
  let library: Promise<ComputingLibrary> | undefined
  const answerCalls = editing()

  port.onmessage = async ({ data }) => {
    if ('module' in data) {
      library = circleVoronoiOf(data.module)
      // Each request waits for it, and so tells of its failure.
      library.catch(() => {})
      return
    }
    if ('calls' in data) {
      const results = await answerCalls(data.calls, library as Promise<ComputingLibrary>)
      const snapshots = results.flatMap((result) =>
        'value' in result && result.value instanceof Diagram ? [result.value] : [],
      )
      port.postMessage({ results }, snapshots.flatMap(buffersOf))
      return
    }
    const progress: Progress = (...told) => port.postMessage({ progress: told })
    const reply = await replyTo(data, library as Promise<ComputingLibrary>, progress)
    port.postMessage(reply, 'diagram' in reply ? buffersOf(reply.diagram) : [])
  }
}

async function replyTo(
  { circles, options, tellsProgress }: Request,
  library: Promise<ComputingLibrary>,
  progress: Progress,
): Promise<Reply> {
  try {
    const { compute } = await library
    return { diagram: compute(circles, tellsProgress ? { ...options, progress } : options) }
  } catch (error) {
    return { error: posted(error) }
  }
}

/** Answers the calls of an editor, the first of which makes it. */
function editing(): (calls: readonly EditorCall[], library: Promise<ComputingLibrary>) => Promise<CallResult[]> {
  let editor: DiagramEditor | undefined
  return (calls, library) =>
    Promise.all(
      calls.map(async ({ method, args }) => {
        try {
          const { edit } = await library
          if (method === 'edit') {
            editor = edit(...(args as Parameters<CircleVoronoi['edit']>))
            return { value: undefined }
          }
          const methods = editor as unknown as Record<string, (...args: readonly unknown[]) => unknown>
          return { value: methods[method]?.(...args) }
        } catch (error) {
          return { error: posted(error) }
        }
      }),
    )
}

function posted(error: unknown): PostedError {
  if (error instanceof CircleVoronoiError) return postedError(error)
  return { code: 'internal', circle: undefined, message: `The computation failed: ${reasonOf(error)}.` }
}

/** The memory of all arrays of a diagram, to be handed over instead of copied. */
function buffersOf(diagram: DiagramData): ArrayBuffer[] {
  return Object.values(diagram).flatMap((value) => (ArrayBuffer.isView(value) ? [value.buffer as ArrayBuffer] : []))
}
