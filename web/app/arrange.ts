// SPDX-License-Identifier: GPL-3.0-or-later
import type { FigureActions } from '../editing/figure-actions.ts'
import type { State } from '../editing/state.ts'
import type { Point } from '../lib/index.ts'
import type { Padding } from '../view/camera.ts'
import type { Store } from '../view/store.ts'
import type { View } from '../view/view.ts'
import { coveredOfPage } from './padding.ts'

/** The elements that surround or cover the picture. */
const AROUND = '#figure, #top, #rail, #left > .panel, #share, #player'

/** Keeps all circles visible, if they were, and the ends of a path, when panels open and when the window resizes. */
export function arrangeAround(store: Store<State>, view: View, actions: FigureActions): void {
  const { camera } = actions
  camera.covered = coveredOfPage
  view.covered = coveredOfPage
  let isWhole = camera.isWhole
  let padding = camera.covered()
  let { scene } = store.get()
  const noteIsWhole = () => {
    isWhole = camera.isWhole
  }
  view.on('camera', noteIsWhole)
  // The camera of new circles is set before the circles and their region arrive.
  store.subscribe((state) => {
    if (state.scene === scene) return
    scene = state.scene
    noteIsWhole()
  })
  const observer = new ResizeObserver(() => {
    if (isWhole && !camera.isWhole) camera.showView(undefined)
    uncoverPath(view, actions, padding)
    padding = camera.covered()
  })
  for (const element of document.querySelectorAll(AROUND)) observer.observe(element)
}

/** Moves the ends of the path that panels cover, and did not cover before, to where they are seen. */
export function uncoverPath(view: View, { camera, opening }: FigureActions, before: Padding): void {
  const { path } = view.layers
  if (path === undefined) return
  const isCovered = (end: Point) => camera.shows(end, before) && !camera.shows(end)
  const across = opening.pathAcross()
  const from = isCovered(path.from) ? across.from : path.from
  const to = isCovered(path.to) ? across.to : path.to
  if (from !== path.from || to !== path.to) view.setLayers({ path: { from, to } })
}
