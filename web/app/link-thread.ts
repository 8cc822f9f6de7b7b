// SPDX-License-Identifier: GPL-3.0-or-later
// What runs in the worker of `LinkWriter`.
import { CircleVoronoiError } from '../lib/errors.ts'
import { encodeLink } from '../lib/link.ts'
import type { LinkReply, LinkRequest } from './link-writer.ts'

const port = globalThis as unknown as {
  onmessage: (event: MessageEvent<LinkRequest>) => void
  postMessage(message: LinkReply): void
}

port.onmessage = async ({ data: { request, state } }) => {
  try {
    port.postMessage({ request, link: await encodeLink(state) })
  } catch (error) {
    if (!(error instanceof CircleVoronoiError)) throw error
    // There is too much for a link.
    port.postMessage({ request, link: undefined })
  }
}
