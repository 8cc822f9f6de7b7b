// SPDX-License-Identifier: GPL-3.0-or-later

import { html } from 'lit/html.js'
import { streamOf } from '../../view/export.ts'
import type { View } from '../../view/view.ts'
import { save } from '../files/saving.ts'
import { filmed } from '../motion/film.ts'
import type { Motion } from '../motion/motion.ts'
import { MOVEMENTS, type MovementName } from '../motion/movements.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'
import { panelOf } from './panel.ts'

const ABOUT: Readonly<Record<MovementName, string>> = {
  bounce: 'Circles fly and bounce off one another. Neighbors in the diagram are those that may collide.',
  grow: 'All radii grow from zero and shrink again: the ordinary Voronoi diagram of the centers becomes that of the circles.',
  compare:
    'The ordinary diagram of the centers, the power diagram and the diagram of the circles in one picture. Without radii all three are the same; they part as the radii grow.',
  breathe: 'Each circle grows and shrinks at its own time.',
}

/** Length of a recording, in seconds. */
const RECORDED = 6

/** Animates circles, with a button that plays and stops. */
export function mountMotion(motion: Motion, view: View, actions: PageActions): void {
  let chosen: MovementName = 'bounce'
  let isRecording = false
  const record = async () => {
    if (!motion.isMoving) motion.start(chosen)
    isRecording = true
    draw()
    try {
      const { film, ending } = await filmed(streamOf(view), RECORDED)
      save(film, `circles-${chosen}${ending}`)
    } catch (error) {
      actions.messages.complain((error as Error).message)
    }
    isRecording = false
    draw()
  }
  const choose = (name: MovementName) => {
    chosen = name
    if (motion.isMoving) motion.start(name)
    draw()
  }
  const draw = () =>
    panel.render(
      () => html`
        <fieldset>
          <legend class="visually-hidden">How circles move</legend>
          ${(Object.keys(MOVEMENTS) as MovementName[]).map(
            (name) => html`
              <div class="layer">
                <label>
                  <input type="radio" name="movement" .checked=${name === chosen} @change=${() => choose(name)} />
                  <span>${MOVEMENTS[name]}</span>
                </label>
              </div>
            `,
          )}
        </fieldset>
        <p class="quiet">${ABOUT[chosen]} The diagram is computed and proven in every frame.</p>
        <div class="choices">
          <button
            type="button"
            class="primary"
            aria-pressed=${motion.isMoving}
            @click=${() => (motion.isMoving ? motion.stop() : motion.start(chosen))}
          >
            ${motion.isMoving ? 'Stop' : 'Play'}
          </button>
          <button type="button" ?disabled=${isRecording} title="Save a video of the next seconds" @click=${record}>
            ${isRecording ? 'Recording …' : `Record ${RECORDED} s`}
          </button>
        </div>
        <p class="quiet">Undo brings all circles back to where they were.</p>
      `,
    )
  motion.onchange(() => draw())
  const panel = panelOf(byId('motion', HTMLElement), 'Motion', draw, { isKept: false })
  draw()
}
