// SPDX-License-Identifier: GPL-3.0-or-later
import { html, render } from 'lit/html.js'
import type { State } from '../../editing/state.ts'
import { icon } from '../../player/icon.ts'
import { DOWN, MINUS, MOTION, PLUS, STOP } from '../../view/icons.ts'
import type { Store } from '../../view/store.ts'
import { wholeNumber } from '../../view/whole-number.ts'
import type { FileActions } from '../files/file-actions.ts'
import type { Photo } from '../files/files-protocol.ts'
import { MOST_MOVING, type Motion } from '../motion/motion.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'

/** The smallest and the largest number of circles of a photo. */
const [LEAST, MOST] = [225, 7200]

/** The bar below a photo that has become circles: more, fewer, save, breathe. */
export function mountPhoto(store: Store<State>, actions: PageActions, files: FileActions, motion: Motion): void {
  const place = byId('photo', HTMLElement)
  let photo: Photo | undefined
  /** Whether another number of circles is being computed. */
  let isBusy = false

  const become = async (count: number) => {
    if (photo === undefined || isBusy) return
    isBusy = true
    draw()
    await files.openPhoto(photo.file, count)
    isBusy = false
    draw()
  }
  const draw = () => {
    place.hidden = photo === undefined
    if (photo === undefined) return
    const { count } = photo
    const shown = photo
    const isTooMany = count > MOST_MOVING
    render(
      html`<span class="count">${wholeNumber(count)} circles</span>
        <button type="button" ?disabled=${isBusy || count / 2 < LEAST} @click=${() => become(count / 2)}>
          ${icon(MINUS)}Fewer
        </button>
        <button type="button" ?disabled=${isBusy || count * 2 > MOST} @click=${() => become(count * 2)}>
          ${icon(PLUS)}More
        </button>
        <button type="button" ?disabled=${isBusy} @click=${() => files.savePhoto(shown)}>${icon(DOWN)}Save</button>
        <button
          type="button"
          ?disabled=${isBusy || isTooMany}
          aria-pressed=${motion.isMoving}
          title=${isTooMany ? `At most ${wholeNumber(MOST_MOVING)} circles can move at once` : 'Let each circle grow and shrink'}
          @click=${() => (motion.isMoving ? motion.stop() : motion.start('breathe'))}
        >
          ${icon(motion.isMoving ? STOP : MOTION)}Breathe
        </button>`,
      place,
    )
  }
  motion.onchange(draw)
  store.subscribe(({ attributes }) => {
    const now = actions.coloring.photos.get(attributes)
    if (now === photo) return
    photo = now
    draw()
  })
}
