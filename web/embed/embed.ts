// SPDX-License-Identifier: GPL-3.0-or-later
import { loadLinked } from '../app/data-sets.ts'
import { FilesClient } from '../app/files/files-client.ts'
import '../element/index.ts'
import { isRecord } from '../lib/base/check.ts'
import { Frame } from './frame.ts'

/** Generates families of circles. */
const files = new FilesClient()
const { parent } = window
const isFramed = parent !== window
const frame = new Frame(document.querySelector('main') as HTMLElement, {
  load: (dataSet) => loadLinked(dataSet, (recipe) => files.call('make', recipe)),
  // Any page may embed the frame. The messages contain nothing that the page has not sent.
  tell: (message) => isFramed && parent.postMessage(message, '*'),
})

function open(): Promise<void> {
  const link = document.querySelector('#open') as HTMLAnchorElement
  link.href = `./${location.hash}`
  return frame.open(location.hash)
}

window.addEventListener('hashchange', open)
window.addEventListener('message', ({ source, data }: MessageEvent<unknown>) => {
  if (isFramed && source === parent && isRecord(data) && data.type === 'circle-voronoi') frame.request(data)
})
open()
