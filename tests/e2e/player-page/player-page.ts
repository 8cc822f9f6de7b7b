// SPDX-License-Identifier: GPL-3.0-or-later
import { mountPlayer, type Player } from '../../../web/player/player.ts'
import { boundingBox, fitted } from '../../../web/view/camera.ts'
import { mount } from '../../../web/view/mount.ts'
import type { View } from '../../../web/view/view.ts'

const circles = Float64Array.of(0, 0, 2, 10, 1, 1, 5, 8, 1.5, 2, 6, 0.8, 9, 6, 2.2, 6, 3, 0.6, 12, 10, 1)
const by = (id: string) => document.getElementById(id) as HTMLElement
const view = mount(by('figure'))
view.setCamera(fitted(boundingBox(circles), view.size, { top: 16, right: 16, bottom: 16, left: 16 }))
await view.setCircles(circles)
const seen: number[] = []
const play = (options = {}, step?: number) =>
  mountPlayer(by('player'), { view, options, step, onstep: (k) => seen.push(k) })

/** The interface of the page for the test. */
export interface PlayerPage {
  view: View
  player: Player
  seen: number[]
  play: typeof play
}

Object.assign(globalThis, { playing: { view, seen, play, player: play() } })
