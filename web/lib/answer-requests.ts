// SPDX-License-Identifier: GPL-3.0-or-later
import type { DiagramData } from './diagram-data.ts'
import { CircleVoronoiError, reasonOf } from './errors.ts'
import { type CircleVoronoi, circleVoronoiOf } from './library.ts'
import type { Progress } from './options.ts'
import type { Reply, Request, Start } from './worker-messages.ts'

/** What Node's parent port and the global scope of a browser's worker have in common. */
interface Port {
  onmessage: ((event: { readonly data: Start | Request }) => void) | null
  postMessage(reply: Reply, transfer?: ArrayBuffer[]): void
}

/** Computes what the client in `worker.ts` asks for, in the thread that this is called in. */
export function answerRequests(): void {
  const nodePort = globalThis.process?.getBuiltinModule?.('node:worker_threads').parentPort
  const port = (nodePort ?? globalThis) as unknown as Port
  let library: Promise<CircleVoronoi> | undefined

  port.onmessage = async ({ data }) => {
    if ('module' in data) {
      library = circleVoronoiOf(data.module)
      // Each request waits for it, and so tells of its failure.
      library.catch(() => {})
      return
    }
    const progress: Progress = (...told) => port.postMessage({ progress: told })
    const reply = await replyTo(data, library as Promise<CircleVoronoi>, progress)
    port.postMessage(reply, 'diagram' in reply ? buffersOf(reply.diagram) : [])
  }
}

async function replyTo(
  { circles, options, tellsProgress }: Request,
  library: Promise<CircleVoronoi>,
  progress: Progress,
): Promise<Reply> {
  try {
    const { compute } = await library
    return { diagram: compute(circles, tellsProgress ? { ...options, progress } : options) }
  } catch (error) {
    if (error instanceof CircleVoronoiError) {
      const { code, circle, message } = error
      return { error: { code, circle, message } }
    }
    return { error: { code: 'internal', circle: -1, message: `The computation failed: ${reasonOf(error)}.` } }
  }
}

/** The memory of all arrays of a diagram, to be handed over instead of copied. */
function buffersOf(diagram: DiagramData): ArrayBuffer[] {
  return Object.values(diagram).flatMap((value) => (ArrayBuffer.isView(value) ? [value.buffer as ArrayBuffer] : []))
}
