// SPDX-License-Identifier: GPL-3.0-or-later
import { mountPlayer, type Player, type PlayerPlace } from '../../../web/player/player.ts'
import { boundingBox, fitted } from '../../../web/view/camera.ts'
import { mount } from '../../../web/view/mount.ts'
import { createStore } from '../../../web/view/store.ts'
import type { View } from '../../../web/view/view.ts'
import { initialView } from '../../../web/view/view-state.ts'

const circles = Float64Array.of(0, 0, 2, 10, 1, 1, 5, 8, 1.5, 2, 6, 0.8, 9, 6, 2.2, 6, 3, 0.6, 12, 10, 1)
const by = (id: string) => document.getElementById(id) as HTMLElement
const store = createStore(initialView())
const view = mount(by('figure'), store)
view.setCamera(fitted(boundingBox(circles), view.size, { top: 16, right: 16, bottom: 16, left: 16 }))
await view.scene.open(circles)
const seen: number[] = []
/** The step, which belongs to the page. */
let place: PlayerPlace = { step: 0 }
const play = (options = {}, step = 0) => {
  place = { step }
  const go = (next: number, stage?: string) => {
    place = { step: next, stage }
  }
  return mountPlayer(by('player'), { view, options, place: () => place, go, onstep: (k) => seen.push(k) })
}
const stepTo = (step: number) => {
  place = { step }
  playing.player.follow()
}

/** The interface of the page for the test. */
export interface PlayerPage {
  view: View
  select(ids: readonly number[]): void
  player: Player
  seen: number[]
  play: typeof play
  stepOf(): number | undefined
  stepTo(step: number): void
}

const select = (selection: readonly number[]) => store.update((state) => ({ ...state, selection }))
const playing: PlayerPage = { view, select, seen, play, player: play(), stepOf: () => place.step, stepTo }
Object.assign(globalThis, { playing })
