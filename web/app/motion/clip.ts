// SPDX-License-Identifier: GPL-3.0-or-later

import { type State, showStep } from '../../editing/state.ts'
import { streamOf } from '../../view/export.ts'
import type { Store } from '../../view/store.ts'
import type { View } from '../../view/view.ts'
import type { PageActions } from '../page-actions.ts'
import { type Film, filmed } from './film.ts'
import type { Motion } from './motion.ts'
import { BREATH } from './movements.ts'

/** Length of a film of the method, in seconds, and its steps per second. */
const PLAYED = 8
const RATE = 10

/**
 * Records a short video: of the method if it is played, from its first step to its last one, or else of circles that
 * breathe once, so that the film can be repeated. Everything is as before afterwards. `undefined` if nothing can move.
 * @throws Error if the browser cannot record video
 */
export async function recordClip(
  view: View,
  store: Store<State>,
  actions: PageActions,
  motion: Motion,
  steps: number,
): Promise<Film | undefined> {
  const { step, selection } = store.get()
  actions.selection.select([])
  try {
    if (step === undefined) {
      motion.start('breathe')
      if (!motion.isMoving) return undefined
      return await filmed(streamOf(view), BREATH).finally(() => motion.cancel())
    }
    const begin = performance.now()
    const timer = setInterval(() => {
      const share = Math.min((performance.now() - begin) / (1000 * (PLAYED - 1)), 1)
      showStep(store, Math.round(share * (steps - 1)))
    }, 1000 / RATE)
    showStep(store, 0)
    return await filmed(streamOf(view), PLAYED).finally(() => {
      clearInterval(timer)
      showStep(store, step)
    })
  } finally {
    actions.selection.select(selection)
  }
}
