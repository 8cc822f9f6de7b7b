// SPDX-License-Identifier: GPL-3.0-or-later
import type { View } from '../view/view.ts'
import type { PageActions } from './page-actions.ts'

/** What stands around the picture and covers some of it. */
const AROUND = '#figure, #top, #rail, #left > .panel, #share, #player'

/** Where all circles are seen, they are seen beside whatever is opened, and in a window of another size, too. */
export function arrangeAround(view: View, actions: PageActions): void {
  let isWhole = actions.isWhole
  let table = view.circles
  const look = () => {
    isWhole = actions.isWhole
  }
  view.on('camera', look)
  // The camera of other circles is there before they are.
  view.on('changed', () => {
    if (view.circles === table) return
    table = view.circles
    // Their region is known as soon as who set them goes on.
    queueMicrotask(look)
  })
  const observer = new ResizeObserver(() => {
    if (isWhole && !actions.isWhole) actions.look(undefined)
  })
  for (const element of document.querySelectorAll(AROUND)) observer.observe(element)
}
