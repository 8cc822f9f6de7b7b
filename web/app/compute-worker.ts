// SPDX-License-Identifier: GPL-3.0-or-later
import { CircleVoronoiError, type DiagramData, loadCircleVoronoi } from '../lib/index.ts'

/** What comes back for the circles of one message. */
export type Reply = { readonly diagram: DiagramData } | { readonly problem: string }

const library = loadCircleVoronoi()

addEventListener('message', async ({ data }: MessageEvent<Float64Array>) => {
  postMessage(await replyTo(data))
})

async function replyTo(circles: Float64Array): Promise<Reply> {
  try {
    return { diagram: (await library).compute(circles) }
  } catch (error) {
    if (error instanceof CircleVoronoiError) return { problem: error.message }
    return { problem: `The computation could not run: ${error instanceof Error ? error.message : error}` }
  }
}
