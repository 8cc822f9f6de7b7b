// SPDX-License-Identifier: GPL-3.0-or-later
import { html } from 'lit'
import type { Motion } from '../motion/motion.ts'
import { MOVEMENTS, type MovementName } from '../motion/movements.ts'
import { byId } from './by-id.ts'
import { panelOf } from './panel.ts'

const ABOUT: Readonly<Record<MovementName, string>> = {
  bounce: 'Circles fly and bounce off one another. Neighbors in the diagram are those that may collide.',
  grow: 'All radii grow from zero and shrink again: the ordinary Voronoi diagram of the centers becomes that of the circles.',
  breathe: 'Each circle grows and shrinks at its own time.',
}

/** Circles in motion, with a button that plays and stops. */
export function mountMotion(motion: Motion): void {
  let chosen: MovementName = 'bounce'
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
        </div>
        <p class="quiet">Undo brings all circles back to where they were.</p>
      `,
    )
  motion.onchange = () => draw()
  const panel = panelOf(byId('motion', HTMLElement), 'Motion', draw, { isKept: false })
  draw()
}
