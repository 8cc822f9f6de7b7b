// SPDX-License-Identifier: GPL-3.0-or-later
import type { View } from '../view/view.ts'
import { coveredOfPage } from './padding.ts'
import type { PageActions } from './page-actions.ts'

/** The elements that surround or cover the picture. */
const AROUND = '#figure, #top, #rail, #left > .panel, #share, #player'

/** Keeps all circles visible, if they were, and the ends of a path, when panels open and when the window resizes. */
export function arrangeAround(view: View, actions: PageActions): void {
  actions.covered = coveredOfPage
  view.covered = coveredOfPage
  let isWhole = actions.isWhole
  let padding = actions.paddingNow
  let table = view.circles
  const look = () => {
    isWhole = actions.isWhole
  }
  view.on('camera', look)
  // The camera of new circles is set before the circles arrive.
  view.on('changed', () => {
    if (view.circles === table) return
    table = view.circles
    // Waits for the caller to set the region of the new circles.
    queueMicrotask(look)
  })
  const observer = new ResizeObserver(() => {
    if (isWhole && !actions.isWhole) actions.look(undefined)
    actions.uncoverPath(padding)
    padding = actions.paddingNow
  })
  for (const element of document.querySelectorAll(AROUND)) observer.observe(element)
}
