// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing } from 'lit/html.js'
import type { Editing } from '../../editing/editing.ts'
import type { State } from '../../editing/state.ts'
import type { Store } from '../../editing/store.ts'
import { icon } from '../../player/icon.ts'
import { CHAIN, CODE, SEND } from '../../view/icons.ts'
import type { View } from '../../view/view.ts'
import type { FileActions } from '../files/file-actions.ts'
import { save } from '../files/saving.ts'
import { recordClip } from '../motion/clip.ts'
import type { Motion } from '../motion/motion.ts'
import type { PageActions } from '../page-actions.ts'
import { byId } from './by-id.ts'
import { panelOf } from './panel.ts'
import { QuestionForm } from './question.ts'
import { toastCopied } from './toast.ts'

/** The panel with links and embedding code. */
export function mountShare(
  actions: FileActions,
  store: Store<State>,
  editing: Editing,
  view: View,
  pageActions: PageActions,
  motion: Motion,
  /** The number of steps of the method that is played. */
  steps: () => number,
): void {
  const copy = async (act: () => Promise<number | undefined>, what: string) => {
    const length = await act()
    if (length !== undefined) toastCopied(what, length)
  }
  let isRecording = false
  const record = async () => {
    isRecording = true
    draw()
    try {
      const clip = await recordClip(view, store, pageActions, motion, steps())
      if (clip !== undefined) save(clip.film, `circles-clip${clip.ending}`)
    } catch (error) {
      pageActions.complain((error as Error).message)
    }
    isRecording = false
    draw()
  }
  const draw = () => {
    panel.render(
      () => html`
        <p>A link or code shows what you see now, with your edits.</p>
        <div class="choices">
          <button type="button" class="primary" @click=${() => copy(() => actions.copyLink(), 'The link')}>
            ${icon(CHAIN)}Copy link
          </button>
          ${
            'share' in navigator
              ? html`<button type="button" title="Send the link with another program" @click=${() => actions.shareLink()}>
                  ${icon(SEND)}Send
                </button>`
              : nothing
          }
          ${question.button()}
          <button
            type="button"
            title="Copy HTML for a frame in another page"
            @click=${() => copy(() => actions.copyEmbedCode(), 'The code')}
          >
            ${icon(CODE)}Copy embed code
          </button>
          <button
            type="button"
            title="Copy a script and a tag that show these circles in another page, without a frame"
            @click=${() => copy(() => actions.copyElementCode(), 'The code')}
          >
            ${icon(CODE)}Copy element
          </button>
          <button
            type="button"
            ?disabled=${isRecording}
            aria-label="Record a clip"
            title="Record a video of a few seconds: of the method if it is played, or else of circles that breathe"
            @click=${record}
          >
            ${isRecording ? 'Recording …' : 'Clip'}
          </button>
          <button type="button" aria-label="Save a card" title="Save a picture in the size that other sites show beside a link" @click=${() => actions.saveCard()}>
            Card
          </button>
        </div>
        ${question.body()}
      `,
    )
    question.ring(panel.isOpen)
  }
  const question = new QuestionForm(store, editing, view, actions, pageActions, draw)
  const panel = panelOf(byId('share', HTMLElement), 'Share', draw, { isKept: false, onopen: () => question.take() })
  draw()
}
