// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, type TemplateResult } from 'lit/html.js'
import type { Editing } from '../../editing/editing.ts'
import type { State } from '../../editing/state.ts'
import { icon } from '../../player/icon.ts'
import { ASK, CARD, CHAIN, CODE, FILM, PICTURE, PRINT, SEND } from '../../view/icons.ts'
import type { Store } from '../../view/store.ts'
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

/** Pixels of a saved picture per pixel on screen. */
const PICTURE_SCALE = 2

/** Mounts the panel for sharing. Each tile is one way to share, and describes its result. */
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
      pageActions.messages.complain((error as Error).message)
    }
    isRecording = false
    draw()
  }
  /** Opens the form for a question, and moves to its text or to the button that prints it. */
  const ask = (isPrinted: boolean) => {
    if (!question.isOpen) question.toggle()
    const form = byId('make-question', HTMLElement)
    form.querySelector<HTMLElement>(isPrinted ? '[data-prints]' : 'textarea')?.focus()
  }
  const toggleQuestion = () => {
    if (question.isOpen) question.toggle()
    else ask(false)
  }
  const draw = () => {
    panel.render(
      () => html`
        <div class="tiles">
          ${tile(CHAIN, 'Link', 'Copy link', 'Opens this picture with your edits', () => copy(() => actions.copyLink(), 'The link'))}
          ${tile(PICTURE, 'Picture', 'Save a picture', 'A PNG of what you see now', () => actions.savePicture('seen', PICTURE_SCALE))}
          ${tile(
            FILM,
            isRecording ? 'Recording …' : 'Video',
            'Record a video',
            store.get().step === undefined ? 'Four seconds of breathing circles' : 'The method from start to end',
            record,
            { isDisabled: isRecording },
          )}
          ${tile(CARD, 'Card', 'Save a card', 'A picture with a title, for posts and chats', () => actions.saveCard())}
          ${tile(ASK, 'Question', 'Make a question', 'Readers drag until the answer is right', toggleQuestion, { isOpen: question.isOpen })}
          ${tile(PRINT, 'Worksheet', 'Print a worksheet', 'A question on paper, with a code to scan', () => ask(true))}
        </div>
        <h3>In your own page</h3>
        <div class="choices">
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
          ${
            'share' in navigator
              ? html`<button type="button" title="Send the link with another program" @click=${() => actions.shareLink()}>
                  ${icon(SEND)}Send
                </button>`
              : nothing
          }
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

/** A tile. Its name is read in full, and its sentence as a description. `isOpen`: whether it shows the form. */
function tile(
  picture: string,
  title: string,
  name: string,
  what: string,
  act: () => void,
  { isDisabled = false, isOpen }: { readonly isDisabled?: boolean; readonly isOpen?: boolean } = {},
): TemplateResult {
  return html`<button
    type="button"
    class="tile"
    aria-label=${name}
    aria-description=${what}
    aria-expanded=${isOpen === undefined ? nothing : String(isOpen)}
    aria-controls=${isOpen === undefined ? nothing : 'make-question'}
    ?disabled=${isDisabled}
    @click=${act}
  >
    ${icon(picture)}<b>${title}</b><small>${what}</small>
  </button>`
}
