// SPDX-License-Identifier: GPL-3.0-or-later
// The script of a course package. It shows one link in a frame and reports to the learning management system. The
// element's script is loaded separately.
import { decodeLink } from '../lib/link.ts'
import { Frame } from './frame.ts'
import { findApi, ScormSession } from './scorm.ts'

const main = document.querySelector('main') as HTMLElement
const link = main.dataset.link as string
await customElements.whenDefined('circle-voronoi')
const api = findApi(window)
const { check } = await decodeLink(link)
const session = api && new ScormSession(api, check !== undefined)
window.addEventListener('pagehide', () => session?.finish())
const frame = new Frame(main, {
  load: async (dataSet) => {
    throw new Error(`There is no data set "${dataSet}" here.`)
  },
  tell: (message) => session?.tell(message),
})
await frame.open(link)
if (session !== undefined && session.suspended !== '') {
  const { circles } = await decodeLink(session.suspended).catch(() => ({ circles: undefined }))
  session.markRestored()
  if (circles !== undefined) frame.restore(circles)
}
